"""Polygons on a plane: what lies inside, and how large they are."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracking.arrays import Flags, Floats


def inside(polygon: Sequence[tuple[float, float]], places: Floats) -> Flags:
    """(n,) which places (n, 2) lie inside a polygon whose edges do not cross.

    A place on an edge is not inside, as with PedPy's areas; NaN is nowhere.
    """
    corners = np.asarray(polygon, np.float64)
    low, high = corners.min(axis=0), corners.max(axis=0)
    found: Flags = ((places > low) & (places < high)).all(axis=1)
    near = places[found]
    odd, on_edge = np.zeros(len(near), bool), np.zeros(len(near), bool)
    for (x1, y1), (x2, y2) in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        below, above = near[:, 1] < y1, near[:, 1] < y2
        left = (x2 - x1) * (near[:, 1] - y1) - (near[:, 0] - x1) * (y2 - y1)
        odd ^= (below != above) & ((left > 0) == (y2 > y1))
        beside = (near[:, 0] - x1) * (near[:, 0] - x2) + (near[:, 1] - y1) * (near[:, 1] - y2)
        on_edge |= (left == 0) & (beside <= 0)
    found[found] = odd & ~on_edge
    return found


def area(polygon: Sequence[tuple[float, float]]) -> float:
    """Of a polygon whose edges do not cross, in the square of its unit."""
    x, y = np.asarray(polygon, np.float64).T
    x, y = x - x[0], y - y[0]
    return float(abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2)
