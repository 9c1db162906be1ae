"""How crowded it is: where many are near each other, tracks are wrong more often."""

from __future__ import annotations

import numpy as np

from tracking.review.evidence import Floats, Rows
from tracking.review.material import Material

_MANY = 10
"""Pairs of people near each other from which on it counts as crowded."""


def crowd_density(material: Material, frame: Rows) -> Floats:
    """(k,) 0 to 1, from the pairs of people within reach of each other in each frame."""
    evidence = material.evidence
    pairs = np.bincount(evidence.frame[material.near.first], minlength=evidence.stop + 1)
    return np.asarray(np.minimum(pairs[np.minimum(frame, evidence.stop)] / _MANY, 1.0))
