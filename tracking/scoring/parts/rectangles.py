"""Rectangles of people and their parts as corners: left, top, right, bottom, NaN where none."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.tracks.on_part import areas, common_areas

Bools = NDArray[np.bool_]


def bounding(corners: Floats) -> Floats:
    """The smallest boxes (..., 4) round several (..., k, 4); NaN where one of them is."""
    return np.concatenate((corners[..., :2].min(axis=-2), corners[..., 2:].max(axis=-2)), axis=-1)


def overlaps(one: Floats, other: Floats) -> Floats:
    """Intersection over union of boxes (..., 4); 0 where one of them is none."""
    common = np.nan_to_num(common_areas(one, other))
    union = areas(one) + areas(other) - common
    return np.divide(common, union, out=np.zeros_like(common), where=common > 0)
