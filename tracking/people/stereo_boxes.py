"""Boxes of another program's detector in both rectified cameras."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracking.arrays import Floats
from tracking.foreground import Subtraction
from tracking.geometry import Rectification
from tracking.people.box_bodies import paint_bodies, working_boxes
from tracking.people.detection_source import DetectionSource
from tracking.recording.frame import StereoFrame
from tracking.tracks.boxes import boxes_of_corners, corners_of_boxes, corners_through

_HEIGHTS_M = (1.3, 2.1)
"""Of whoever fills a box from head to foot, which tells how far away they are."""


def add_bodies(
    left: Subtraction,
    right: Subtraction,
    source: DetectionSource,
    frame: StereoFrame,
    rectification: Rectification,
    shrink: int,
) -> tuple[Subtraction, Subtraction]:
    """Both cameras with the bodies in the boxes as foreground, to be matched like all of it.

    Args:
        left, right: rectified, `shrink` px a pixel.
    """
    seen = rectified_boxes(source.of(frame.number).box, rectification)
    lag = frame.right_lag
    told = None if lag is None else source.of_right(frame.number + lag)
    if told is None:
        there = right_search_boxes(seen, rectification)
    else:
        there = rectified_boxes(told.box, rectification, right=True)
    masks = [
        paint_bodies(each.mask, working_boxes(boxes, shrink), 255, only=source.detections_only)
        for each, boxes in ((left, seen), (right, there))
    ]
    return replace(left, mask=masks[0]), replace(right, mask=masks[1])


def add_bodies_of_left(
    left: Subtraction,
    source: DetectionSource,
    frame: StereoFrame,
    rectification: Rectification,
    shrink: int,
) -> Subtraction:
    """The left camera, rectified, with the bodies in the boxes as foreground."""
    seen = working_boxes(rectified_boxes(source.of(frame.number).box, rectification), shrink)
    return replace(left, mask=paint_bodies(left.mask, seen, 255, only=source.detections_only))


def rectified_boxes(boxes: Floats, rectification: Rectification, *, right: bool = False) -> Floats:
    """(n, 4) left, top, width, height rectified px about boxes (n, 4) px as recorded.

    Args:
        right: whether they are the right camera's.
    """

    def rectified(points: Floats) -> Floats:
        flat = rectification.rectified_from_recorded(points.reshape(-1, 2), right=right)
        return flat.reshape(points.shape)

    corners = corners_through(rectified, corners_of_boxes(boxes))
    return boxes_of_corners(corners[np.isfinite(corners).all(axis=1)])


def right_search_boxes(boxes: Floats, rectification: Rectification) -> Floats:
    """(n, 4) what holds the people of rectified left boxes (n, 4) px in the right camera.

    How far away they are, and by that how far to the left, their height in the picture tells.
    """
    near, far = (
        rectification.baseline_m * boxes[:, 3] / height_m + rectification.disparity_offset_px
        for height_m in _HEIGHTS_M
    )
    return np.column_stack((boxes[:, 0] - near, boxes[:, 1], boxes[:, 2] + near - far, boxes[:, 3]))
