"""Who is who: one-to-one assignment within each frame."""

from __future__ import annotations

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.scoring.matching import Candidates, Frames
from tracking.scoring.table import Flags, Floats, Integers


def assign(pairs: Candidates, weight: Floats, frames: Frames) -> Flags:
    """Mark the pairs of the assignment with the greatest total weight in each frame.

    Only frames where a row stands in several pairs need the Hungarian method: elsewhere every
    pair is taken.

    Args:
        pairs: what may be assigned. weight: (k,) above 0. frames: the frames of the pairs.
    """
    chosen, contested = uncontested(pairs)
    for number, rows in stretches(pairs, contested):
        chosen[rows] = solve(pairs, rows, weight[rows], frames, number)
    return chosen


def uncontested(pairs: Candidates) -> tuple[Flags, Integers]:
    """Pairs in frames where no row stands in two of them, and the numbers of the other frames."""
    twice = _repeated(pairs.rows.truth) | _repeated(pairs.rows.result)
    contested = np.unique(pairs.frame[twice])
    return ~np.isin(pairs.frame, contested), contested


def stretches(pairs: Candidates, numbers: Integers) -> list[tuple[int, slice]]:
    """Where the pairs of the numbered frames stand."""
    begin = np.searchsorted(pairs.frame, numbers, "left").tolist()
    end = np.searchsorted(pairs.frame, numbers, "right").tolist()
    return [(n, slice(b, e)) for n, b, e in zip(numbers.tolist(), begin, end, strict=True)]


def solve(pairs: Candidates, rows: slice, weight: Floats, frames: Frames, number: int) -> Flags:
    """Mark, among one frame's pairs, those with the greatest total weight.

    The matrix holds all rows of the frame in their order, so that equal totals are decided as in
    other programs that hand whole frames to SciPy.
    """
    down = pairs.rows.truth[rows] - frames.truth[number]
    across = pairs.rows.result[rows] - frames.result[number]
    total = np.zeros(frames.shape(number))
    total[down, across] = weight
    partner = np.full(len(total), -1)
    matched, partners = linear_sum_assignment(total, maximize=True)
    partner[matched] = partners
    return np.asarray(partner[down] == across)


def _repeated(rows: Integers) -> Flags:
    """Marks of the entries that stand more than once."""
    return np.asarray(np.bincount(rows)[rows] > 1) if len(rows) else np.zeros(0, bool)
