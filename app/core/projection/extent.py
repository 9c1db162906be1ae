"""How far the floor is shown: what the camera sees of it, and wherever people are."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from tracking.recording import Recording
from tracking.tracks import Columns

Bounds = tuple[float, float, float, float]
"""Left, bottom, right and top on the floor, m."""

MARGIN_M = 0.6
_NEAREST_M, _FARTHEST_M, _HEIGHTS = 8.0, 40.0, 4.5
_TIMES = 4.0


def reach_m(recording: Recording) -> float:
    """How far from the camera the floor is shown in any case: a higher one looks further."""
    if recording.view is None:
        return _NEAREST_M
    height_m = recording.view.ground.height_m
    return float(np.clip(_HEIGHTS * height_m, _NEAREST_M, _FARTHEST_M))


def extent(rows: Columns, reach: float) -> Bounds | None:
    """Whole metres around all places of rows with `x` and `y`, m; None where none is known.

    Places several times as far away as the `reach`, in m, are left out: so close to the horizon a
    pixel is many metres, and one such place would make everything else tiny.
    """
    xy: NDArray[np.float64] = np.column_stack((rows["x"], rows["y"])).astype(np.float64)
    near = np.hypot(xy[:, 0], xy[:, 1]) <= _TIMES * reach  # never so of NaN
    if not near.any():
        return None
    low, high = xy[near].min(axis=0) - MARGIN_M, xy[near].max(axis=0) + MARGIN_M
    left, bottom = (float(math.floor(value)) for value in low)
    right, top = (float(math.ceil(value)) for value in high)
    return left, bottom, right, top


def unite(one: Bounds, other: Bounds | None) -> Bounds:
    """The smallest that holds both; the very same where the other lies within."""
    if other is None:
        return one
    return (
        min(one[0], other[0]),
        min(one[1], other[1]),
        max(one[2], other[2]),
        max(one[3], other[3]),
    )
