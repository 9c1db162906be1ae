"""How people look before and after a moment, and whether two of them changed over."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Floats
from tracking.review.core.evidence import LOOKS, Evidence, Rows

_WINDOW_S = 3.0
"""How far back, and ahead, looks are averaged."""
EVERY_S = 0.1
"""Looks are compared that often: they are means over seconds."""
GUARD_S = 0.1
"""Left out next to the moment itself."""
_ALONE_M = 0.5
"""Nearer to somebody else, a region's colours may be both of theirs."""
_LEAST_VISIBLE = 0.6
_LEAST_ROWS = 3
_NOISE = np.array([[0.05], [9.0], [4.0], [4.0], [9.0], [4.0], [4.0]])
"""Height in m and CIELAB of two bodies' halves: how much one person's windows differ, even where
every row of them agrees: light and posture change from place to place."""
MOST = 9.0
"""Squared deviation of one number beyond which it says no more: outliers must not decide alone."""


@dataclass(frozen=True, slots=True, eq=False)
class Looks:
    """Running sums of what is known of each row's looks, for means over any stretch of a track.

    Attributes:
        count, total: (7, n + 1) rows that count, and the sum of their values, up to each row.
    """

    evidence: Evidence
    count: NDArray[np.int32]
    total: Floats

    @classmethod
    def of(cls, evidence: Evidence, nearest_m: Floats) -> Looks:
        """nearest_m: (n,) how far from each row the nearest other person is."""
        clean = ~evidence.predicted & (evidence.visibility >= _LEAST_VISIBLE)
        clean &= nearest_m > _ALONE_M
        count = np.zeros((len(LOOKS), len(evidence) + 1), np.int32)
        total = np.zeros((len(LOOKS), len(evidence) + 1))
        for number, values in enumerate(evidence.looks):
            known = np.isfinite(values) & clean
            np.cumsum(known, out=count[number, 1:])
            np.cumsum(np.where(known, values, np.float32(0)), out=total[number, 1:])
        return cls(evidence, count, total)

    def before(self, track: Rows, frame: Rows, guard_s: float = GUARD_S) -> Floats:
        """(7, k) mean looks of tracks in the seconds before frames; NaN where not known.

        guard_s: left out next to the frames.
        """
        window, guard = self.evidence.frames_of(_WINDOW_S), round(guard_s * self.evidence.fps)
        return self._mean(track, frame - guard - window, frame - guard)

    def after(self, track: Rows, frame: Rows, guard_s: float = GUARD_S) -> Floats:
        """(7, k) the same from the frames on."""
        window, guard = self.evidence.frames_of(_WINDOW_S), round(guard_s * self.evidence.fps)
        return self._mean(track, frame + guard, frame + guard + window)

    def _mean(self, track: Rows, start: Rows, end: Rows) -> Floats:
        low = self.evidence.row_from(track, np.maximum(start, 0))
        high = self.evidence.row_from(track, np.maximum(end, 0))
        count = self.count[:, high] - self.count[:, low]
        mean = (self.total[:, high] - self.total[:, low]) / np.maximum(count, 1)
        return np.where(count >= _LEAST_ROWS, mean, np.nan)


@dataclass(frozen=True, slots=True, eq=False)
class Sides:
    """How tracks look on both sides of moments `EVERY_S` apart.

    Attributes:
        row: (k,) of the evidence. before, after: (7, k).
    """

    row: Rows
    before: Floats
    after: Floats

    @classmethod
    def of(cls, looks: Looks) -> Sides:
        """At all such moments of all tracks."""
        evidence = looks.evidence
        row = np.flatnonzero(evidence.frame % evidence.frames_of(EVERY_S) == 0)
        track, frame = evidence.track[row], evidence.frame[row]
        return cls(row, looks.before(track, frame), looks.after(track, frame))


def unlikeness(one: Floats, other: Floats, most: float = MOST) -> Floats:
    """(k,) how unlike two looks (7, k), or (6, k) without height, are.

    The mean squared deviation in units of the usual one:
    about 1 for one person at two times; NaN where nothing is known of both. Deviations above
    `most` count as that: with all of them it tells best when looks changed, capped best whether.
    """
    squared = np.minimum(((one - other) / _NOISE[-len(one) :]) ** 2, most)
    known = np.isfinite(squared)
    total = np.where(known, squared, 0.0).sum(axis=0)
    count = known.sum(axis=0)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)


def swap_gain_of_appearance(looks: Looks, first: Rows, second: Rows, frame: Rows) -> Floats:
    """(k,) how much better two tracks' looks agree across a frame with their names changed over.

    Positive: changed over they agree better; negative: worse. Each track that is known after the
    frame votes by how much more it looks like the other before than like itself; NaN where
    neither side can be told.
    """
    a, b = looks.before(first, frame), looks.before(second, frame)
    new_a, new_b = looks.after(first, frame), looks.after(second, frame)
    votes = np.stack(
        (
            unlikeness(a, new_a) - unlikeness(b, new_a),
            unlikeness(b, new_b) - unlikeness(a, new_b),
        )
    )
    known: Flags = np.isfinite(votes)
    total = np.where(known, votes, 0.0).sum(axis=0)
    return np.where(known.any(axis=0), total, np.nan)
