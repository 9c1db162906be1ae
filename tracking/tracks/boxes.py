"""What boxes in the picture have in common: left, top, width, height in px, as tables have them.

Rectangles of body parts are corners and may be none: `on_part` is for those.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from tracking.arrays import Floats


def corners_of_boxes(boxes: Floats) -> Floats:
    """Corners (..., 4) of boxes (..., 4): left, top, right, bottom."""
    return np.concatenate((boxes[..., :2], boxes[..., :2] + boxes[..., 2:]), axis=-1)


def boxes_of_corners(corners: Floats) -> Floats:
    """Boxes (..., 4) between corners (..., 4)."""
    low, high = corners[..., :2], corners[..., 2:]
    return np.concatenate((low, high - low), axis=-1)


def corners_through(
    points_of: Callable[[Floats], Floats | Sequence[Floats]], corners: Floats
) -> Floats:
    """Corners (n, 4) of boxes in another picture, which is turned or bent against theirs.

    Args:
        points_of: gives the points there (4, n, 2) of points (4, n, 2): of the middles of the
            left sides, the upper, the right and the lower ones.
        corners: (n, 4) in this picture.
    """
    left, top, right, bottom = corners.T
    across, down = (left + right) / 2, (top + bottom) / 2
    sides = ((left, down), (across, top), (right, down), (across, bottom))
    there = points_of(np.stack([np.column_stack(side) for side in sides]))
    return np.column_stack([there[k][:, k % 2] for k in range(4)])


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
