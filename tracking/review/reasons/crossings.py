"""Two trails that cross or come close."""

from __future__ import annotations

import numpy as np

from tracking.review.core.findings import FlaggedPlaces, of_pairs, peaks, ramp
from tracking.review.core.material import Material
from tracking.tracks import row_keys

CLOSE_M = 0.5
"""People this near to each other have crossed or passed."""
_APART_S = 1.0


def crossings(material: Material) -> FlaggedPlaces:
    """Where two people were closest, if that was within half a metre."""
    evidence, near = material.evidence, material.near
    close = np.flatnonzero(near.distance_m <= CLOSE_M)
    one, other = near.first[close], near.second[close]
    distance = near.distance_m[close]
    pair = row_keys(evidence.track[one], evidence.track[other])
    best = peaks(pair, evidence.frame[one], -distance, evidence.frames_of(_APART_S))
    one, other, distance = one[best], other[best], distance[best]
    strength = 0.1 + 0.9 * ramp(distance, CLOSE_M, 0.0)
    return of_pairs(
        "crossing",
        evidence.track[one],
        evidence.track[other],
        evidence.frame[one],
        strength,
        distance,
    )
