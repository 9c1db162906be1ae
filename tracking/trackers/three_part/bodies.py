"""People's boxes in the picture, from their parts and from the regions they are seen in."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.three_part.people import Flags, Floats
from tracking.tracks.boxes import common_px2, corners_of_boxes

_ROUND = 0.95
"""An inner rectangle's size, as a share of the half extent of the part it lies in: a part whose
pixels lie evenly reaches 0.87 of the rectangle's size from its middle, a round one 1.0."""
_LEGS_BELOW = 1.45
"""How far below the hip-leg rectangle's middle the soles are: it is the upper half of the legs."""
_OUTLINE_MEMORY_S = 0.5
_RISEN_MEMORY_S = 0.4
_SUNK_MEMORY_S = 5.0


def parts_boxes(rectangles: Floats) -> Floats:
    """(people, 4) left, top, right, bottom of bodies, from the parts (people, parts, 4) alone.

    [ZhaoLee2009] takes the bounding box of the inner rectangles. They are smaller than the person
    by design, so this is the bounding box of the parts they stand for.
    """
    reach = _ROUND * rectangles[..., 2:]
    low, high = rectangles[..., :2] - reach, rectangles[..., :2] + reach
    box = np.concatenate((low.min(axis=1), high.max(axis=1)), axis=1)
    if rectangles.shape[1] > 1:
        box[:, 3] = rectangles[:, -1, 1] + _LEGS_BELOW * rectangles[:, -1, 3]
    return box


def outlined_boxes(rectangles: Floats, outline: Floats) -> Floats:
    """(people, 4) left, top, width, height: the boxes of the parts with people's own outlines."""
    box = parts_boxes(rectangles)
    box = box + outline * _height(box)
    size = np.maximum(box[:, 2:] - box[:, :2], 1.0)
    return np.concatenate((box[:, :2], size), axis=1)


def outlines_seen(rectangles: Floats, seen: Floats) -> Floats:
    """(people, 4) the outlines with which the parts' boxes are those seen (people, 4)."""
    box = parts_boxes(rectangles)
    return np.clip((corners_of_boxes(seen) - box) / _height(box), -0.5, 0.5)


def outlines_after(
    outline: Floats,
    rectangles: Floats,
    seen: Floats,
    alone: Flags,
    elapsed_s: float,
    age_s: Floats,
) -> Floats:
    """The outlines (people, 4) after a frame, learnt of those seen alone.

    Args:
        age_s: (people,) since they were begun; at first the outline is the mean of all seen.
    """
    share = 1.0 - np.exp(-elapsed_s / _OUTLINE_MEMORY_S)
    share = np.maximum(share, elapsed_s / np.maximum(age_s + elapsed_s, 1e-6))
    share = np.where(age_s <= 0.0, 1.0, share)[alone, None]
    new = outline.copy()
    own = outlines_seen(rectangles[alone], seen[alone])
    new[alone] += share * (own - outline[alone])
    return new


def heights_after(height: Floats, seen: Floats, whole: Flags, elapsed_s: float) -> Floats:
    """The upright heights (people,) px after a frame, learnt of those seen whole (people, 4).

    They follow slowly down, so that somebody who crouches stays as high as standing.
    """
    memory_s = np.where(seen[:, 3] > height, _RISEN_MEMORY_S, _SUNK_MEMORY_S)
    share = np.where(whole, 1.0 - np.exp(-elapsed_s / memory_s), 0.0)
    return np.asarray(height + share * (seen[:, 3] - height))


def covered_shares(box: Floats, other: Floats) -> Floats:
    """(people, others) the share of each box (people, 4) that lies in each other box."""
    common = common_px2(box[:, None], other[None])
    return np.asarray(common / np.maximum(np.prod(box[:, 2:], axis=1)[:, None], 1e-9))


def _height(box: Floats) -> NDArray[np.float64]:
    return np.maximum(box[:, 3:] - box[:, 1:2], 1.0)
