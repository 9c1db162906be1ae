"""Two tracks near each other of which each goes on as the other was going."""

from __future__ import annotations

import numpy as np

from tracking.review.evidence import Evidence, Floats, Rows, keys
from tracking.review.found import Found, of_pairs, peaks, ramp
from tracking.review.material import Material

_STEP_S = 0.3
"""Over which a walk's direction is taken, before and after."""
_APART_S = 1.0
_LOW_M, _HIGH_M = 0.15, 0.8


def turns(material: Material) -> Found:
    """Where two walks go on more smoothly with their names changed over.

    Both are led on for a moment as they walked before a frame, and led back as they walked after
    it; compared is by how many metres they miss each other, as they are and changed over.
    """
    evidence, near = material.evidence, material.near
    one, other = near.first, near.second
    gain = gains(evidence, one, other)
    told = np.flatnonzero(gain > _LOW_M)
    one, other, gain = one[told], other[told], gain[told]
    first, second, frame = evidence.track[one], evidence.track[other], evidence.frame[one]
    best = peaks(keys(first, second), frame, gain, evidence.frames_of(_APART_S))
    strength = ramp(gain[best], _LOW_M, _HIGH_M)
    return of_pairs("turn", first[best], second[best], frame[best], strength, gain[best])


def gains(evidence: Evidence, one: Rows, other: Rows) -> Floats:
    """(k,) by how many metres two walks, of rows of one frame, agree better changed over there."""
    back, ahead = leads(evidence)
    kept = miss(back[one], ahead[one]) + miss(back[other], ahead[other])
    changed = miss(back[one], ahead[other]) + miss(back[other], ahead[one])
    return np.asarray(kept - changed)


def leads(evidence: Evidence) -> tuple[Floats, Floats]:
    """(n, 4) place and way for each row as of the rows before it, and as of it and those after.

    The place is where the walk leads to (comes from) at the cut before the row; the way is what is
    walked in half the time the direction is taken over. NaN at the ends of tracks.
    """
    step = evidence.frames_of(_STEP_S)
    row = np.arange(len(evidence))
    a, b = evidence.later(row, -1 - step), evidence.later(row, -1)
    back = _line(evidence, a, b, step, step + 0.5)
    c, d = row, evidence.later(row, step)
    ahead = _line(evidence, c, d, step, -0.5)
    return back, ahead


def _line(evidence: Evidence, start: Rows, end: Rows, step: int, at: float) -> Floats:
    """(n, 4) where the line through two rows is `at` frames after the first, and its way."""
    known = ((start >= 0) & (end >= 0))[:, None]
    way = (evidence.place[end] - evidence.place[start]) / step
    place = evidence.place[start] + at * way
    return np.where(known, np.concatenate((place, way * step / 2), axis=1), np.nan)


def miss(led: Floats, came: Floats) -> Floats:
    """(k,) m by which two walks miss each other, in place and in way."""
    apart = led - came
    return np.asarray(np.hypot(apart[:, 0], apart[:, 1]) + np.hypot(apart[:, 2], apart[:, 3]))
