"""Identity measures: how well one track explains one person over the whole recording."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from tracking.arrays import Flags, Integers
from tracking.scoring.comparison import Comparison


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
        (people,) the number of a track, -1 for none; of several best namings one SciPy finds.
        (people,) in how many frames the two agree.
    """
    person, track, together = _together(comparison, admitted)
    named = np.full(comparison.people, -1)
    agree = np.zeros(comparison.people, np.int64)
    named[person], agree[person] = track, together  # right for those who meet nobody else
    for part in _apart(person, track, comparison.people, comparison.identities):
        down, row = np.unique(person[part], return_inverse=True)
        across, column = np.unique(track[part], return_inverse=True)
        table = np.zeros((len(down), len(across)), np.int64)
        table[row, column] = together[part]
        row, column = linear_sum_assignment(table, maximize=True)
        named[down], agree[down] = -1, 0
        chosen = table[row, column] > 0
        named[down[row[chosen]]] = across[column[chosen]]
        agree[down[row[chosen]]] = table[row[chosen], column[chosen]]
    return named, agree


def _together(
    comparison: Comparison, admitted: Flags | None
) -> tuple[Integers, Integers, Integers]:
    """(c,) people and tracks that may be one in some frame, and in how many."""
    if admitted is None:
        admitted = comparison.pairs.similarity >= comparison.threshold
    couple, frames = np.unique(comparison.couple[admitted], return_counts=True)
    person, track = np.divmod(couple, max(1, comparison.identities))
    return person, track, frames


def _apart(person: Integers, track: Integers, people: int, identities: int) -> list[Integers]:
    """Couples in parts that share nobody: each part is named by itself, in little memory.

    Couples of a person and a track that meet nobody else are left out.
    """
    if not len(person):
        return []
    size = people + identities
    meet = coo_array((np.ones(len(person), np.int8), (person, people + track)), (size, size))
    part = connected_components(meet, directed=False)[1][person]
    several = np.flatnonzero(np.bincount(part)[part] > 1)
    order = several[np.argsort(part[several], kind="stable")]
    return np.split(order, np.flatnonzero(np.diff(part[order])) + 1)
