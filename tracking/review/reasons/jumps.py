"""A person who is suddenly elsewhere."""

from __future__ import annotations

import numpy as np

from tracking.review.found import Found, of_tracks, peaks, ramp
from tracking.review.material import Material

_APART_S = 0.5
_FASTEST_M_PER_S = 2.5
"""Beyond what people walk."""
_LOW_M, _HIGH_M = 0.1, 0.6


def jumps(material: Material) -> Found:
    """Where a track moves farther from row to row than its steps before and after lead to expect.

    Between rows with frames missing it may have gone as far as somebody walks.
    """
    evidence = material.evidence
    frames = np.diff(evidence.frame)
    step = np.diff(evidence.place, axis=0) / np.maximum(frames, 1)[:, None]
    step[~evidence.goes_on] = np.nan
    usual = np.zeros_like(step)
    usual[1:-1] = (step[:-2] + step[2:]) / 2
    usual = np.nan_to_num(usual)
    off = np.hypot(*(step - usual).T) * frames
    walked = np.where(frames > 1, frames / evidence.fps * _FASTEST_M_PER_S, 0.0)
    off = np.nan_to_num(off - walked)
    told = np.flatnonzero(off > _LOW_M)
    track, frame = evidence.track[told + 1], evidence.frame[told + 1]
    best = peaks(track, frame, off[told], evidence.frames_of(_APART_S))
    metres = off[told][best]
    return of_tracks("jump", track[best], frame[best], ramp(metres, _LOW_M, _HIGH_M), metres)
