"""Regions of people by the boxes of another program's detector, beside those of the foreground."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from tracking.arrays import Flags, Floats, Mask
from tracking.people.body_scale import Standing
from tracking.people.box_bodies import WIDE, body_in, working_boxes
from tracking.people.detections import Detections
from tracking.people.silhouettes import AnyLabels, Labels
from tracking.people.upright import SHADOW

_FULL = 0.35
"""Share of a body that is foreground from which on its pixels are the region."""
_HIDDEN = 0.1
"""Who shows less of the body than this is hidden by nearer ones."""
_MOST_OF_8_BITS = 255
_EDGE_PX = 2.0
"""A box that ends so near to the picture's lower edge goes on below it."""


def regions_of_boxes(boxes: Floats, kind: Mask) -> tuple[Labels, Flags]:
    """A region of the picture for each box: the foreground in it, else the body that fills it.

    Args:
        boxes: (n, 4) left, top, width, height working px.
        kind: (height, width) the foreground in kinds of `tracking.people.upright`, else 0.

    Returns:
        labels: (height, width) k + 1 for the pixels of the k-th of those shown; the nearer one,
            whose box ends lower, has what two could have.
        shown: (n,) whose body can be seen.
    """
    labels = np.zeros(kind.shape, np.uint8)
    size = np.ones(len(boxes))
    certain = ((kind > 0) & (kind != SHADOW)).view(np.uint8)
    for k in np.argsort(boxes[:, 1] + boxes[:, 3], kind="stable"):
        place, body = body_in(boxes[k], kind.shape)
        size[k] = max(cv2.countNonZero(body), 1)
        if cv2.countNonZero(certain[place] & body) >= _FULL * size[k]:
            place, body = body_in(boxes[k], kind.shape, WIDE)
            body &= certain[place]
        np.copyto(labels[place], np.uint8(k + 1), where=body > 0)
    pixels = np.bincount(labels.ravel(), minlength=len(boxes) + 1)[1:]
    shown = pixels >= _HIDDEN * size
    number = np.concatenate(([0], np.where(shown, np.cumsum(shown), 0))).astype(np.uint8)
    return number[labels], shown


def measure_from_boxes(
    people: Detections, boxes: Floats, standing: Standing, shrink: int
) -> Detections:
    """The people, the first of whom are those of boxes (k, 4) px as recorded, where these say.

    A detector's box is of the whole body, hidden or not.
    """
    count = len(boxes)
    if not count:
        return people
    left, top, width, height = working_boxes(boxes, shrink).T
    middle, foot = left + width / 2, top + height
    cut_off = foot >= people.regions.shape[0] / shrink - _EDGE_PX
    ends = np.column_stack((middle, top)), np.column_stack((middle, foot - 1.0))
    place = standing.positions(*ends, ~cut_off)
    position, box, size = people.position.copy(), people.box.copy(), people.size.copy()
    position[:count], box[:count] = place, boxes
    size[:count, 0] = width * standing.metres_per_pixel(place)
    size[:count, 1] = 2 * place[:, 2]
    from_detector = np.arange(len(people)) < count
    merged = people.merged & ~from_detector
    return replace(
        people, position=position, box=box, size=size, merged=merged, from_detector=from_detector
    )


def join_regions(first: Labels, other: Labels) -> AnyLabels:
    """The regions of one picture, then those of the other where the first has none.

    Of 8 bits, and of 16 where there are more regions than these tell apart.
    """
    last = int(first.max(initial=0))
    kept = (first > 0) | (other == 0)
    if last + int(other.max(initial=0)) <= _MOST_OF_8_BITS:
        return np.where(kept, first, other + np.uint8(last))
    return np.where(kept, first, other + np.uint16(last))
