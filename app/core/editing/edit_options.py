"""What can be chosen of an edit: how far it goes, and in which way it is done."""

from __future__ import annotations

from enum import Enum


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


class Fill(Enum):
    """What a merge does between the two."""

    LEAVE = "leave gaps open"
    FILL = "fill between them"


Option = EditScope | Way | Fill | LongestGap
"""One of the things that can be chosen between."""
