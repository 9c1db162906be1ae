"""Boxes, their corners, and where they are in another picture."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.tracks.boxes import boxes_of_corners, corners_of_boxes, corners_through

BOXES = np.array([[10.0, 20.0, 30.0, 60.0], [-5.5, 0.25, 8.0, 16.0]])


def test_boxes_and_corners_are_turned_into_each_other() -> None:
    corners = corners_of_boxes(BOXES)
    assert corners.tolist() == [[10, 20, 40, 80], [-5.5, 0.25, 2.5, 16.25]]
    assert boxes_of_corners(corners).tolist() == BOXES.tolist()


def test_corners_in_another_picture_are_where_the_middles_of_the_sides_are() -> None:
    def bent(points: Floats) -> Floats:
        u, v = points[..., 0], points[..., 1]
        return np.stack((2 * u + v, v - u / 2), axis=-1)

    found = corners_through(bent, corners_of_boxes(BOXES[:1]))
    (left, top, right, bottom), across, down = (10, 20, 40, 80), 25, 50
    assert found.tolist() == [
        [2 * left + down, top - across / 2, 2 * right + down, bottom - across / 2]
    ]


def test_what_the_other_picture_does_not_show_has_no_corner_there() -> None:
    unseen = np.array([np.nan, 1.0])
    found = corners_through(lambda points: points * unseen, corners_of_boxes(BOXES))
    assert np.isnan(found[:, ::2]).all()
    assert found[:, 1::2].tolist() == [[20, 80], [0.25, 16.25]]
