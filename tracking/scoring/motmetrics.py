"""Matching as py-motmetrics does it."""

from __future__ import annotations

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.arrays import Flags, Floats, Integers
from tracking.scoring.comparison import Comparison
from tracking.scoring.pairs import Candidates


def motmetrics_admitted(comparison: Comparison) -> Flags:
    """(k,) pairs no farther apart than it admits: its distance is 1 - similarity."""
    return np.asarray(1.0 - comparison.pairs.similarity <= 1.0 - comparison.threshold)


def motmetrics_matches(comparison: Comparison) -> Candidates:
    """The matched pairs, by frame, as its accumulator finds them.

    Unlike TrackEval it keeps a person with the track it was matched to last, however long ago;
    people take their tracks in the order of the frame's rows. The others are assigned so that as
    many as can be are matched, and only then by the least total distance.
    """
    pairs = comparison.pairs.some(motmetrics_admitted(comparison))
    chosen = np.zeros(len(pairs), bool)
    partner = np.full(comparison.people, -1)
    begins = np.flatnonzero(np.diff(pairs.frame, prepend=-1))
    for begin, end in zip(begins, np.append(begins, len(pairs))[1:], strict=True):
        _match_frame(comparison, pairs, slice(begin, end), partner, chosen)
    return pairs.some(chosen)


def _match_frame(
    comparison: Comparison, pairs: Candidates, rows: slice, partner: Integers, chosen: Flags
) -> None:
    """Mark one frame's matches and note everybody's new partner."""
    person = comparison.person[pairs.rows.truth[rows]]
    track = comparison.identity[pairs.rows.result[rows]]
    kept = _kept(track, partner[person])
    free = ~np.isin(person, person[kept]) & ~np.isin(track, track[kept])
    kept[free] = _assigned(comparison, pairs, np.arange(rows.start, rows.stop)[free])
    chosen[rows] = kept
    partner[person[kept]] = track[kept]


def _kept(track: Integers, partner: Integers) -> Flags:
    """Marks of the pairs that stay together: of a track that several had last, the first."""
    together = np.flatnonzero(track == partner)
    _, first = np.unique(track[together], return_index=True)
    kept = np.zeros(len(track), bool)
    kept[together[first]] = True
    return kept


def _assigned(comparison: Comparison, pairs: Candidates, free: Integers) -> Flags:
    """Marks of the pairs to be matched among those still free.

    The matrix is the whole frame's, with the same large number where nothing can be matched, so
    that equal totals are decided as there.
    """
    if not len(free):
        return np.zeros(0, bool)
    frames, number = comparison.frames, int(pairs.frame[free[0]])
    down = pairs.rows.truth[free] - frames.truth[number]
    across = pairs.rows.result[free] - frames.result[number]
    distance = 1.0 - pairs.similarity[free]
    shape = frames.shape(number)
    total = np.full(shape, _prohibitive(distance, min(shape)))
    total[down, across] = distance
    partner = np.full(shape[0], -1)
    matched, partners = linear_sum_assignment(total)
    partner[matched] = partners
    return np.asarray(partner[down] == across)


def _prohibitive(distance: Floats, most: int) -> float:
    """So large that one pair more is worth any distance."""
    return 2.0 * most * (float(np.abs(distance).max()) + 1.0) + 1.0
