"""Choices of the tracker that were close."""

from __future__ import annotations

import numpy as np

from tracking.review.core.findings import (
    FlaggedPlaces,
    join_findings,
    of_pairs,
    of_tracks,
    peaks,
    ramp,
)
from tracking.review.core.material import Material

_HIGH, _LOW = 0.5, 0.05
"""Margins of the total cost: large enough not to be mentioned, and next to nothing."""
_APART_S = 1.0


def small_margins(material: Material) -> FlaggedPlaces:
    """Where the next best choice of detections would have cost hardly more.

    It is about whoever was nearest, where somebody was near.
    """
    evidence = material.evidence
    rows = np.flatnonzero(evidence.margin < _HIGH)
    margin = evidence.margin[rows].astype(np.float64)
    apart = evidence.frames_of(_APART_S)
    best = peaks(evidence.track[rows], evidence.frame[rows], -margin, apart)
    rows, margin = rows[best], np.maximum(margin[best], 0.0)
    other = material.nearest[rows]
    track, frame = evidence.track[rows], evidence.frame[rows]
    strength = 0.01 + ramp(margin, _HIGH, _LOW)
    alone, near = np.flatnonzero(other == 0), np.flatnonzero(other > 0)
    return join_findings(
        (
            of_pairs(
                *("margin", track[near], other[near], frame[near], strength[near], margin[near])
            ),
            of_tracks("margin", track[alone], frame[alone], strength[alone], margin[alone]),
        )
    )
