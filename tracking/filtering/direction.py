"""The direction of walking as a cue."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats


def turning_angle(walked: Floats, candidate: Floats) -> Floats:
    """The angle between where people walked and where each candidate would have them walk.

    Args:
        walked: (people, 2) m, along each track's own history; NaN where it has no direction.
        candidate: (people, detections, 2) m, from a past position of the track to the detection.

    Returns (people, detections) in 0 to pi rad; NaN where either has no direction.
    """
    forward = np.einsum("pk,pdk->pd", walked, candidate)
    sideways = walked[:, None, 0] * candidate[..., 1] - walked[:, None, 1] * candidate[..., 0]
    return np.asarray(np.abs(np.arctan2(sideways, forward)))


def direction_cost(angle: Floats, threshold_rad: float, weight: float) -> Floats:
    """What a turn costs: `Da = k alpha / alpha_thr`, and `k` from the threshold on.

    ([Kawashita2014] eq. 5; its first branch is garbled in print, this one grows to `k` as the
    text demands.) NaN angles give NaN.
    """
    return weight * np.minimum(angle / threshold_rad, 1.0)
