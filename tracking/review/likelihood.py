"""How likely a mistake is, from the reasons that speak for it.

A logistic model of the hazard of the rows to be watched, see `tracking.review.hazard`: it was
fitted to rendered scenes tracked with both stereo trackers, with their own mistakes and with tracks
swapped at random where they pass each other. `python -m tests.benchmarks.review --fit` renders
them, fits hazards and figures anew and prints how often places of each likelihood were mistakes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np

from tracking.arrays import Floats

BASE, EFOLD, ROW = -1.17, 0.48, 0.31
"""Log odds of no hazard at all but for its logarithm, what an e-fold more of it adds, and what
each row's worth of it adds."""

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
"""Which of several reasons for one place leads it: it is said first and tells whom it is about.

How many log odds a reason of full strength adds where nothing but reasons is known; a weight of 0
means that it tells nothing beyond what the others told.
"""

NOTHING = 1e-3
"""Less hazard than this is none: what the same rows of another place have taken."""
LEAST_WEIGHT = 0.05
"""So that among reasons that tell nothing the stronger one still leads."""


def likelihoods(kinds: Sequence[str], strength: Floats, expected: Floats) -> Floats:
    """(k,) 0 to 1.

    Args:
        kinds: of the columns of strength. strength: (k, kinds) of the strongest reason of a kind.
        expected: (k,) hazards summed over the stretch and its tracks.
    """
    part = WEIGHTS["part"] * strength[:, list(kinds).index("part")]
    odds = BASE + EFOLD * np.log(np.maximum(expected, NOTHING)) + ROW * expected + part
    return np.asarray(1.0 / (1.0 + np.exp(-odds)))
