"""HOTA's matching and counting."""

from __future__ import annotations

import numpy as np

from tracking.scoring.assignment import assign
from tracking.scoring.comparison import Comparison
from tracking.scoring.hota import ALPHAS, Hota
from tracking.scoring.matching import EPS, Candidates
from tracking.scoring.table import Floats, Integers


def hota(comparison: Comparison) -> Hota:
    """Match each frame once with the tracks' overall agreement as weight, then count per alpha."""
    truth, result = len(comparison.truth), len(comparison.result)
    if comparison.one_sided:
        # TrackEval counts no false positives where there are neither rows.
        return Hota.without_matches(truth, result)
    pairs = comparison.pairs
    couples, couple = np.unique(comparison.couples(pairs), return_inverse=True)
    person, identity = np.divmod(couples, comparison.identities)
    of_person = comparison.frames_of_people()[person]
    of_identity = comparison.frames_of_identities()[identity]
    both = of_person + of_identity
    agreement = _agreement(pairs, couple, both)
    chosen = assign(pairs, agreement[couple] * pairs.similarity, comparison.frames)
    counted = [chosen & (pairs.similarity >= alpha - EPS) for alpha in ALPHAS]
    matches = np.array([row.sum() for row in counted], np.float64)
    together = np.array([np.bincount(couple[row], minlength=len(couples)) for row in counted])
    alike = np.array([sum(pairs.similarity[row].tolist()) for row in counted])
    most = np.maximum(1, matches)
    return Hota(
        matches=matches,
        misses=truth - matches,
        false_positives=result - matches,
        assa_curve=_association(together, both - together) / most,
        assre_curve=_association(together, of_person) / most,
        asspr_curve=_association(together, of_identity) / most,
        loca_curve=np.maximum(1e-10, alike) / np.maximum(1e-10, matches),
    )


def _agreement(pairs: Candidates, couple: Integers, both: Integers) -> Floats:
    """How well a person and a track fit over the recording, before anything is matched.

    Args:
        couple: (k,) which person and track a pair is of. both: frames of the one plus the other.
    """
    by_person = np.bincount(pairs.rows.truth, pairs.similarity)[pairs.rows.truth]
    by_track = np.bincount(pairs.rows.result, pairs.similarity)[pairs.rows.result]
    share = pairs.similarity / (by_track + by_person - pairs.similarity)
    together = np.bincount(couple, share, minlength=len(both))
    return np.asarray(together / (both - together))


def _association(together: Integers, whole: Integers) -> Floats:
    """(19,) sum over the matches of the share their couple's matches have of the whole."""
    return np.asarray((together * (together / np.maximum(1, whole))).sum(axis=-1))
