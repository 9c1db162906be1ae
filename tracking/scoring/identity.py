"""Identity measures: how well one track explains one person over the whole recording."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.scoring.comparison import Comparison
from tracking.scoring.table import Flags, Integers


@dataclass(frozen=True, slots=True)
class Identity:
    """[Ristani2016]: rows explained under the best one-to-one naming.

    Attributes:
        true_positives: rows of people matched by the track they are named after.
        misses: other rows of people. false_positives: other rows of tracks.
    """

    true_positives: int
    misses: int
    false_positives: int

    @property
    def idf1(self) -> float:
        """Harmonic mean of the next two."""
        wrong = 0.5 * self.false_positives + 0.5 * self.misses
        return self.true_positives / max(1.0, self.true_positives + wrong)

    @property
    def idp(self) -> float:
        """Share of the result's rows that are right."""
        return self.true_positives / max(1.0, self.true_positives + self.false_positives)

    @property
    def idr(self) -> float:
        """Share of the truth's rows that are found."""
        return self.true_positives / max(1.0, self.true_positives + self.misses)


def identity(comparison: Comparison, admitted: Flags | None = None) -> Identity:
    """Name each person after at most one track so that most rows agree, and count them.

    Args:
        admitted: (k,) pairs that may be one person; those at the threshold where left out.
    """
    right = int(naming(comparison, admitted)[1].sum())
    return Identity(right, len(comparison.truth) - right, len(comparison.result) - right)


def naming(comparison: Comparison, admitted: Flags | None = None) -> tuple[Integers, Integers]:
    """Whom each person is named after.

    Returns:
        (people,) the number of a track, -1 for none; of several best namings the one SciPy finds.
        (people,) in how many frames the two agree.
    """
    together = _together(comparison, admitted)
    named = np.full(comparison.people, -1)
    agree = np.zeros(comparison.people, np.int64)
    person, track = linear_sum_assignment(together, maximize=True)
    agree[person] = together[person, track]
    named[person] = track
    named[agree == 0] = -1
    return named, agree


def _together(comparison: Comparison, admitted: Flags | None) -> Integers:
    """(people, identities) in how many frames the two may be one."""
    if admitted is None:
        admitted = comparison.pairs.similarity >= comparison.threshold
    counted = np.bincount(comparison.couple[admitted], minlength=comparison.couples)
    return counted.reshape(comparison.people, comparison.identities)
