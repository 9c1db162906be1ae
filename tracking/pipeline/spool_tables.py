"""Tables put aside frame by frame, and read again as they are asked for."""

from __future__ import annotations

import contextlib
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import OutputError
from tracking.pipeline.particle_codec import CODINGS, Block, Coding, Plain
from tracking.pipeline.spool import Spool
from tracking.tracks import Columns, ParticleColumn, Particles, Types
from tracking.tracks.growable_columns import FrameStarts


class SpooledColumn:
    """A column in a spool, read by slices; as a whole by `numpy.asarray`."""

    def __init__(self, spool: Spool, coding: Coding, dtype: np.dtype[Any]) -> None:
        """No rows yet."""
        self.dtype = dtype
        self._spool, self._coding = spool, coding
        self._blocks: list[Block] = []
        self._ends: list[int] = []

    def __len__(self) -> int:
        """The number of rows."""
        return self._ends[-1] if self._ends else 0

    def __getitem__(self, rows: slice) -> NDArray[Any]:
        """A stretch of rows, read-only. Raises OutputError where the disk fails."""
        start, stop, _ = slice(rows.start, rows.stop).indices(len(self))
        if stop <= start:
            return np.zeros(0, self.dtype)
        first, last = bisect_right(self._ends, start), bisect_right(self._ends, stop - 1)
        parts = [self._part(number, start, stop) for number in range(first, last + 1)]
        return parts[0] if len(parts) == 1 else np.concatenate(parts)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """The whole column."""
        return np.asarray(self[0 : len(self)], dtype)

    def append(self, values: NDArray[Any]) -> None:
        """Put further rows aside. Raises OutputError where the disk refuses."""
        if len(values):
            self._blocks.append(self._coding.put(self._spool, values))
            self._ends.append(len(self) + len(values))

    def cut(self, rows: int) -> None:
        """Forget the blocks behind the first rows, where a block ends."""
        kept = bisect_right(self._ends, rows)
        del self._blocks[kept:], self._ends[kept:]

    def as_it_is(self) -> SpooledColumn:
        """The same without what will be appended."""
        same = SpooledColumn(self._spool, self._coding, self.dtype)
        same._blocks, same._ends = self._blocks.copy(), self._ends.copy()
        return same

    def _part(self, number: int, start: int, stop: int) -> NDArray[Any]:
        """What a block holds of a stretch of the column."""
        block = self._blocks[number]
        begin = self._ends[number] - block.rows
        rows = slice(max(0, start - begin), min(block.rows, stop - begin))
        return self._coding.get(self._spool, block, rows, self.dtype)


@dataclass(frozen=True, slots=True, eq=False)
class MappedColumns(Mapping[str, NDArray[Any]]):
    """A table in a spool's file; a column takes memory only while somebody has it.

    Attributes:
        places: of each column. types: theirs. rows: how many.
    """

    spool: Spool
    places: Mapping[str, int]
    types: Types
    rows: int

    def __getitem__(self, name: str) -> NDArray[Any]:
        """A column, read-only."""
        if not self.rows:
            return np.zeros(0, self.types[name])
        size = self.rows * self.types[name].itemsize
        return np.frombuffer(self.spool.mapped(self.places[name], size), self.types[name])

    def __iter__(self) -> Iterator[str]:
        """The columns' names."""
        return iter(self.places)

    def __len__(self) -> int:
        """How many columns there are."""
        return len(self.places)


class SpooledTable:
    """One of a run's tables, growing by frames in order."""

    def __init__(self, spool: Spool, name: str, types: Types) -> None:
        """No frames yet."""
        self._spool, self._types = spool, types
        codings = CODINGS.get(name, {})
        self._columns = {
            column: SpooledColumn(spool, codings.get(column, Plain()), dtype)
            for column, dtype in types.items()
        }
        self._starts = FrameStarts()

    def extend(self, frames: Sequence[Columns]) -> None:
        """Put the rows of further frames aside. Raises OutputError where the disk refuses."""
        for name, column in self._columns.items():
            column.append(np.concatenate([frame[name] for frame in frames], dtype=column.dtype))
        first = next(iter(self._types))
        self._starts.extend([len(frame[first]) for frame in frames])

    def cut(self, frames: int) -> None:
        """Forget all but the first frames, and what was put aside of others by half."""
        rows = self._starts.cut(frames)
        for column in self._columns.values():
            column.cut(rows)

    def rows(self, first: int, stop: int) -> Columns:
        """The rows of some frames, counted from the table's first."""
        rows = self._starts.rows(first, stop)
        return {name: column[rows] for name, column in self._columns.items()}

    def columns(self) -> Columns:
        """All so far as arrays; where there are many, they stay on a disk that has room."""
        if self._spool.is_on_disk:
            with contextlib.suppress(OutputError):
                return self._mapped()
        return {name: np.asarray(column) for name, column in self._columns.items()}

    def _mapped(self) -> Columns:
        """All so far, put aside once more in one piece a column. Raises OutputError."""
        whole = ((name, np.asarray(column)) for name, column in self._columns.items())
        places = {name: self._spool.append(column.tobytes(), to_map=True) for name, column in whole}
        rows = len(next(iter(self._columns.values())))
        return MappedColumns(self._spool, places, self._types, rows)

    def particles(self, first: int, frame_count: int) -> Particles:
        """All so far as particles; in memory where they are few.

        Args:
            first: the number of the table's first frame. frame_count: of the recording.
        """
        columns: dict[str, ParticleColumn] = {
            name: column.as_it_is() if self._spool.is_on_disk else np.asarray(column)
            for name, column in self._columns.items()
        }
        return Particles(self._starts.of_recording(first, frame_count), columns)
