"""What an edit leaves on rows, kept so that a long log need not be read again and again."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracking.editing.core.change import Change, no_rows
from tracking.editing.core.scope import Scope
from tracking.editing.log.text import cells_in_text, stretches_in_text
from tracking.tracks import Columns, pairs_of, row_keys

Handed = tuple[int, int, int, int]
Placed = tuple[int, int, int]


@dataclass(frozen=True, slots=True, eq=False)
class Trace:
    """What one edit did to rows.

    Attributes:
        handed: rows that went from track to track: from, to, start, end; half-open frames.
        cut: the tracks that a swap or a split "from here on" parted at the edit's frame; none
            where the edit is about all it handed.
        placed: rows that were put down, new or changed: track, start, end.
        gone: `CORRECTED_COLUMNS` of the rows that it deleted.
    """

    handed: tuple[Handed, ...] = ()
    cut: tuple[int, ...] = ()
    placed: tuple[Placed, ...] = ()
    gone: Columns = field(default_factory=no_rows)

    @classmethod
    def of(cls, change: Change) -> Trace:
        """The trace of a change."""
        given, taken = change.before.stretches, change.after.stretches
        columns = (given[:, 0], taken[:, 0], given[:, 1], given[:, 2])
        handed = tuple(zip(*(column.tolist() for column in columns), strict=True))
        before, after = change.before.rows, change.after.rows
        old, new = cells_of(before), cells_of(after)
        replaced = np.isin(old, new)
        gone = {name: column[~replaced] for name, column in before.items()}
        is_cut = parts_at_its_frame(change.kind, change.scope)
        return cls(handed, _tracks_of(handed) if is_cut else (), _stretches(new), gone)

    @classmethod
    def of_texts(cls, before: str, after: str, *, is_cut: bool) -> Trace | None:
        """The trace of a change by its two sides as text, without reading more than it takes.

        is_cut: see `parts_at_its_frame`.
        None: it can be told of the change only. Raises EditError where a side is no change.
        """
        sides = (before, after)
        if not any('"rows"' in side or '"stretches"' in side for side in sides):
            return NO_TRACE
        cells = None
        if any('"rows"' in side for side in sides):
            old, cells = (cells_in_text(side) for side in sides)
            if not np.array_equal(old, cells):
                return None
        given, taken = (stretches_in_text(side) for side in sides)
        handed = tuple((one[0], to[0], *one[1:]) for one, to in zip(given, taken, strict=False))
        placed = () if cells is None else _stretches(cells)
        return cls(handed, _tracks_of(handed) if is_cut else (), placed, NO_TRACE.gone)


NO_TRACE = Trace()


def cells_of(rows: Columns) -> NDArray[np.int64]:
    """(n,) track and frame of every row in one number."""
    return row_keys(rows["track"], rows["frame"])


def parts_at_its_frame(kind: str, scope: Scope | None) -> bool:
    """Whether an edit is a swap or a split "from here on": nothing is meant by what comes later."""
    return kind == "split" or (kind == "swap" and scope is not None and scope.end is None)


def _tracks_of(handed: tuple[Handed, ...]) -> tuple[int, ...]:
    return tuple({track for each in handed for track in each[:2]})


def _stretches(cells: NDArray[np.int64]) -> tuple[Placed, ...]:
    """The cells as the consecutive frames of each track."""
    if len(cells) <= 1:
        track, frame = (column.tolist() for column in pairs_of(cells))
        return tuple(zip(track, frame, (at + 1 for at in frame), strict=True))
    cells = np.unique(cells)
    first = np.flatnonzero(np.append(True, np.diff(cells) != 1))
    last = np.append(first[1:], len(cells)) - 1
    columns = (*pairs_of(cells[first]), pairs_of(cells[last])[1] + 1)
    return tuple(zip(*(column.tolist() for column in columns), strict=True))
