"""Edits on their way: what they are, what they would do, how that is shown before Enter."""

from app.presenters.correcting.edit_context import EditContext
from app.presenters.correcting.flow import EditFlow, Fill, Range
from app.presenters.correcting.initial_box import propose_initial_box, propose_initial_place
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
    preview_change,
    preview_plan,
    preview_trails,
    rows_replaced_by,
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
    "preview_change",
    "preview_plan",
    "preview_trails",
    "propose_initial_box",
    "propose_initial_place",
    "rows_replaced_by",
]
