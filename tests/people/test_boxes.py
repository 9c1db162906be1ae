"""Boxes of whole bodies from what is seen of them."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.geometry import Camera, Ground, View
from tracking.people.boxes import (
    behind_things,
    full_body_boxes,
    hidden_sides,
    region_boxes,
    standing_boxes,
    with_feet,
)

SEEN = np.array([[100.0, 50, 40, 60]])
STANDING = np.array([[98.0, 48, 44, 120]])
REACH = np.array([[80.0, 40, 80, 140]])


def hidden(*sides: bool) -> np.ndarray[tuple[int, int], np.dtype[np.bool_]]:
    return np.array([sides])


def test_a_region_seen_whole_keeps_its_box() -> None:
    box = full_body_boxes(SEEN, STANDING, REACH, hidden(False, False, False, False))
    np.testing.assert_array_equal(box, SEEN)


def test_a_hidden_side_is_taken_from_where_the_person_stands() -> None:
    box = full_body_boxes(SEEN, STANDING, REACH, hidden(False, False, False, True))
    np.testing.assert_array_equal(box, [[100, 50, 40, 118]])


def test_pixels_beyond_a_bodys_reach_do_not_stretch_its_box() -> None:
    wide = np.array([[20.0, 50, 300, 60]])
    box = full_body_boxes(wide, STANDING, REACH, hidden(False, False, False, False))
    np.testing.assert_array_equal(box, [[80, 50, 80, 60]])


def test_unseen_feet_draw_the_box_down_to_where_they_stand() -> None:
    feet = np.array([[110.0, 150, 20, 10]])
    np.testing.assert_array_equal(with_feet(SEEN, feet, np.array([True])), [[100, 50, 40, 110]])
    np.testing.assert_array_equal(with_feet(SEEN, feet, np.array([False])), SEEN)


def test_a_body_behind_the_camera_leaves_the_seen_box() -> None:
    nowhere = np.full((1, 4), np.nan)
    box = full_body_boxes(SEEN, nowhere, nowhere, hidden(True, True, True, True))
    np.testing.assert_array_equal(box, SEEN)


def test_the_box_of_a_standing_body_spans_from_its_feet_to_its_head() -> None:
    matrix = np.array([[510.0, 0, 320], [0, 510, 240], [0, 0, 1]])
    view = View(Camera(matrix, np.zeros(5), 640, 480), Ground(2.4, 30.0))
    box = standing_boxes(view, np.array([[0.0, 5.0]]), np.array([1.8]), 0.5)[0]
    feet, head = view.pixel_from_world(np.array([[0, 5, 0], [0, 5, 1.8]]))
    assert box[1] == pytest.approx(head[1], abs=4)
    assert box[1] + box[3] == pytest.approx(feet[1], abs=8)
    assert box[0] + box[2] / 2 == pytest.approx(320, abs=1)


def test_region_boxes_leave_specks_out() -> None:
    labels = np.zeros((40, 60), np.uint8)
    labels[10:30, 20:30] = 1
    labels[35, 55] = 1
    assert region_boxes(labels, 2) == [(20, 10, 10, 20), (0, 0, 0, 0)]


def test_somebody_nearer_hides_a_side_and_somebody_farther_does_not() -> None:
    labels = np.zeros((40, 60), np.uint8)
    labels[10:30, 20:30] = 1
    labels[12:38, 30:40] = 2
    sight = np.array([[0, 6], [0, 4]], np.float32)
    sides, truncated = hidden_sides(labels, region_boxes(labels, 2), sight)
    np.testing.assert_array_equal(sides, [[False, False, True, False], [False] * 4])
    assert not truncated.any()


def test_somebody_nearer_who_stands_beside_with_a_gap_between_hides_nothing() -> None:
    labels = np.zeros((40, 60), np.uint8)
    leaning = np.arange(10, 30)
    for row in leaning:
        labels[row, row : row + 10] = 1
        labels[row, row + 13 : row + 22] = 2
    sight = np.array([[0, 6], [0, 4]], np.float32)
    sides, _ = hidden_sides(labels, region_boxes(labels, 2), sight)
    assert not sides.any()


def test_the_pictures_edge_hides_a_side() -> None:
    labels = np.zeros((40, 60), np.uint8)
    labels[0:20, 50:60] = 1
    sides, truncated = hidden_sides(labels, region_boxes(labels, 1), np.array([[0, 5]], np.float32))
    np.testing.assert_array_equal(sides, [[False, True, True, False]])
    assert truncated.all()


def test_a_region_that_ends_at_a_nearer_thing_goes_on_behind_it_and_before_a_wall_does_not() -> (
    None
):
    scene = np.full((60, 80), 4.0, np.float32)
    scene[:, 40:50] = 12.0
    before_the_wall, beside_the_pillar = (10, 10, 8, 30), (32, 10, 8, 30)
    sides = behind_things([before_the_wall, beside_the_pillar], scene, np.array([8.0, 8.0]))
    np.testing.assert_array_equal(sides, [[False] * 4, [False, False, True, False]])
