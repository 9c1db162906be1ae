"""Columns of ten million rows that are lengthened and put in order without being copied."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.tracks.columns import Columns, Types, empty


class Growing:
    """An array that is lengthened at its end again and again, seldom copied.

    One owner: arrays it gave earlier stay as they are, since only what is behind them is written.
    """

    def __init__(self, values: NDArray[Any]) -> None:
        """Begin with an array, which is not written to."""
        self._buffer = values
        self._used = len(values)

    def with_more(self, more: NDArray[Any]) -> NDArray[Any]:
        """All values so far and these behind them: a view that is written through."""
        needed = self._used + len(more)
        if needed > len(self._buffer):
            larger = np.empty(needed + needed // 8 + 1024, self._buffer.dtype)
            larger[: self._used] = self._buffer[: self._used]
            self._buffer = larger
        self._buffer[self._used : needed] = more
        self._used = needed
        return self._buffer[:needed]

    def cut(self, length: int) -> NDArray[Any]:
        """The first values only, a view; what was behind them will be written over."""
        self._used = min(self._used, length)
        return self._buffer[: self._used]


class FrameStarts:
    """Where the rows of each frame begin in a table that grows by frames in order."""

    def __init__(self) -> None:
        """No frames yet."""
        self._growing = Growing(np.zeros(0, np.int64))
        self._starts = self._growing.with_more(np.zeros(1, np.int64))

    def extend(self, counts: Sequence[int]) -> None:
        """Further frames with so many rows each."""
        self._starts = self._growing.with_more(self._starts[-1] + np.cumsum(counts, dtype=np.int64))

    def cut(self, frames: int) -> int:
        """Forget all but the first frames; how many rows these have."""
        self._starts = self._growing.cut(frames + 1)
        return int(self._starts[-1])

    def rows(self, first: int, stop: int) -> slice:
        """The rows of some frames, counted from the table's first."""
        return slice(int(self._starts[first]), int(self._starts[stop]))

    def of_recording(self, first: int, frame_count: int) -> NDArray[np.int64]:
        """(frame_count + 1,) where the rows of each frame of a recording begin.

        Args:
            first: the number of the table's first frame.
        """
        starts = np.zeros(frame_count + 1, np.int64)
        starts[first : first + len(self._starts)] = self._starts
        starts[first + len(self._starts) :] = self._starts[-1]
        return starts


class GrowingTable:
    """A table that is lengthened by frames in order; one owner.

    Attributes:
        columns: all rows so far; what was given before stays as it is.
    """

    def __init__(self, types: Types) -> None:
        """No rows of these columns."""
        self.columns: Columns = empty(types)
        self._growing = {name: Growing(column) for name, column in self.columns.items()}
        self._starts = FrameStarts()

    def extend(self, frames: Sequence[Columns]) -> None:
        """The rows of further frames."""
        self.columns = {
            name: column.with_more(np.concatenate([frame[name] for frame in frames]))
            for name, column in self._growing.items()
        }
        self._starts.extend([len(frame["frame"]) for frame in frames])

    def rows(self, first: int, stop: int) -> Columns:
        """The rows of some frames, counted from the table's first."""
        rows = self._starts.rows(first, stop)
        return {name: column[rows] for name, column in self.columns.items()}


@dataclass(frozen=True, slots=True)
class ColumnInOrder:
    """A column whose rows are put in order as they are asked for, by slices.

    Attributes:
        read: gives the values of slots. order: the slots of all rows.
    """

    read: Callable[[NDArray[np.int64]], NDArray[Any]]
    order: NDArray[np.int64]

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.order)

    def __getitem__(self, rows: slice) -> NDArray[Any]:
        """A stretch of rows."""
        return self.read(self.order[rows])
