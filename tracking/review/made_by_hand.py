"""Which review items are about nothing but what a person made."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Flags
from tracking.review.core.evidence import Evidence, Rows
from tracking.tracks import Source


def made_by_hand(evidence: Evidence, tracks: Rows, start: Rows, end: Rows) -> Flags:
    """(k,) whether a person made every row that a review item shows of its tracks.

    Drawn, moved, kept while thinning, or interpolated between such. Where a track has no row in the
    stretch, the rows beside it count: those it ends and begins again with.

    Args:
        tracks: (k, 2), 0 for none. start, end: (k,) half-open stretches of frames.
    """
    hand = np.isin(evidence.source, (Source.PERSON, Source.INTERPOLATED))
    others = np.concatenate(([0], np.cumsum(~hand)))
    sides = [_all_hand(evidence, others, side, start, end) for side in tracks.T]
    return np.asarray(np.logical_and.reduce(sides) & (tracks > 0).any(axis=1))


def _all_hand(evidence: Evidence, others: Rows, track: Rows, start: Rows, end: Rows) -> Flags:
    """(k,) of one track each, True for track 0. others: (n + 1,) tracker's rows before each."""
    low = evidence.row_from(track, np.maximum(start, 0))
    high = np.maximum(evidence.row_from(track, np.maximum(end, 0)), low)
    padded = np.concatenate(([0], evidence.track, [0]))
    empty = low == high
    before = np.where(empty & (padded[low] == track), low - 1, low)
    after = np.where(empty & (padded[high + 1] == track), high + 1, high)
    return np.asarray((track == 0) | ((after > before) & (others[after] == others[before])))
