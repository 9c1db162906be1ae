"""HOTA's matching and counting."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats, Integers
from tracking.scoring.assignment import assign
from tracking.scoring.comparison import Comparison
from tracking.scoring.hota import ALPHAS, Hota
from tracking.scoring.pairs import EPS, Candidates

_DENSE = 4
"""Couples are numbered without sorting while there are at most so many as pairs, times this."""


@dataclass(frozen=True, slots=True, eq=False)
class Couples:
    """People and tracks that are alike in some frame.

    Attributes:
        of_pair: (k,) which couple a pair is of.
        of_person, of_track: (c,) frames of the person, and of the track.
    """

    of_pair: Integers
    of_person: Integers
    of_track: Integers

    @classmethod
    def of(cls, comparison: Comparison) -> Couples:
        """The couples of a comparison's pairs."""
        if comparison.couples > _DENSE * len(comparison.couple):
            couples, of_pair = np.unique(comparison.couple, return_inverse=True)
        else:
            couples, of_pair = np.arange(comparison.couples), comparison.couple
        person, track = np.divmod(couples, comparison.identities)
        of_person = comparison.frames_of_people()[person]
        return cls(of_pair, of_person, comparison.frames_of_identities()[track])

    def __len__(self) -> int:
        """The number of couples."""
        return len(self.of_person)


def hota(comparison: Comparison) -> Hota:
    """Match each frame once with the tracks' overall agreement as weight, then count per alpha."""
    truth, result = len(comparison.truth), len(comparison.result)
    if not len(comparison.pairs):
        return Hota.without_matches(truth, result)
    pairs, couples = comparison.pairs, Couples.of(comparison)
    weight = _agreement(pairs, couples)[couples.of_pair]
    weight *= pairs.similarity
    chosen = np.flatnonzero(assign(pairs, weight, comparison.frames))
    similarity = pairs.similarity[chosen]
    # So many alphas a match counts at: the first ones.
    alphas = np.searchsorted(ALPHAS - EPS, similarity, "right")
    together, matched = _matches_of(couples, couples.of_pair[chosen], alphas)
    matches = together.sum(axis=1, dtype=np.float64)
    alike = np.bincount(alphas, similarity, len(ALPHAS) + 1)[:0:-1].cumsum()[::-1]
    most = np.maximum(1, matches)
    of_person, of_track = couples.of_person[matched], couples.of_track[matched]
    return Hota(
        matches=matches,
        misses=truth - matches,
        false_positives=result - matches,
        assa_curve=_association(together, of_person + of_track - together) / most,
        assre_curve=_association(together, of_person) / most,
        asspr_curve=_association(together, of_track) / most,
        loca_curve=np.maximum(1e-10, alike) / np.maximum(1e-10, matches),
    )


def _agreement(pairs: Candidates, couples: Couples) -> Floats:
    """(c,) how well a person and a track fit over the recording, before anything is matched."""
    # In one array: there may be millions of pairs.
    of_truth = np.bincount(pairs.rows.truth, pairs.similarity)
    share: Floats = np.asarray(of_truth[pairs.rows.truth], np.float64)
    share += np.bincount(pairs.rows.result, pairs.similarity)[pairs.rows.result]
    share -= pairs.similarity
    np.divide(pairs.similarity, share, out=share)
    together = np.bincount(couples.of_pair, share, minlength=len(couples))
    return np.asarray(together / (couples.of_person + couples.of_track - together))


def _matches_of(couples: Couples, couple: Integers, alphas: Integers) -> tuple[Integers, Integers]:
    """(19, c) matches at each alpha of the couples that have any, and (c,) which those are."""
    width = len(ALPHAS) + 1
    counted = np.bincount(couple * width + alphas, minlength=len(couples) * width)
    counted = counted.reshape(len(couples), width)[:, 1:]
    matched = np.flatnonzero(counted.any(axis=1))
    return counted[matched][:, ::-1].cumsum(axis=1)[:, ::-1].T, matched


def _association(together: Integers, whole: Integers) -> Floats:
    """(19,) sum over the matches of the share their couple's matches have of the whole."""
    return np.asarray((together * (together / np.maximum(1, whole))).sum(axis=-1))
