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
_MOST_SHARE = 0.96
"""Of the places, along each axis, so many say where most people are."""
_BEYOND, _BEYOND_M = 0.5, 2.0
"""So far beyond those, of their span and at least, others count still."""
_QUANTILE_ROWS = 100_000
"""Of more places only some are looked at, evenly, to say where most are."""


def reach_m(recording: Recording) -> float:
    """How far from the camera the floor is shown in any case: a higher one looks further."""
    if recording.view is None:
        return _NEAREST_M
    height_m = recording.view.ground.height_m
    return float(np.clip(_HEIGHTS * height_m, _NEAREST_M, _FARTHEST_M))


def extent(rows: Columns, reach: float) -> Bounds | None:
    """Whole metres around places of rows with `x` and `y`, m; None where none is known.

    A few that are far from where most are, as of a short track at the end of a street, are left
    out: they would make everybody else tiny.
    """
    xy = _near(rows, reach)
    if not len(xy):
        return None
    share = (1.0 - _MOST_SHARE) / 2
    some = xy[:: max(1, len(xy) // _QUANTILE_ROWS)]
    first, last = np.quantile(some, (share, 1.0 - share), axis=0)
    beyond = np.maximum(_BEYOND * (last - first), _BEYOND_M)
    low, high = (
        np.maximum(xy.min(axis=0), first - beyond),
        np.minimum(xy.max(axis=0), last + beyond),
    )
    return _whole_metres(low, high)


def not_far_beyond(rows: Columns, bounds: Bounds) -> Columns:
    """Those of some places of rows with `x` and `y` that bounds may grow by: see `extent`."""
    low, high = np.array(bounds[:2]), np.array(bounds[2:])
    beyond = np.maximum(_BEYOND * (high - low), _BEYOND_M)
    xy = np.column_stack((rows["x"], rows["y"]))
    inside = ((xy >= low - beyond) & (xy <= high + beyond)).all(axis=1)
    return {name: rows[name][inside] for name in ("x", "y")}


def full_extent(rows: Columns, reach: float) -> Bounds | None:
    """Whole metres around all places of rows with `x` and `y`, m; None where none is known."""
    xy = _near(rows, reach)
    return _whole_metres(xy.min(axis=0), xy.max(axis=0)) if len(xy) else None


def _near(rows: Columns, reach: float) -> NDArray[np.float64]:
    """(n, 2) places, m, less those several times as far away as the `reach`, in m.

    So close to the horizon a pixel is many metres.
    """
    xy: NDArray[np.float64] = np.column_stack((rows["x"], rows["y"])).astype(np.float64)
    return xy[np.hypot(xy[:, 0], xy[:, 1]) <= _TIMES * reach]  # never so of NaN


def _whole_metres(low: NDArray[np.float64], high: NDArray[np.float64]) -> Bounds:
    left, bottom = (float(math.floor(value)) for value in low - MARGIN_M)
    right, top = (float(math.ceil(value)) for value in high + MARGIN_M)
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
