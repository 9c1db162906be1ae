"""Body parts the failure detector found off their part."""

from __future__ import annotations

import numpy as np

from tracking.review.found import Found, of_tracks, peaks, ramp
from tracking.review.material import Material

_APART_S = 2.0
_ALL = 3
"""Parts of a person."""


def failed_parts(material: Material) -> Found:
    """Where most parts of a person have failed; the first frame of those alike."""
    evidence = material.evidence
    rows = np.flatnonzero(evidence.failed > 0)
    track, frame = evidence.track[rows], evidence.frame[rows]
    count = evidence.failed[rows].astype(np.float64)
    best = peaks(track, frame, count, evidence.frames_of(_APART_S))
    return of_tracks("part", track[best], frame[best], ramp(count[best], 0.0, _ALL), count[best])
