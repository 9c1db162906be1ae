"""Two tracks near each other that look like each other afterwards."""

from __future__ import annotations

import numpy as np

from tracking.review.core.appearance import EVERY_S, swap_gain_of_appearance
from tracking.review.core.findings import FlaggedPlaces, of_pairs, peaks, ramp
from tracking.review.core.material import Material
from tracking.tracks import row_keys

_APART_S = 1.5
_FOR_NEAR = 0.3
_LOW, _HIGH = 0.5, 6.0
"""How much better the looks agree changed over: from hardly to clearly."""


def exchanges(material: Material) -> FlaggedPlaces:
    """Where two tracks' colours and heights agree best with their names changed over."""
    evidence, near = material.evidence, material.near
    looked = np.flatnonzero(evidence.frame[near.first] % evidence.frames_of(EVERY_S) == 0)
    first, second = evidence.track[near.first[looked]], evidence.track[near.second[looked]]
    frame = evidence.frame[near.first[looked]]
    better = swap_gain_of_appearance(material.looks, first, second, frame)
    told = np.flatnonzero(better > _LOW)
    first, second, frame, better = first[told], second[told], frame[told], better[told]
    # Of frames about as good the one in which they were nearest.
    value = better - _FOR_NEAR * near.distance_m[looked[told]]
    best = peaks(row_keys(first, second), frame, value, evidence.frames_of(_APART_S))
    strength = ramp(better[best], _LOW, _HIGH)
    return of_pairs("exchange", first[best], second[best], frame[best], strength, better[best])
