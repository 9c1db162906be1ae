"""What one kind of reason found: places in the footage, as columns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats

Rows = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class FlaggedPlaces:
    """Places, a row each.

    Attributes:
        kind: the reason.
        first, second: (k,) tracks it is about, the one that is spoken of first; second 0: only
            one.
        frame: (k,) when it happened.
        strength: (k,) 0 to 1, how strongly it speaks for a mistake.
        figure: (k,) the number that is said in words: metres, seconds, ...
    """

    kind: str
    first: Rows
    second: Rows
    frame: Rows
    strength: Floats
    figure: Floats

    def __len__(self) -> int:
        """The number of places."""
        return len(self.frame)

    def some(self, chosen: NDArray[np.bool_] | Rows) -> FlaggedPlaces:
        """Some of the places."""
        return FlaggedPlaces(
            self.kind,
            self.first[chosen],
            self.second[chosen],
            self.frame[chosen],
            self.strength[chosen],
            self.figure[chosen],
        )


def of_pairs(
    kind: str, one: Rows, other: Rows, frame: Rows, strength: Floats, figure: Floats
) -> FlaggedPlaces:
    """Places of two tracks each; those without strength are left out."""
    kept = strength > 0.0
    strength = np.minimum(strength[kept], 1.0)
    return FlaggedPlaces(kind, one[kept], other[kept], frame[kept], strength, figure[kept])


def of_tracks(
    kind: str, track: Rows, frame: Rows, strength: Floats, figure: Floats
) -> FlaggedPlaces:
    """Places of one track each; those without strength are left out."""
    nobody = np.zeros(len(track), np.int64)
    kept = strength > 0.0
    strength = np.minimum(strength[kept], 1.0)
    return FlaggedPlaces(kind, track[kept], nobody[kept], frame[kept], strength, figure[kept])


def join_findings(parts: Sequence[FlaggedPlaces]) -> FlaggedPlaces:
    """Places of one kind, one list behind the other."""
    columns = zip(*((p.first, p.second, p.frame, p.strength, p.figure) for p in parts), strict=True)
    return FlaggedPlaces(parts[0].kind, *(np.concatenate(column) for column in columns))


def peaks(group: Rows, frame: Rows, value: Floats, apart: int) -> Rows:
    """(k,) the rows whose value is the greatest of their group within so many frames.

    The greatest of each group is taken, what is near it left out, and so on until none is left.

    Args:
        group, frame: (n,) sorted by group, then frame.
    """
    left = np.arange(len(group))
    taken: list[Rows] = []
    while len(left):
        # Groups that fall apart in time are handled side by side.
        cut = (np.diff(group[left]) != 0) | (np.diff(frame[left]) > apart)
        number = np.concatenate(([0], np.cumsum(cut)))
        order = np.lexsort((-value[left], number))
        best = left[order[np.concatenate(([True], np.diff(number[order]) != 0))]]
        taken.append(best)
        left = left[np.abs(frame[left] - frame[best][number]) > apart]
    return np.sort(np.concatenate(taken)) if taken else left


def ramp(value: Floats, low: float, high: float) -> Floats:
    """0 up to low, 1 from high on (the other way round where high is lower), 0 for NaN."""
    return np.nan_to_num(np.clip((value - low) / (high - low), 0.0, 1.0))
