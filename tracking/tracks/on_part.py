"""Whether a rectangle lies on a body part: the rule of labels, trackers and scores.

Of [ZhaoLee2009] section 5.2: a part is right while less than half of its rectangle holds something
else. Whoever labels, adjusts or scores parts takes these shares and their limits from here.

All rectangles are corners: left, top, right, bottom in px, NaN where there is none.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats

MOST_FOREIGN = 0.5
"""Share of a rectangle that lies outside of its part from which on it is wrong."""

LEAST_COVERED = 0.05
"""Share of a part that a rectangle must cover: a dot inside holds nothing else either."""

_LEAST_AREA = 1e-9


def lies_on(rectangles: Floats, parts: Floats) -> NDArray[np.bool_]:
    """Whether rectangles (..., 4) hold the parts (..., 4) they should; False where one is none."""
    enough = covered_share(rectangles, parts) >= LEAST_COVERED
    return np.asarray(enough & (foreign_share(rectangles, parts) < MOST_FOREIGN), np.bool_)


def foreign_share(rectangles: Floats, parts: Floats) -> Floats:
    """Share (...) of rectangles (..., 4) that lies outside of the parts (..., 4)."""
    own = np.maximum(areas(rectangles), _LEAST_AREA)
    return np.asarray(1.0 - common_areas(rectangles, parts) / own)


def covered_share(rectangles: Floats, parts: Floats) -> Floats:
    """Share (...) of the parts (..., 4) that rectangles (..., 4) cover."""
    whole = np.maximum(areas(parts), _LEAST_AREA)
    return np.asarray(common_areas(rectangles, parts) / whole)


def areas(rectangles: Floats) -> Floats:
    """(...) px of rectangles (..., 4)."""
    size = np.maximum(rectangles[..., 2:] - rectangles[..., :2], 0.0)
    return np.asarray(size[..., 0] * size[..., 1])


def common_areas(one: Floats, other: Floats) -> Floats:
    """(...) px that rectangles (..., 4) have in common."""
    low = np.maximum(one[..., :2], other[..., :2])
    high = np.minimum(one[..., 2:], other[..., 2:])
    return areas(np.concatenate((low, high), axis=-1))


def corners_of(rectangles: Floats) -> Floats:
    """Corners (..., 4) of rectangles (..., 4) given as middle and size: cx, cy, width, height."""
    middle, half = rectangles[..., :2], rectangles[..., 2:] / 2
    return np.concatenate((middle - half, middle + half), axis=-1)
