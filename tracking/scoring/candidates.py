"""Which rows of a frame are at all alike: found in blocks that stay in the processor's cache."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tracking.arrays import Floats, Integers
from tracking.errors import FormatError
from tracking.scoring.pairs import Candidates, Frames, Rows
from tracking.scoring.similarity import Match
from tracking.scoring.table import ScoringTable

_PAIRS_AT_ONCE = 1 << 17
_MOST_OF_A_FRAME = 1 << 24
"""Four thousand people and as many tracks: more is a mistake in the file, and fills the memory."""


def candidates(
    truth: ScoringTable, result: ScoringTable, frames: Frames, match: Match
) -> Candidates:
    """All pairs within a frame whose similarity is above 0.

    Raises:
        FormatError: a frame holds more rows than can be compared.
    """
    _refuse_overfull(truth, frames)
    found = [_alike(truth, result, frames, match, block) for block in _blocks(frames)]
    return Candidates(
        Rows(
            _joined([one.rows.truth for one in found]),
            _joined([one.rows.result for one in found]),
        ),
        np.concatenate([np.zeros(0), *(one.similarity for one in found)]),
        _joined([one.frame for one in found]),
    )


def _refuse_overfull(truth: ScoringTable, frames: Frames) -> None:
    down, across = frames.truth_end - frames.truth, frames.result_end - frames.result
    if len(down) and (down * across).max() > _MOST_OF_A_FRAME:
        fullest = int((down * across).argmax())
        raise FormatError(
            "frame {frame} (from 0) has {down:,} rows in the ground truth and {across:,} in "
            "the result, too many to compare: check both",
            frame=truth.frame[frames.truth[fullest]],
            down=down[fullest],
            across=across[fullest],
        )


def _alike(
    truth: ScoringTable, result: ScoringTable, frames: Frames, match: Match, block: slice
) -> Candidates:
    """The pairs of a block of frames that are at all alike."""
    own, first_truth, first_result = frames.block(block)
    a = match.measured(truth.rows(slice(first_truth, first_truth + int(own.truth_end[-1]))))
    b = match.measured(result.rows(slice(first_result, first_result + int(own.result_end[-1]))))
    rows, number = _near(_spans(a), _spans(b), own)
    similarity = match.similarity(a, b, rows)
    alike = np.flatnonzero(similarity > 0)
    rows = Rows(rows.truth[alike] + first_truth, rows.result[alike] + first_result)
    return Candidates(rows, similarity[alike], number[alike] + block.start)


def _joined(parts: list[Integers]) -> Integers:
    return np.concatenate([np.zeros(0, np.int64), *parts])


def _spans(measured: Floats) -> Floats:
    """(2, n + 1) how far the rows reach, with one that meets none behind the last."""
    return np.hstack([measured[:2], [[np.inf], [-np.inf]]])


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


def _near(truth: Floats, result: Floats, frames: Frames) -> tuple[Rows, Integers]:
    """The pairs of some frames whose spans meet, and the numbers of their frames."""
    down = _numbered(frames.truth, frames.truth_end, truth.shape[1] - 1)
    across = _numbered(frames.result, frames.result_end, result.shape[1] - 1)
    meet = truth[0][down][:, :, None] < result[1][across][:, None, :]
    meet &= result[0][across][:, None, :] < truth[1][down][:, :, None]
    at = np.flatnonzero(meet)
    row = at // across.shape[1]
    number = row // down.shape[1]
    return Rows(down.ravel()[row], across[number, at - row * across.shape[1]]), number


def _numbered(begin: Integers, end: Integers, beyond: int) -> Integers:
    """(frames, most) the rows of each frame, filled up with the row beyond the last."""
    row = begin[:, None] + np.arange(int((end - begin).max()))
    return np.where(row < end[:, None], row, beyond)
