"""CLEAR MOT: who is matched with what in which frame."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Flags, Integers
from tracking.scoring.assignment import best_of_few, in_several, solve, stretches
from tracking.scoring.comparison import Comparison
from tracking.scoring.pairs import EPS, Candidates, Frames

_LOYALTY = 1000
"""So much more than any similarity that last frame's partner is kept while the two still match."""


def clear_matches(comparison: Comparison) -> Candidates:
    """The matched pairs, by frame.

    In each frame last frame's partners stay together while they match; the others are assigned
    with the greatest total similarity. A frame in which one side is empty does not count as last.
    """
    admitted = np.flatnonzero(comparison.pairs.similarity >= comparison.threshold - EPS)
    pairs, couple = comparison.pairs.some(admitted), comparison.couple[admitted]
    several = in_several(pairs)
    contested = np.unique(pairs.frame[several])
    before = _frame_before(pairs, couple, comparison.couples, contested)
    return pairs.some(_Matching(pairs, several, before, comparison.frames).matches(contested))


class _Matching:
    """Frames in which rows stand in several pairs, one after the other.

    Each hangs on the one before. Last frame's partners are worth more than everything else
    together, so they are matched first and the others among what is left.
    """

    def __init__(self, pairs: Candidates, several: Flags, before: Integers, frames: Frames) -> None:
        self._pairs, self._before, self._frames = pairs, before, frames
        self._chosen = ~several
        # Single values are read and written several times faster in these than in arrays.
        self._is_chosen = memoryview(self._chosen.view(np.uint8).data)
        self._own = np.flatnonzero(several)
        self._last = before[self._own].tolist()
        self._truth = pairs.rows.truth[self._own].tolist()
        self._result = pairs.rows.result[self._own].tolist()

    def matches(self, contested: Integers) -> Flags:
        """(k,) the matches of all frames; `contested` are the numbers of those in question."""
        own, frames = self._own.tolist(), self._pairs.frame[self._own]
        begin = np.searchsorted(frames, contested, "left").tolist()
        end = np.searchsorted(frames, contested, "right").tolist()
        whole = stretches(self._pairs, contested)
        for (number, rows), first, last in zip(whole, begin, end, strict=True):
            best = self._best(range(first, last)) if last - first < _LOYALTY else None
            if best is None:
                self._solve(number, rows)
                continue
            for each in best:
                self._is_chosen[own[each]] = 1
        return self._chosen

    def _best(self, asked: range) -> list[int] | None:
        """Which of a frame's pairs in question are matched; None where it is not evident."""
        last, is_chosen = self._last, self._is_chosen
        kept = [each for each in asked if last[each] >= 0 and is_chosen[last[each]]]
        truth, result = self._truth, self._result
        taken = {truth[each] for each in kept}
        taken_by = {result[each] for each in kept}
        free = [each for each in asked if truth[each] not in taken and result[each] not in taken_by]
        if len(free) < 2:
            return kept + free
        similarity = self._pairs.similarity[self._own[free]].tolist()
        best = best_of_few([truth[e] for e in free], [result[e] for e in free], similarity)
        return None if best is None else kept + [free[each] for each in best]

    def _solve(self, number: int, rows: slice) -> None:
        last = self._before[rows]
        loyal = (last >= 0) & self._chosen[last]
        weight = self._pairs.similarity[rows] + _LOYALTY * loyal
        self._chosen[rows] = solve(self._pairs, rows, weight, self._frames, number)


def _frame_before(
    pairs: Candidates, couple: Integers, couples: int, contested: Integers
) -> Integers:
    """(k,) which pair is of the same two in the frame before a contested one; -1 for none."""
    found = np.full(len(pairs), -1)
    now = np.flatnonzero(_in_frames(pairs, contested))
    earlier = np.flatnonzero(_in_frames(pairs, contested - 1))
    if not len(earlier):
        return found
    there = couple[earlier] + couples * (pairs.frame[earlier] + 1)
    wanted = couple[now] + couples * pairs.frame[now]
    order = np.argsort(there)
    at = order[np.minimum(np.searchsorted(there, wanted, sorter=order), len(order) - 1)]
    same = there[at] == wanted
    found[now[same]] = earlier[at[same]]
    return found


def _in_frames(pairs: Candidates, frames: Integers) -> Flags:
    """Marks of the pairs in some of the frames; frame -1 is nowhere."""
    asked = np.zeros(int(pairs.frame.max(initial=-1)) + 2, bool)
    asked[frames] = True
    return asked[pairs.frame]
