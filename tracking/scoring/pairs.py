"""Rows of truth and result put in pairs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats, Integers
from tracking.scoring.table import ScoringTable

EPS = float(np.finfo(np.float64).eps)


@dataclass(frozen=True, slots=True, eq=False)
class Rows:
    """Pairs of rows: (k,) row numbers of the truth and of the result."""

    truth: Integers
    result: Integers


@dataclass(frozen=True, slots=True, eq=False)
class Frames:
    """Where the frames that hold rows on both sides begin and end in the two tables.

    Attributes:
        truth, result: (f,) first row of a frame. truth_end, result_end: (f,) the row after.
    """

    truth: Integers
    truth_end: Integers
    result: Integers
    result_end: Integers

    @classmethod
    def shared(cls, truth: ScoringTable, result: ScoringTable) -> Frames:
        """The frames with rows on both sides, in order."""
        numbers, begin, end = _frames_of(truth)
        others, begin_there, end_there = _frames_of(result)
        _, here, there = np.intersect1d(numbers, others, assume_unique=True, return_indices=True)
        return cls(begin[here], end[here], begin_there[there], end_there[there])

    def block(self, numbers: slice) -> tuple[Frames, int, int]:
        """Some frames with rows counted from their first ones, and which rows those are."""
        truth, result = int(self.truth[numbers.start]), int(self.result[numbers.start])
        some = Frames(
            self.truth[numbers] - truth,
            self.truth_end[numbers] - truth,
            self.result[numbers] - result,
            self.result_end[numbers] - result,
        )
        return some, truth, result

    def shape(self, number: int) -> tuple[int, int]:
        """Rows of the truth and of the result in the shared frame of that number."""
        return (
            int(self.truth_end[number] - self.truth[number]),
            int(self.result_end[number] - self.result[number]),
        )


def _frames_of(table: ScoringTable) -> tuple[Integers, Integers, Integers]:
    """The numbers of a table's frames, the first row of each and the row after its last."""
    begin = np.flatnonzero(np.diff(table.frame, prepend=table.frame[:1] - 1))
    return table.frame[begin], begin, np.append(begin[1:], len(table))


@dataclass(frozen=True, slots=True, eq=False)
class Candidates:
    """Pairs of rows of the same frame that are at all alike, by frame, truth row, result row.

    Attributes:
        rows: row numbers.
        similarity: (k,) above 0.
        frame: (k,) number of the shared frame, see `Frames`.
    """

    rows: Rows
    similarity: Floats
    frame: Integers

    def __len__(self) -> int:
        """The number of pairs."""
        return len(self.similarity)

    def some(self, kept: Flags | Integers) -> Candidates:
        """The marked or numbered pairs."""
        at = np.flatnonzero(kept) if kept.dtype == bool else kept
        rows = Rows(self.rows.truth[at], self.rows.result[at])
        return Candidates(rows, self.similarity[at], self.frame[at])
