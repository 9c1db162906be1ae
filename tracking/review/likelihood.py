"""How likely a mistake is, from the reasons that speak for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

INTERCEPT = -2.85
WEIGHTS: Mapping[str, float] = MappingProxyType(
    {
        "exchange": 1.55,
        "turn": 2.94,
        "crossing": 0.13,
        "shared": 1.14,
        "lost": 9.95,
        "ended": 2.21,
        "begun": 2.21,
        "colour": 0.73,
        "height": 0.0,
        "jump": 2.01,
        "predicted": 0.74,
        "drift": 0.5,
        "margin": 0.77,
        "spread": 1.42,
        "split": 0.1,
        "part": 1.0,
    }
)
"""Log odds that a reason of full strength adds to a mistake."""


def likelihoods(kinds: Sequence[str], strength: Floats) -> Floats:
    """(k,) 0 to 1, by a logistic model of the strengths (k, kinds) of the reasons."""
    weights = np.array([WEIGHTS[kind] for kind in kinds])
    return np.asarray(1.0 / (1.0 + np.exp(-(INTERCEPT + strength @ weights))))
