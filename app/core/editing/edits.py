"""All kinds of edits; each is declared beside what plans it."""

from __future__ import annotations

from typing import Final

from app.core.editing import box_edits, identity_edits, mark_edits
from app.core.editing.box_edits import (
    DRAW,
    FILL,
    FILL_ALL,
    FLOOR,
    INTERPOLATE,
    KEYFRAME,
    MOVE,
    NO_KEYFRAME,
    PROPAGATE,
    PUT,
    THIN,
)
from app.core.editing.edit_spec import EditSpec
from app.core.editing.identity_edits import DELETE, MERGE, REASSIGN, SPLIT, SWAP
from app.core.editing.mark_edits import OCCLUDE, REVIEW, SHOW

__all__ = [
    "DELETE",
    "DRAW",
    "EDITS",
    "FILL",
    "FILL_ALL",
    "FLOOR",
    "INTERPOLATE",
    "KEYFRAME",
    "MERGE",
    "MOVE",
    "NO_KEYFRAME",
    "OCCLUDE",
    "PROPAGATE",
    "PUT",
    "REASSIGN",
    "REVIEW",
    "SHOW",
    "SPLIT",
    "SWAP",
    "THIN",
    "edit_named",
]

EDITS: Final = (*identity_edits.EDITS, *box_edits.EDITS, *mark_edits.EDITS)


def edit_named(name: str) -> EditSpec:
    """The kind of edit of a name. Raises KeyError where there is none."""
    return {spec.name: spec for spec in EDITS}[name]
