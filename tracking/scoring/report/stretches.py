"""Errors of one person or track in frames that follow one another, taken together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats, Integers


@dataclass(frozen=True, slots=True, eq=False)
class Stretches:
    """Rows of one id in frames that follow one another, by id, then frame.

    Attributes:
        who: (k,) id. start, stop: (k,) half-open range of frames.
        path: (n, 2) where the rows stand, stretch after stretch.
        first, last: (k,) half-open ranges of `path`.
    """

    who: Integers
    start: Integers
    stop: Integers
    path: Floats
    first: Integers
    last: Integers

    @classmethod
    def of(cls, frame: Integers, who: Integers, place: Floats) -> Stretches:
        """The stretches of (n,) rows, whose places are (n, 2)."""
        order = np.lexsort((frame, who))
        frame, who = frame[order], who[order]
        begins = np.ones(len(frame), bool)
        begins[1:] = (np.diff(who) != 0) | (np.diff(frame) != 1)
        first = np.flatnonzero(begins)
        last = np.append(first[1:], len(frame)) if len(first) else first
        return cls(who[first], frame[first], frame[last - 1] + 1, place[order], first, last)

    def __len__(self) -> int:
        """How many there are."""
        return len(self.who)

    def paths(self) -> list[Floats]:
        """The places of each."""
        return [self.path[a:b] for a, b in zip(self.first, self.last, strict=True)]

    def ranges_of(self, who: int) -> list[tuple[int, int]]:
        """The ranges of frames of one id, in order."""
        rows = slice(*np.searchsorted(self.who, [who, who + 1]))
        return list(zip(self.start[rows].tolist(), self.stop[rows].tolist(), strict=True))


def joined(ranges: list[tuple[int, int]], gap: float) -> list[tuple[int, int, int]]:
    """Ranges in order, those with less than a gap between them as one.

    Returns:
        start, stop and the frames that are in them, of each.
    """
    found: list[tuple[int, int, int]] = []
    for start, stop in ranges:
        if found and start - found[-1][1] < gap:
            begin, _, frames = found.pop()
            found.append((begin, stop, frames + stop - start))
        else:
            found.append((start, stop, stop - start))
    return found
