"""Edits on their way: what they are, what they would do, how that is shown before Enter."""

from app.presenters.correcting.beginning import begun_box, begun_place
from app.presenters.correcting.flow import EditFlow, Fill, Range
from app.presenters.correcting.footing import Footing, Place
from app.presenters.correcting.ground import Ground
from app.presenters.correcting.kinds import (
    OF_SEVERAL,
    OF_TWO,
    PLACING,
    SCOPES,
    EditKind,
    Reach,
    Way,
)
from app.presenters.correcting.preview import (
    PlannedEdit,
    planned_edit,
    preview_trails,
    replaced_rows,
    shown_edit,
)
from app.presenters.correcting.previewed import PreviewedTracks

__all__ = [
    "OF_SEVERAL",
    "OF_TWO",
    "PLACING",
    "SCOPES",
    "EditFlow",
    "EditKind",
    "Fill",
    "Footing",
    "Ground",
    "Place",
    "PlannedEdit",
    "PreviewedTracks",
    "Range",
    "Reach",
    "Way",
    "begun_box",
    "begun_place",
    "planned_edit",
    "preview_trails",
    "replaced_rows",
    "shown_edit",
]
