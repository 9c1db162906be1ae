"""Which edit touches what: the boxes of all edits of a log, to be searched at once."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tracking.editing.log.edit_footprint import KINDS, Boxes, overlaps
from tracking.errors import EditError
from tracking.tracks import LARGEST_NUMBER, column_types

TOUCHED_COLUMNS = column_types(**dict.fromkeys(("edit", "kind", "of", "start", "end"), np.int64))
_FEWEST = 64


class TouchIndex:
    """Boxes of edits, added one edit after another; see `touched`."""

    def __init__(self) -> None:
        """No edits."""
        self._rows = np.zeros((_FEWEST, len(TOUCHED_COLUMNS)), np.int64)
        self._count = 0
        self._known: set[int] = set()

    @classmethod
    def from_columns(cls, columns: Mapping[str, NDArray[np.int64]], edits: int) -> TouchIndex:
        """The index as `columns` gave it, for a log of so many edits.

        Raises EditError where it can be none.
        """
        index = cls()
        rows = np.column_stack([columns[name] for name in TOUCHED_COLUMNS])
        edit, kind, of, start, end = rows.T
        sound = (edit >= 1) & (edit <= edits) & (kind >= 0) & (kind < KINDS)
        sound &= (of >= 0) & (of <= LARGEST_NUMBER)
        sound &= (start >= 0) & (start < end) & (end <= LARGEST_NUMBER + 1)
        if not bool(sound.all()):
            raise EditError("what the edits of the log touch is no list of tracks and frames")
        index._rows, index._count = rows, len(rows)
        index._known = set(np.unique(edit).tolist())
        return index

    @property
    def columns(self) -> dict[str, NDArray[np.int64]]:
        """`TOUCHED_COLUMNS` of all boxes, by edit: a copy."""
        rows = self._rows[: self._count]
        rows = rows[np.argsort(rows[:, 0], kind="stable")]
        return {name: rows[:, at].copy() for at, name in enumerate(TOUCHED_COLUMNS)}

    @property
    def edits(self) -> int:
        """How many edits were added."""
        return len(self._known)

    def __contains__(self, edit: object) -> bool:
        """Whether the edit was added."""
        return edit in self._known

    def add(self, edit: int, boxes: Boxes) -> None:
        """Add an edit's boxes (k, 4)."""
        stop = self._count + len(boxes)
        if stop > len(self._rows):
            grown = np.zeros((2 * stop, len(TOUCHED_COLUMNS)), np.int64)
            grown[: self._count] = self._rows[: self._count]
            self._rows = grown
        self._rows[self._count : stop, 0] = edit
        self._rows[self._count : stop, 1:] = boxes
        self._count = stop
        self._known.add(edit)

    def later(self, edit: int, boxes: Boxes) -> list[int]:
        """The edits after this one that touch one of the boxes (k, 4), ascending."""
        rows = self._rows[: self._count]
        rows = rows[rows[:, 0] > edit]
        return [int(number) for number in np.unique(rows[overlaps(boxes, *rows.T[1:]), 0])]
