"""Somebody who turns back while half hidden: the track may have gone over to somebody else."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.review.core.evidence import Evidence, Rows
from tracking.review.core.findings import FlaggedPlaces, of_tracks, peaks, ramp
from tracking.review.core.material import Material

_GAP_S = 0.3
"""Left out on both sides: tracks are smoothed, so a change-over is walked round in a curve."""
_STEP_S = 0.5
"""Over which the ways there and back are taken."""
_APART_S = 1.0
_LOW_M_PER_S, _HIGH_M_PER_S = 0.4, 1.2
_HIDDEN_S = 0.5
_HIDDEN = 0.7
"""People turn back of their own accord in full view as well; there a track is not mistaken."""


def reversals(material: Material) -> FlaggedPlaces:
    """Where a track that is partly out of sight goes back the way it came.

    Often somebody who comes the other way took it over, unseen until then.
    """
    evidence = material.evidence
    rows = _half_hidden(evidence)
    gap, step = evidence.frames_of(_GAP_S), evidence.frames_of(_STEP_S)
    there = _velocity(evidence, rows, -gap - step, -gap)
    back = _velocity(evidence, rows, gap, gap + step)
    speed = np.minimum(np.hypot(*there.T), np.hypot(*back.T))
    product = np.maximum(np.hypot(*there.T) * np.hypot(*back.T), 1e-9)
    back_m_per_s = np.nan_to_num(speed * (1.0 - (there * back).sum(axis=1) / product) / 2.0)
    told = np.flatnonzero(back_m_per_s > _LOW_M_PER_S)
    rows, value = rows[told], back_m_per_s[told]
    track, frame = evidence.track[rows], evidence.frame[rows]
    best = peaks(track, frame, value, evidence.frames_of(_APART_S))
    strength = ramp(value[best], _LOW_M_PER_S, _HIGH_M_PER_S)
    return of_tracks("reversal", track[best], frame[best], strength, value[best])


def _half_hidden(evidence: Evidence) -> Rows:
    """Rows with a hidden one, or one not seen at all, within half a second."""
    hidden = evidence.predicted | (evidence.visibility < _HIDDEN)
    count = np.concatenate(([0], np.cumsum(hidden)))
    around, row = evidence.frames_of(_HIDDEN_S), np.arange(len(hidden))
    low = np.maximum(row - around, 0)
    return np.flatnonzero(count[np.minimum(row + around + 1, len(hidden))] > count[low])


def _velocity(evidence: Evidence, rows: Rows, start: int, end: int) -> Floats:
    """(k, 2) m/s from one frame to another, told from each row's; NaN where one is missing."""
    one, other = evidence.later(rows, start), evidence.later(rows, end)
    way = (evidence.place[other] - evidence.place[one]) / (end - start) * evidence.fps
    return np.where(((one >= 0) & (other >= 0))[:, None], way, np.nan)
