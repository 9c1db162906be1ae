"""Two tracks of which each goes on as the other was going."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.review.core.evidence import Evidence, Rows
from tracking.review.core.findings import FlaggedPlaces, of_pairs, peaks, ramp
from tracking.review.core.material import REACH_M, Material
from tracking.review.reasons.jumps import steps_off
from tracking.tracks import row_keys

_STEP_S = 0.3
"""Over which a walk's direction is taken, before and after."""
_APART_S = 1.0
_LOW_M, _HIGH_M = 0.15, 0.8
_LEAP_M = 0.5
"""Tracks that leap so far in the same frame may have changed over, however far apart they are."""
_MOST_LEAPING = 20
"""Where more leap in one frame, the picture did."""


def turns(material: Material) -> FlaggedPlaces:
    """Where two walks go on more smoothly with their names changed over.

    Both are led on for a moment as they walked before a frame, and led back as they walked after
    it; compared is by how many metres they miss each other, as they are and changed over.
    """
    evidence = material.evidence
    one, other = meetings(material)
    gain = gains(evidence, one, other)
    told = np.flatnonzero(gain > _LOW_M)
    one, other, gain = one[told], other[told], gain[told]
    first, second, frame = evidence.track[one], evidence.track[other], evidence.frame[one]
    best = peaks(row_keys(first, second), frame, gain, evidence.frames_of(_APART_S))
    strength = ramp(gain[best], _LOW_M, _HIGH_M)
    return of_pairs("turn", first[best], second[best], frame[best], strength, gain[best])


def meetings(material: Material) -> tuple[Rows, Rows]:
    """(k,), (k,) rows of one frame whose tracks may change over there, by tracks, then frame.

    Those near each other, and those that leap at once: whoever names the wrong person by hand, or
    a tracker that found both again, may take people for one another across the floor.
    """
    evidence, near = material.evidence, material.near
    leaping = np.flatnonzero(np.append(False, steps_off(evidence) > _LEAP_M)[: len(evidence)])
    one, other = _far_pairs(material, leaping)
    one, other = np.concatenate((near.first, one)), np.concatenate((near.second, other))
    order = np.lexsort((evidence.frame[one], evidence.track[other], evidence.track[one]))
    return one[order], other[order]


def _far_pairs(material: Material, rows: Rows) -> tuple[Rows, Rows]:
    """(k,), (k,) all pairs among rows of one frame that are out of each other's reach."""
    evidence = material.evidence
    rows = rows[np.argsort(evidence.frame[rows], kind="stable")]
    frame = evidence.frame[rows]
    end = np.searchsorted(frame, frame, "right")
    few = end - np.searchsorted(frame, frame) <= _MOST_LEAPING
    count = np.where(few, end - np.arange(len(rows)) - 1, 0)
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    at = np.repeat(np.arange(len(rows)), count)
    one, other = rows[at], rows[at + 1 + within]
    far = np.hypot(*(evidence.place[one] - evidence.place[other]).T) > REACH_M
    return one[far], other[far]


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
