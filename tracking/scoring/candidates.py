"""Which rows of a frame are at all alike: found in blocks that stay in the processor's cache."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tracking.scoring.matching import Match
from tracking.scoring.pairs import Candidates, Frames, Rows
from tracking.scoring.table import Floats, Integers, ScoringTable

_PAIRS_AT_ONCE = 1 << 15
_SIMILARITIES_AT_ONCE = 1 << 16


@dataclass(frozen=True, slots=True, eq=False)
class _Spans:
    """How far the rows of a table reach, with an unreachable row behind the last.

    Attributes:
        low, high: (n + 1,).
    """

    low: Floats
    high: Floats

    @classmethod
    def of(cls, table: ScoringTable, match: Match) -> _Spans:
        low, high = match.reach(table)
        return cls(np.append(low, np.inf), np.append(high, -np.inf))


def candidates(
    truth: ScoringTable, result: ScoringTable, frames: Frames, match: Match
) -> Candidates:
    """All pairs within a frame whose similarity is above 0."""
    spans = _Spans.of(truth, match), _Spans.of(result, match)
    near = [_near(*spans, frames, block) for block in _blocks(frames)]
    rows = Rows(_joined([one.truth for one in near]), _joined([one.result for one in near]))
    similarity = _similarities(truth, result, rows, match)
    kept = similarity > 0
    rows = Rows(rows.truth[kept], rows.result[kept])
    number = np.searchsorted(frames.truth, rows.truth, "right") - 1
    return Candidates(rows, similarity[kept], number)


def _joined(parts: list[Integers]) -> Integers:
    return np.concatenate([np.zeros(0, np.int64), *parts])


def _blocks(frames: Frames) -> Iterator[slice]:
    """Frames in stretches whose pairs, all as many as the fullest frame's, are bounded."""
    truth = (frames.truth_end - frames.truth).tolist()
    result = (frames.result_end - frames.result).tolist()
    begin = most_truth = most_result = 0
    for number, (down, across) in enumerate(zip(truth, result, strict=True)):
        most_truth, most_result = max(most_truth, down), max(most_result, across)
        if number > begin and (number + 1 - begin) * most_truth * most_result > _PAIRS_AT_ONCE:
            yield slice(begin, number)
            begin, most_truth, most_result = number, down, across
    if truth:
        yield slice(begin, len(truth))


def _near(truth: _Spans, result: _Spans, frames: Frames, block: slice) -> Rows:
    """The pairs of a block of frames whose spans meet."""
    down = _numbered(frames.truth[block], frames.truth_end[block], len(truth.low) - 1)
    across = _numbered(frames.result[block], frames.result_end[block], len(result.low) - 1)
    begins = np.maximum(truth.low[down][:, :, None], result.low[across][:, None, :])
    ends = np.minimum(truth.high[down][:, :, None], result.high[across][:, None, :])
    meet = np.flatnonzero(ends > begins)
    row, column = np.divmod(meet, across.shape[1])
    return Rows(down.ravel()[row], across[row // down.shape[1], column])


def _numbered(begin: Integers, end: Integers, beyond: int) -> Integers:
    """(frames, most) the rows of each frame, filled up with the row beyond the last."""
    row = begin[:, None] + np.arange(int((end - begin).max()))
    return np.where(row < end[:, None], row, beyond)


def _similarities(truth: ScoringTable, result: ScoringTable, rows: Rows, match: Match) -> Floats:
    """(k,) a bounded number of them at a time."""
    found = np.empty(len(rows.truth))
    for begin in range(0, len(found), _SIMILARITIES_AT_ONCE):
        part = slice(begin, begin + _SIMILARITIES_AT_ONCE)
        found[part] = match.similarity(truth, result, Rows(rows.truth[part], rows.result[part]))
    return found
