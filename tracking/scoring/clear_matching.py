"""CLEAR MOT: who is matched with what in which frame."""

from __future__ import annotations

import numpy as np

from tracking.scoring.assignment import best_of_few, in_several, solve, stretches
from tracking.scoring.comparison import Comparison
from tracking.scoring.pairs import EPS, Candidates
from tracking.scoring.table import Flags, Floats, Integers

_LOYALTY = 1000.0
"""So much more than any similarity that last frame's partner is kept while the two still match."""


def clear_matches(comparison: Comparison) -> Candidates:
    """The matched pairs, by frame.

    In each frame last frame's partners stay together while they match; the others are assigned
    with the greatest total similarity. A frame in which one side is empty does not count as last.
    """
    pairs = comparison.pairs.some(comparison.pairs.similarity >= comparison.threshold - EPS)
    several = in_several(pairs)
    chosen = ~several
    contested = np.unique(pairs.frame[several])
    before = _frame_before(comparison, pairs, contested)
    for number, rows in stretches(pairs, contested):
        last = before[rows]
        loyal = (last >= 0) & chosen[last]
        weight = pairs.similarity[rows] + _LOYALTY * loyal
        chosen[rows] = _matched(comparison, pairs, rows, weight, several[rows], number)
    return pairs.some(chosen)


def _matched(
    comparison: Comparison,
    pairs: Candidates,
    rows: slice,
    weight: Floats,
    several: Flags,
    number: int,
) -> Flags:
    """Marks of one frame's matches; pairs that do not stand in several are."""
    asked = np.flatnonzero(several)
    truth = pairs.rows.truth[rows][asked].tolist()
    result = pairs.rows.result[rows][asked].tolist()
    best = best_of_few(truth, result, weight[asked].tolist())
    if best is None:
        return solve(pairs, rows, weight, comparison.frames, number)
    matched = ~several
    matched[asked[best]] = True
    return matched


def _frame_before(comparison: Comparison, pairs: Candidates, contested: Integers) -> Integers:
    """(k,) which pair is of the same two in the frame before a contested one; -1 for none."""
    found = np.full(len(pairs), -1)
    now = np.flatnonzero(_in_frames(pairs, contested))
    earlier = np.flatnonzero(_in_frames(pairs, contested - 1))
    if not len(earlier):
        return found
    couples = comparison.people * comparison.identities
    code = comparison.couples(pairs) + couples * pairs.frame
    there = code[earlier]
    order = np.argsort(there)
    at = np.searchsorted(there, code[now] - couples, sorter=order)
    at = order[np.minimum(at, len(order) - 1)]
    same = there[at] == code[now] - couples
    found[now[same]] = earlier[at[same]]
    return found


def _in_frames(pairs: Candidates, frames: Integers) -> Flags:
    """Marks of the pairs in some of the frames; frame -1 is nowhere."""
    asked = np.zeros(int(pairs.frame.max(initial=-1)) + 2, bool)
    asked[frames] = True
    return asked[pairs.frame]
