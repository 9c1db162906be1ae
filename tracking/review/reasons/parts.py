"""Body parts the failure detector found off their part."""

from __future__ import annotations

import numpy as np

from tracking.review.core.findings import FlaggedPlaces, of_tracks, peaks, ramp
from tracking.review.core.material import Material

_APART_S = 2.0
_ALL = 3
"""Parts of a person."""


def failed_parts(material: Material) -> FlaggedPlaces:
    """Where most parts of a person have failed; the first frame of those alike.

    The figure says which: 1 head, 2 torso, 4 hip-leg, summed.
    """
    evidence = material.evidence
    rows = np.flatnonzero(evidence.failed > 0)
    track, frame = evidence.track[rows], evidence.frame[rows]
    which = evidence.failed[rows]
    count = (which[:, None] >> np.arange(_ALL) & 1).sum(axis=1).astype(np.float64)
    best = peaks(track, frame, count, evidence.frames_of(_APART_S))
    strength, figure = ramp(count[best], 0.0, _ALL), which[best].astype(np.float64)
    return of_tracks("part", track[best], frame[best], strength, figure)
