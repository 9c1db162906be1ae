"""HOTA: detection and association in one balanced number, over all strictness of matching."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.scoring.assignment import assign
from tracking.scoring.comparison import Comparison
from tracking.scoring.matching import EPS, Candidates
from tracking.scoring.table import Floats, Integers

ALPHAS = np.arange(0.05, 0.99, 0.05)
"""Similarities from which a matched pair counts, 0.05 to 0.95."""


@dataclass(frozen=True, slots=True)
class Hota:
    """[Luiten2020], each the mean over `ALPHAS`.

    Attributes:
        hota: geometric mean of detection and association, taken at each alpha.
        deta: Jaccard index of the rows.
        assa: mean over the matches of the Jaccard index of their person and their track.
        loca: mean similarity of the matches.
    """

    hota: float
    deta: float
    assa: float
    loca: float


def hota(comparison: Comparison) -> Hota:
    """Match each frame once with the tracks' overall agreement as weight, then count per alpha."""
    if comparison.one_sided:
        return Hota(hota=0.0, deta=0.0, assa=0.0, loca=1.0)
    pairs = comparison.pairs
    couples, couple = np.unique(comparison.couples(pairs), return_inverse=True)
    person, identity = np.divmod(couples, comparison.identities)
    both = comparison.frames_of_people()[person] + comparison.frames_of_identities()[identity]
    agreement = _agreement(pairs, couple, both)
    chosen = assign(pairs, agreement[couple] * pairs.similarity, comparison.frames)
    counted = [chosen & (pairs.similarity >= alpha - EPS) for alpha in ALPHAS]
    matches = np.array([row.sum() for row in counted])
    rows = len(comparison.truth) + len(comparison.result)
    deta = matches / (rows - matches)
    together = [np.bincount(couple[row], minlength=len(couples)) for row in counted]
    assa = np.array([_association(count, both) for count in together]) / np.maximum(1, matches)
    alike = np.array([sum(pairs.similarity[row].tolist()) for row in counted])
    loca = np.maximum(1e-10, alike) / np.maximum(1e-10, matches)
    return Hota(
        hota=float(np.sqrt(deta * assa).mean()),
        deta=float(deta.mean()),
        assa=float(assa.mean()),
        loca=float(loca.mean()),
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


def _association(together: Integers, both: Integers) -> float:
    """Sum over matches of the Jaccard index of their person and their track."""
    return float((together * (together / np.maximum(1, both - together))).sum())
