"""A person who is suddenly elsewhere."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Flags, Floats
from tracking.review.core.evidence import Evidence
from tracking.review.core.findings import FlaggedPlaces, of_tracks, peaks, ramp
from tracking.review.core.material import Material
from tracking.tracks import Source

_APART_S = 0.5
_FASTEST_M_PER_S = 2.5
"""Beyond what people walk."""
_LOW_M, _HIGH_M = 0.1, 0.6


def jumps(material: Material) -> FlaggedPlaces:
    """Where a track moves farther from row to row than its steps before and after lead to expect.

    Between rows with frames missing it may have gone as far as somebody walks. A track's two first
    and two last steps have too few beside them and are not judged: once a track is split at a
    jump, what is left of it at the new ends is no jump. Nor is a step between two boxes that a
    person drew, moved, interpolated or kept while thinning, which asks to look at what is kept:
    where only one is a person's, the other may still be wrong.
    """
    evidence = material.evidence
    frames = np.diff(evidence.frame)
    off = steps_off(evidence)
    walked = np.where(frames > 1, frames / evidence.fps * _FASTEST_M_PER_S, 0.0)
    # Before the greatest near each other are taken: a person's must not stand for a tracker's.
    off = np.where(_persons(evidence), 0.0, np.nan_to_num(off - walked))
    told = np.flatnonzero(off > _LOW_M)
    track, frame = evidence.track[told + 1], evidence.frame[told + 1]
    best = peaks(track, frame, off[told], evidence.frames_of(_APART_S))
    metres = off[told][best]
    return of_tracks("jump", track[best], frame[best], ramp(metres, _LOW_M, _HIGH_M), metres)


def _persons(evidence: Evidence) -> Flags:
    """(n - 1,) whether a person made both rows of a step, or they are interpolated between such."""
    made = np.isin(evidence.source, (Source.PERSON, Source.INTERPOLATED))
    return np.asarray(made[1:] & made[:-1])


def steps_off(evidence: Evidence) -> Floats:
    """(n - 1,) m by which the step from each row to the next is another than those around it.

    NaN where the next row is another track's, or too few steps are around it.
    """
    frames = np.diff(evidence.frame)
    step = np.diff(evidence.place, axis=0) / np.maximum(frames, 1)[:, None]
    step[~evidence.goes_on] = np.nan
    return np.asarray(np.hypot(*(step - _usual(step)).T) * frames)


def _usual(step: Floats) -> Floats:
    """(n, 2) the median of the two steps before and the two after, so that jumps in two steps tell.

    NaN where one of them is missing.
    """
    usual = np.full_like(step, np.nan)
    if len(step) > 4:
        one, two, three, four = (step[shift : len(step) - 4 + shift] for shift in (0, 1, 3, 4))
        low = np.maximum(np.minimum(one, two), np.minimum(three, four))
        high = np.minimum(np.maximum(one, two), np.maximum(three, four))
        usual[2:-2] = (low + high) / 2
    return usual
