"""Where people may leave the picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.stereo_boxes import middles

Floats = NDArray[np.float64]

_STEP_M = 0.75
_AWAY_M = _STEP_M * np.array([(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)])
_HALF_BODY_M = np.array([0.25, 0.85])
"""Across and upwards."""


def share_a_step_off(position: Floats, view: View) -> Floats:
    """The least share, 0 to 1, of a body in the picture a step from where people are: (people,).

    Who stands at the picture's edge is a step on the floor from being out of it. That a body is
    cut off does not tell: far from a camera that looks down on them heads are cut off for metres,
    and who is there does not leave all of a sudden.

    Args:
        position: (people, 2) m.
    """
    around = (position[:, None] + _AWAY_M).reshape(-1, 2)
    middle, px_per_m = middles(around, view)
    half = _HALF_BODY_M * px_per_m
    low = np.clip(middle - half, 0.0, view.camera.size)
    high = np.clip(middle + half, 0.0, view.camera.size)
    share = np.prod((high - low) / (2.0 * half), axis=1)
    return np.asarray(share.reshape(-1, len(_AWAY_M)).min(axis=1))
