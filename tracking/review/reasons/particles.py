"""Particles that spread or fall in two."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.review.core.findings import FlaggedPlaces, of_tracks, peaks, ramp
from tracking.review.core.material import Material

_SPREAD_M, _WIDE_M = 0.3, 0.8
_SPLIT, _CLEAR = 0.25, 0.7
_WORTH_SPLITTING_M = 0.2
"""A narrower cloud in two is still one person."""
_APART_S = 1.0


def spread_particles(material: Material) -> FlaggedPlaces:
    """Where a person's particles are spread widest."""
    spread_m = material.evidence.spread_m.astype(np.float64)
    return _greatest("spread", material, spread_m, ramp(spread_m, _SPREAD_M, _WIDE_M))


def split_particles(material: Material) -> FlaggedPlaces:
    """Where a person's particles are most clearly two clusters apart from each other."""
    evidence = material.evidence
    split = np.where(evidence.spread_m >= _WORTH_SPLITTING_M, evidence.split, 0.0)
    return _greatest("split", material, split, ramp(split, _SPLIT, _CLEAR))


def _greatest(kind: str, material: Material, value: Floats, strength: Floats) -> FlaggedPlaces:
    evidence = material.evidence
    rows = np.flatnonzero(strength > 0.0)
    track, frame = evidence.track[rows], evidence.frame[rows]
    best = peaks(track, frame, value[rows], evidence.frames_of(_APART_S))
    chosen = rows[best]
    return of_tracks(kind, track[best], frame[best], strength[chosen], value[chosen])
