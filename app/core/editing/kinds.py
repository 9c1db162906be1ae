"""What can be done to tracks, how far it goes, and in which ways."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Final


class EditKind(Enum):
    """What is to be done."""

    SWAP = "swap"
    SPLIT = "split"
    MERGE = "merge"
    REASSIGN = "reassign"
    DELETE = "delete"
    DRAW = "draw"
    MOVE = "move"
    FLOOR = "floor"
    INTERPOLATE = "interpolate"
    FILL = "fill"
    FILL_ALL = "fill all"
    KEYFRAME = "keyframe"
    NO_KEYFRAME = "no keyframe"
    THIN = "thin"
    OCCLUDE = "occlude"
    SHOW = "show"
    REVIEW = "review"


class EditScope(Enum):
    """How far an edit goes."""

    ON = "from here on"
    RANGE = "this range"
    FRAME = "this frame"
    WHOLE = "the whole track"
    BETWEEN = "between the keyframes"
    GAP = "this gap"
    JOINED = "this frame and the gap beside it"


class LongestGap(Enum):
    """The longest gaps that are filled."""

    SHORT = 0.5
    SECOND = 1.0
    SECONDS = 3.0
    LONG = 10.0
    ANY = float("inf")

    @property
    def seconds(self) -> float:
        """How long they may be."""
        return float(self.value)


class Way(Enum):
    """How an edit is done, where there is more than one way."""

    KEEP_FIRST = "first"
    KEEP_SECOND = "second"
    KEEP_SURER = "surer"
    LINEAR = "linear"
    FLOOR = "floor"


_ANY: Final = (EditScope.ON, EditScope.RANGE, EditScope.FRAME, EditScope.WHOLE)
_STRETCH: Final = (EditScope.FRAME, EditScope.RANGE, EditScope.ON, EditScope.WHOLE)
_PATHS: Final = (Way.FLOOR, Way.LINEAR)

SCOPES: Final[Mapping[EditKind, tuple[EditScope, ...]]] = {
    EditKind.SWAP: _ANY,
    EditKind.SPLIT: (EditScope.ON,),
    EditKind.MERGE: (EditScope.WHOLE,),
    EditKind.REASSIGN: _ANY,
    EditKind.DELETE: _ANY,
    EditKind.DRAW: (EditScope.FRAME, EditScope.JOINED),
    EditKind.MOVE: (EditScope.FRAME,),
    EditKind.FLOOR: (EditScope.FRAME,),
    EditKind.INTERPOLATE: (EditScope.BETWEEN, EditScope.RANGE),
    EditKind.FILL: (EditScope.GAP,),
    EditKind.FILL_ALL: (EditScope.WHOLE,),
    EditKind.KEYFRAME: (EditScope.FRAME,),
    EditKind.NO_KEYFRAME: (EditScope.FRAME,),
    EditKind.THIN: (EditScope.RANGE, EditScope.ON, EditScope.WHOLE),
    EditKind.OCCLUDE: _STRETCH,
    EditKind.SHOW: _STRETCH,
    EditKind.REVIEW: _STRETCH,
}
"""How far each kind may go; the first is meant unless another is chosen."""

WAYS: Final[Mapping[EditKind, tuple[Way, ...]]] = {
    EditKind.MERGE: (Way.KEEP_FIRST, Way.KEEP_SECOND, Way.KEEP_SURER),
    EditKind.INTERPOLATE: _PATHS,
    EditKind.FILL: _PATHS,
    EditKind.FILL_ALL: _PATHS,
}
"""The ways of each kind that has several; a way along the floor needs to know where it is."""

OF_TWO: Final = (EditKind.SWAP, EditKind.MERGE, EditKind.REASSIGN)
"""Edits that ask for another person, or for another id."""

PLACING: Final = (EditKind.DRAW, EditKind.MOVE, EditKind.FLOOR)
"""Edits of one box or place, moved by the arrow keys."""

OF_SEVERAL: Final = (
    EditKind.MERGE,
    EditKind.DELETE,
    EditKind.FILL_ALL,
    EditKind.OCCLUDE,
    EditKind.SHOW,
    EditKind.REVIEW,
)
"""Edits that are done to everybody who is selected."""
