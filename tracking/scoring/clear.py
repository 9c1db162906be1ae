"""CLEAR MOT: misses, false positives, switches, and how long people are followed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.scoring.assignment import solve, stretches, uncontested
from tracking.scoring.comparison import Comparison
from tracking.scoring.matching import EPS, Candidates
from tracking.scoring.table import Flags, Floats, Integers

# So much more than any similarity that last frame's partner is kept while the two still match.
_LOYALTY = 1000.0
_MOSTLY_TRACKED, _MOSTLY_LOST = 0.8, 0.2


@dataclass(frozen=True, slots=True)
class Clear:
    """[Bernardin2008], counted as TrackEval counts.

    Attributes:
        mota: 1 - (misses + false positives + switches) / truth rows.
        motp: mean similarity of the matched pairs.
        id_switches: a person is matched to another track than the last time it was matched.
        fragmentations: a person is matched again after frames without a match.
        mostly_tracked: people matched in more than 80 % of their frames.
        mostly_lost: people matched in fewer than 20 %.
    """

    mota: float
    motp: float
    id_switches: int
    fragmentations: int
    false_positives: int
    misses: int
    mostly_tracked: int
    mostly_lost: int


def clear_matches(comparison: Comparison) -> Candidates:
    """The matched pairs, by frame.

    In each frame last frame's partners stay together while they match; the others are assigned
    with the greatest total similarity. A frame in which one side is empty does not count as last.
    """
    pairs = comparison.pairs.some(comparison.pairs.similarity >= comparison.threshold - EPS)
    chosen, contested = uncontested(pairs)
    code = comparison.couples(pairs)
    before = stretches(pairs, contested - 1)
    for (number, rows), (_, last) in zip(stretches(pairs, contested), before, strict=True):
        loyal = np.isin(code[rows], code[last][chosen[last]])
        weight = pairs.similarity[rows] + _LOYALTY * loyal
        chosen[rows] = solve(pairs, rows, weight, comparison.frames, number)
    return pairs.some(chosen)


def clear(comparison: Comparison, matched: Candidates) -> Clear:
    """The measures of the matched pairs."""
    if comparison.one_sided:
        return _nothing_compared(comparison)
    misses = len(comparison.truth) - len(matched)
    false_positives = len(comparison.result) - len(matched)
    switches = int(_switches(comparison, matched).sum())
    tracked = _share_tracked(comparison, matched)
    return Clear(
        mota=(len(matched) - false_positives - switches) / len(comparison.truth),
        motp=float(sum(matched.similarity.tolist())) / max(1, len(matched)),
        id_switches=switches,
        fragmentations=_fragmentations(comparison, matched),
        false_positives=false_positives,
        misses=misses,
        mostly_tracked=int((tracked > _MOSTLY_TRACKED).sum()),
        mostly_lost=int((tracked < _MOSTLY_LOST).sum()),
    )


def _nothing_compared(comparison: Comparison) -> Clear:
    return Clear(
        mota=0.0,
        motp=0.0,
        id_switches=0,
        fragmentations=0,
        false_positives=len(comparison.result),
        misses=len(comparison.truth),
        mostly_tracked=0,
        mostly_lost=comparison.people,
    )


def _by_person(comparison: Comparison, matched: Candidates) -> tuple[Integers, Integers, Flags]:
    """Matches ordered by person, then frame: their order, persons, and whether one goes on."""
    person = comparison.person[matched.rows.truth]
    order = np.argsort(person, kind="stable")
    person = person[order]
    return order, person, np.asarray(np.diff(person) == 0)


def _switches(comparison: Comparison, matched: Candidates) -> Flags:
    """Marks where a person's match bears another track than its match before."""
    order, _, same = _by_person(comparison, matched)
    track = comparison.identity[matched.rows.result][order]
    return np.asarray(same & (np.diff(track) != 0))


def _fragmentations(comparison: Comparison, matched: Candidates) -> int:
    """How often people are found again after frames (with rows on both sides) without match."""
    order, _, same = _by_person(comparison, matched)
    return int((same & (np.diff(matched.frame[order]) > 1)).sum())


def _share_tracked(comparison: Comparison, matched: Candidates) -> Floats:
    """(people,) share of each person's frames in which it is matched."""
    person = comparison.person[matched.rows.truth]
    matches = np.bincount(person, minlength=comparison.people)
    return np.asarray(matches / comparison.frames_of_people())
