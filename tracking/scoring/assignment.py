"""Who is who: one-to-one assignment within each frame."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.arrays import Flags, Floats, Integers
from tracking.scoring.pairs import Candidates, Frames, Rows

_PAIRS_AT_ONCE = 1 << 16
_MARGIN = 1e-9
"""Of a total: what is nearer to a tie is decided by the Hungarian method."""


def assign(pairs: Candidates, weight: Floats, frames: Frames) -> Flags:
    """Mark the pairs of the assignment with the greatest total weight in each frame.

    Those that are the best of both their rows are taken, in frames where that is proved to be the
    only best assignment; elsewhere the Hungarian method decides.

    Args:
        pairs: what may be assigned. weight: (k,) above 0. frames: the frames of the pairs.
    """
    chosen = np.zeros(len(pairs), bool)
    for part in _parts(pairs.frame):
        rows = Rows(pairs.rows.truth[part], pairs.rows.result[part])
        chosen[part], wrong = _best(rows, weight[part])
        doubtful = np.unique(pairs.frame[part][wrong])
        for number, stretch in stretches(pairs, doubtful):
            chosen[stretch] = solve(pairs, stretch, weight[stretch], frames, number)
    return chosen


def _parts(frame: Integers) -> Iterator[slice]:
    """Whole frames in parts that stay in the processor's cache, or nearly so."""
    begin = 0
    while begin < len(frame):
        end = begin + _PAIRS_AT_ONCE
        if end < len(frame):
            end = int(np.searchsorted(frame, frame[end - 1], "right"))
        yield slice(begin, end)
        begin = end


def _best(rows: Rows, weight: Floats) -> tuple[Flags, Flags]:
    """Mark the pairs that are best for both rows; and those that raise a doubt about it.

    Weak duality is the proof: give both rows of each marked pair half its weight as a price. An
    assignment is worth no more than the prices of its rows if no pair is worth more than the
    prices of its two, and the marked pairs are worth exactly all prices. If every other pair is
    worth less, no other assignment is as good.
    """
    truth, result = rows.truth - rows.truth.min(), rows.result - rows.result.min()
    best = (weight == _most(truth, weight)[truth]) & (weight == _most(result, weight)[result])
    price_of_truth = np.bincount(truth, 0.5 * weight * best)
    price_of_result = np.bincount(result, 0.5 * weight * best)
    worth_less = weight * (1.0 + _MARGIN) < price_of_truth[truth] + price_of_result[result]
    # Where a row has two pairs of equal weight their prices add up: neither stands for sure.
    several = (np.bincount(truth, best)[truth] > 1) | (np.bincount(result, best)[result] > 1)
    return best, np.where(best, several, ~worth_less)


def _most(rows: Integers, weight: Floats) -> Floats:
    """The greatest weight by row."""
    most = np.zeros(int(rows.max()) + 1)
    np.maximum.at(most, rows, weight)
    return most


def in_several(pairs: Candidates) -> Flags:
    """(k,) one of the pair's rows stands in another pair too."""
    return _repeated(pairs.rows.truth) | _repeated(pairs.rows.result)


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


def best_of_few(truth: list[int], result: list[int], weight: list[float]) -> list[int] | None:
    """Of one frame's pairs those of the only best assignment; None where that is not evident.

    The proof is the one of `assign`, without arrays: they are slower for a handful of pairs.
    """
    by_truth: dict[int, float] = {}
    by_result: dict[int, float] = {}
    for row, column, worth in zip(truth, result, weight, strict=True):
        by_truth[row] = max(by_truth.get(row, 0.0), worth)
        by_result[column] = max(by_result.get(column, 0.0), worth)
    pairs = list(enumerate(zip(truth, result, weight, strict=True)))
    best = [n for n, (row, column, worth) in pairs if worth == by_truth[row] == by_result[column]]
    price_of_truth = {truth[n]: 0.5 * weight[n] for n in best}
    price_of_result = {result[n]: 0.5 * weight[n] for n in best}
    if len(price_of_truth) < len(best) or len(price_of_result) < len(best):
        return None
    marked = set(best)
    for n, (row, column, worth) in pairs:
        prices = price_of_truth.get(row, 0.0) + price_of_result.get(column, 0.0)
        if n not in marked and worth * (1.0 + _MARGIN) >= prices:
            return None
    return best
