"""A track that looks different, or has another height, from some moment on."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from tracking.arrays import Floats
from tracking.review.core.appearance import GUARD_S, MOST, unlikeness
from tracking.review.core.evidence import Rows
from tracking.review.core.findings import FlaggedPlaces, of_tracks, peaks, ramp
from tracking.review.core.material import Material

_APART_S = 3.0
_LOW, _HIGH = 1.0, 5.0
"""Mean squared deviation in units of what is usual for one person."""
_LOW_M, _HIGH_M = 0.12, 0.3


def colour_changes(material: Material) -> FlaggedPlaces:
    """Where the colours of a track's clothes change most, if they change."""
    sides = material.sides
    strength = ramp(_colours(sides.before, sides.after), _LOW, _HIGH)
    return _greatest("colour", material, strength, _unbounded)


def height_changes(material: Material) -> FlaggedPlaces:
    """Where the measured height of a track changes most, if it changes."""
    sides = material.sides
    strength = ramp(_heights(sides.before, sides.after), _LOW_M, _HIGH_M)
    return _greatest("height", material, strength, _heights)


def _colours(before: Floats, after: Floats, most: float = MOST) -> Floats:
    """(k,) how unlike colours are; of height, the first number, nothing is told."""
    return unlikeness(before[1:], after[1:], most)


def _unbounded(before: Floats, after: Floats) -> Floats:
    return _colours(before, after, np.inf)


def _heights(before: Floats, after: Floats) -> Floats:
    return np.asarray(np.abs(before[0] - after[0]))


def _greatest(
    kind: str, material: Material, strength: Floats, measure: Callable[[Floats, Floats], Floats]
) -> FlaggedPlaces:
    """Where a measure of looks before and after is greatest in each track, to the frame."""
    evidence, sides = material.evidence, material.sides
    told = np.flatnonzero(strength > 0.0)
    rows, strength = sides.row[told], strength[told]
    value = measure(sides.before[:, told], sides.after[:, told])
    track, frame = evidence.track[rows], evidence.frame[rows]
    best = peaks(track, frame, value, evidence.frames_of(_APART_S))
    track, frame = track[best], frame[best]
    exact = _to_the_frame(material, track, frame, measure)
    return of_tracks(kind, track, exact, strength[best], value[best])


def _to_the_frame(
    material: Material, track: Rows, frame: Rows, measure: Callable[[Floats, Floats], Floats]
) -> Rows:
    """(k,) the frames nearby at which looks change most, nothing left out next to them."""
    reach = 2 * material.evidence.frames_of(GUARD_S)
    offset = np.arange(-reach, reach + 1)
    near = (frame[:, None] + offset).ravel()
    tracks = np.repeat(track, len(offset))
    looks = material.looks
    value = measure(looks.before(tracks, near, 0.0), looks.after(tracks, near, 0.0))
    value = np.nan_to_num(value, nan=-1.0).reshape(len(frame), len(offset))
    return np.asarray(frame + offset[value.argmax(axis=1)])
