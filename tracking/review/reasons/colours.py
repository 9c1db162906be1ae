"""A track that looks different, or has another height, from some moment on."""

from __future__ import annotations

import numpy as np

from tracking.review.appearance import unlikeness
from tracking.review.evidence import Floats
from tracking.review.found import Found, of_tracks, peaks, ramp
from tracking.review.material import Material

_APART_S = 3.0
_LOW, _HIGH = 1.0, 5.0
"""Mean squared deviation in units of what is usual for one person."""
_LOW_M, _HIGH_M = 0.12, 0.3


def colour_changes(material: Material) -> Found:
    """Where the colours of a track's clothes change most, if they change."""
    before, after = material.sides.before.copy(), material.sides.after
    before[0] = np.nan  # the height
    value = unlikeness(before, after, np.inf)
    return _greatest("colour", material, value, ramp(unlikeness(before, after), _LOW, _HIGH))


def height_changes(material: Material) -> Found:
    """Where the measured height of a track changes most, if it changes."""
    value = np.abs(material.sides.before[0] - material.sides.after[0])
    return _greatest("height", material, value, ramp(value, _LOW_M, _HIGH_M))


def _greatest(kind: str, material: Material, value: Floats, strength: Floats) -> Found:
    evidence = material.evidence
    told = np.flatnonzero(strength > 0.0)
    rows, value, strength = material.sides.row[told], value[told], strength[told]
    apart = evidence.frames_of(_APART_S)
    best = peaks(evidence.track[rows], evidence.frame[rows], value, apart)
    rows = rows[best]
    return of_tracks(kind, evidence.track[rows], evidence.frame[rows], strength[best], value[best])
