"""Whether a rectangle holds a body part; corners are left, top, right, bottom, NaN where none."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

LEAST_COVERED = 0.05
"""Share of a part that a rectangle must cover: a dot inside holds nothing else either."""


def bounding(corners: Floats) -> Floats:
    """The smallest boxes (..., 4) round several (..., k, 4); NaN where one of them is."""
    return np.concatenate((corners[..., :2].min(axis=-2), corners[..., 2:].max(axis=-2)), axis=-1)


def foreign_share(rectangles: Floats, true: Floats) -> Floats:
    """Share (...) of rectangles (..., 4) that lies outside of the true boxes (..., 4)."""
    return np.asarray(1.0 - _common(rectangles, true) / np.maximum(_area(rectangles), 1e-9))


def right(rectangles: Floats, true: Floats) -> Bools:
    """Whether rectangles (..., 4) hold what they should; False where there is none."""
    covered = _common(rectangles, true) / np.maximum(_area(true), 1e-9)
    enough = covered >= LEAST_COVERED
    return np.asarray(enough & (foreign_share(rectangles, true) < 0.5), np.bool_)


def overlaps(one: Floats, other: Floats) -> Floats:
    """Intersection over union of boxes (..., 4); 0 where one of them is none."""
    common = np.nan_to_num(_common(one, other))
    union = _area(one) + _area(other) - common
    return np.divide(common, union, out=np.zeros_like(common), where=common > 0)


def _area(corners: Floats) -> Floats:
    size = np.maximum(corners[..., 2:] - corners[..., :2], 0.0)
    return np.asarray(size[..., 0] * size[..., 1])


def _common(one: Floats, other: Floats) -> Floats:
    low = np.maximum(one[..., :2], other[..., :2])
    high = np.minimum(one[..., 2:], other[..., 2:])
    return _area(np.concatenate((low, high), axis=-1))
