"""Identity measures: how well one track explains one person over the whole recording."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.scoring.comparison import Comparison


@dataclass(frozen=True, slots=True)
class Identity:
    """[Ristani2016]: rows explained under the best one-to-one naming, as shares."""

    idf1: float
    idp: float
    idr: float


def identity(comparison: Comparison) -> Identity:
    """Name each person after at most one track so that most rows agree, and count them.

    The fewest wrong rows and the most right rows are found by the same naming.
    """
    if comparison.one_sided:
        return Identity(0.0, 0.0, 0.0)
    pairs = comparison.pairs.some(comparison.pairs.similarity >= comparison.threshold)
    together = np.zeros((comparison.people, comparison.identities))
    person = comparison.person[pairs.rows.truth]
    np.add.at(together, (person, comparison.identity[pairs.rows.result]), 1)
    right = float(together[linear_sum_assignment(together, maximize=True)].sum())
    truth, result = len(comparison.truth), len(comparison.result)
    return Identity(
        idf1=right / (right + 0.5 * (result - right) + 0.5 * (truth - right)),
        idp=right / result,
        idr=right / truth,
    )
