"""How likely a mistake is, from the reasons that speak for it.

A logistic model: log odds of the place and of the crowd, plus a weight for each reason times its
strength. It was fitted to rendered scenes tracked with both stereo trackers, with their own
mistakes and with tracks swapped at random where they pass each other:
`python -m tests.benchmarks.review --fit` renders them, fits the table anew and prints it beside
how often places of each likelihood were mistakes. A weight of 0 means that the reason tells
nothing beyond what the others told.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

ONE, TWO = -4.55, -3.0
"""Log odds of a place of one track and of one of two tracks, whatever speaks for it."""
CROWD = 1.53
"""Log odds that being crowded adds."""

WEIGHTS: Mapping[str, float] = MappingProxyType(
    {
        "exchange": 2.1,
        "turn": 4.2,
        "crossing": 0.08,
        "shared": 0.31,
        "lost": 7.87,
        "ended": 0.0,
        "begun": 2.54,
        "colour": 0.98,
        "height": 0.0,
        "jump": 0.65,
        "reversal": 3.25,
        "predicted": 0.44,
        "drift": 0.06,
        "margin": 0.37,
        "spread": 0.61,
        "split": 1.57,
        "part": 1.0,  # not fitted: none of these trackers follows parts
    }
)
"""Log odds that a reason of full strength adds."""

LEAST_WEIGHT = 0.05
"""So that among reasons that tell nothing the stronger one still leads."""


def likelihoods(
    kinds: Sequence[str], strength: Floats, two: NDArray[np.bool_], crowd: Floats
) -> Floats:
    """(k,) 0 to 1.

    Args:
        kinds: of the columns of strength. strength: (k, kinds) of the strongest reason of a kind.
        two: (k,) whether a place is about two tracks. crowd: (k,) see `crowding`.
    """
    weights = np.array([WEIGHTS[kind] for kind in kinds])
    odds = np.where(two, TWO, ONE) + CROWD * crowd + strength @ weights
    return np.asarray(1.0 / (1.0 + np.exp(-odds)))
