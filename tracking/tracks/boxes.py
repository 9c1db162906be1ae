"""What boxes in the picture have in common: left, top, width, height in px, as tables have them.

Rectangles of body parts are corners and may be none: `on_part` is for those.
"""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats


def common_px2(one: Floats, other: Floats) -> Floats:
    """(...) px that boxes (..., 4) have in common; NaN where one of them is unknown."""
    low = np.maximum(one[..., :2], other[..., :2])
    high = np.minimum(one[..., :2] + one[..., 2:], other[..., :2] + other[..., 2:])
    side = np.maximum(high - low, 0.0)
    return np.asarray(side[..., 0] * side[..., 1])


def share_inside(box: Floats, size: tuple[int, int]) -> Floats:
    """(n,) the share of each box (n, 4) that lies in a picture of this width and height."""
    low = np.clip(box[:, :2], 0.0, size)
    high = np.clip(box[:, :2] + box[:, 2:], 0.0, size)
    return np.asarray(np.prod(high - low, axis=1) / np.maximum(np.prod(box[:, 2:], axis=1), 1e-9))


def overlaps(one: Floats, other: Floats) -> Floats:
    """(...) intersection over union of boxes (..., 4); 0 where it cannot be said."""
    common = common_px2(one, other)
    union = np.prod(one[..., 2:], axis=-1) + np.prod(other[..., 2:], axis=-1) - common
    share = np.divide(common, union, out=np.zeros(common.shape), where=union > 0)
    return np.asarray(np.nan_to_num(share))
