"""Edits on their way: what they are, what they would do, how that is shown before Enter."""

from app.presenters.edits.beginning import begun_box, begun_place
from app.presenters.edits.flow import EditFlow, Fill, Range
from app.presenters.edits.footing import Box, Footing, Place
from app.presenters.edits.ground import Ground
from app.presenters.edits.kinds import OF_SEVERAL, OF_TWO, PLACING, SCOPES, EditKind, Scope, Way
from app.presenters.edits.preview import (
    PlannedEdit,
    planned_edit,
    preview_trails,
    replaced_rows,
    shown_edit,
)
from app.presenters.edits.previewed import PreviewedTracks

__all__ = [
    "OF_SEVERAL",
    "OF_TWO",
    "PLACING",
    "SCOPES",
    "Box",
    "EditFlow",
    "EditKind",
    "Fill",
    "Footing",
    "Ground",
    "Place",
    "PlannedEdit",
    "PreviewedTracks",
    "Range",
    "Scope",
    "Way",
    "begun_box",
    "begun_place",
    "planned_edit",
    "preview_trails",
    "replaced_rows",
    "shown_edit",
]
