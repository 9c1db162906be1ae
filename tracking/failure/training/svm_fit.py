"""Machines fitted by scikit-learn; nothing else in the program needs that library."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.machines import Machine

_CACHE_MB = 64


@dataclass(frozen=True, slots=True, order=True)
class Candidate:
    """Parameters of a support vector machine.

    Attributes:
        cost: of a sample on the wrong side.
        gamma: of the radial kernel, times the number of inputs; 0: the linear kernel.
    """

    cost: float
    gamma: float

    def __str__(self) -> str:
        """As a report and a detector file name it."""
        kernel = f"radial, gamma {self.gamma:g} / inputs" if self.gamma else "linear"
        return f"{kernel}, C {self.cost:g}"


GRID = (
    *(Candidate(cost, gamma) for cost in (1.0, 10.0, 100.0) for gamma in (0.1, 0.3, 1.0, 3.0)),
    *(Candidate(cost, 0.0) for cost in (0.01, 0.1, 1.0)),
)
"""The radial kernel, the smoothest machines first, and the linear one for comparison; the paper
names neither its kernel nor its parameters."""


def fitted(values: Floats, failed: NDArray[np.bool_], candidate: Candidate) -> Machine:
    """The machine for rows (n, d), above 0 where failed; both classes weigh the same in total."""
    # No stubs come with the library, and it takes a second to load: only where it is needed.
    from sklearn.svm import SVC

    gamma = candidate.gamma / values.shape[1]
    kernel = {"kernel": "rbf", "gamma": gamma} if gamma else {"kernel": "linear"}
    machine = SVC(C=candidate.cost, class_weight="balanced", cache_size=_CACHE_MB, **kernel)
    machine.fit(values, failed)
    intercept = float(machine.intercept_[0])
    if not gamma:
        return Machine(np.array(machine.coef_, float), np.ones(1), intercept, 0.0)
    support = np.array(machine.support_vectors_, float)
    return Machine(support, np.array(machine.dual_coef_[0], float), intercept, gamma)


def library() -> str:
    """The name and version of what fits."""
    import sklearn

    return f"scikit-learn {sklearn.__version__}"
