"""Edits on their way: what they are, what they would do, how that is shown before Enter."""

from app.presenters.correcting.edit_context import EditContext
from app.presenters.correcting.flow import EditFlow, Fill, Range
from app.presenters.correcting.initial_box import begun_box, begun_place
from app.presenters.correcting.kinds import (
    OF_SEVERAL,
    OF_TWO,
    PLACING,
    SCOPES,
    EditKind,
    EditScope,
    Way,
)
from app.presenters.correcting.preview import (
    PlannedEdit,
    planned_edit,
    preview_trails,
    replaced_rows,
    shown_edit,
)
from app.presenters.correcting.preview_tracks import PreviewedTracks
from app.presenters.correcting.recording_geometry import Place, RecordingGeometry

__all__ = [
    "OF_SEVERAL",
    "OF_TWO",
    "PLACING",
    "SCOPES",
    "EditContext",
    "EditFlow",
    "EditKind",
    "EditScope",
    "Fill",
    "Place",
    "PlannedEdit",
    "PreviewedTracks",
    "Range",
    "RecordingGeometry",
    "Way",
    "begun_box",
    "begun_place",
    "planned_edit",
    "preview_trails",
    "replaced_rows",
    "shown_edit",
]
