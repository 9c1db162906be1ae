"""Edits on their way: what they are, what they would do, how that is shown before Enter."""

from app.core.editing.edit_options import EditScope, Fill, Way
from app.core.editing.edit_spec import EditSpec
from app.core.editing.flow import EditFlow, Range
from app.core.editing.initial_box import propose_initial_box, propose_initial_place
from app.core.editing.preview import (
    PlannedEdit,
    preview_change,
    preview_plan,
    preview_trails,
    rows_replaced_by,
)
from app.core.editing.preview_tracks import PreviewedTracks
from app.core.tracks.edit_context import EditContext
from app.core.tracks.recording_geometry import Place, RecordingGeometry

__all__ = [
    "EditContext",
    "EditFlow",
    "EditScope",
    "EditSpec",
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
