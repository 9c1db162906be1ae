"""Bodies painted in boxes, and regions and associations made of boxes."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.people.body_scale import Standing
from tracking.people.box_bodies import body_in, in_boxes, paint_bodies, working_boxes
from tracking.people.box_regions import join_regions, regions_of_boxes
from tracking.people.region_features import described
from tracking.people.settings import PeopleSettings

SHAPE = (120, 160)
BOX = np.array((40.0, 20.0, 30.0, 80.0))
FULL = 255
SETTINGS = PeopleSettings()


def test_a_body_lies_in_its_box_and_fills_most_of_it() -> None:
    (rows, columns), body = body_in(BOX, SHAPE)
    assert rows.start >= 20
    assert rows.stop <= 102
    assert columns.start >= 40
    assert columns.stop <= 71
    assert 0.55 < body.sum() / BOX[2:].prod() < 0.85


@pytest.mark.parametrize("left", [-500.0, -20.0, 150.0, 900.0, 1e12])
def test_a_body_is_cut_off_at_the_edge_of_the_picture(left: float) -> None:
    place, body = body_in(np.array((left, 20.0, 30.0, 80.0)), SHAPE)
    assert np.zeros(SHAPE)[place].shape == body.shape


def test_bodies_are_painted_where_the_foreground_lacks_them_only() -> None:
    empty = np.zeros(SHAPE, np.uint8)
    painted = paint_bodies(empty, BOX[None], 200)
    assert painted.max() == 200
    seen = empty.copy()
    seen[40:100, 45:65] = FULL
    assert (paint_bodies(seen, BOX[None], 200) == seen).all()
    beside = seen.copy()
    beside[40:100, 100:140] = FULL
    assert (paint_bodies(beside, BOX[None], 200) == beside).all()
    assert (paint_bodies(beside, BOX[None], 200, only=True) == seen).all()
    assert (paint_bodies(empty, BOX[None], 200, only=True) == painted).all()


def test_somebody_is_in_a_box_by_its_middle_part() -> None:
    points = np.array(((55.0, 60.0), (42.0, 60.0), (55.0, 25.0), (np.nan, 60.0)))
    assert in_boxes(points, BOX[None]).tolist() == [True, False, False, False]
    assert not in_boxes(points, np.zeros((0, 4))).any()


def test_boxes_keep_their_edges_in_shrunk_pixels() -> None:
    assert working_boxes(np.array([[-0.5, 1.5, 4.0, 8.0]]), 2).tolist() == [[-0.5, 0.5, 2.0, 4.0]]


def test_regions_are_the_foreground_in_boxes_and_bodies_where_there_is_none() -> None:
    kind = np.zeros(SHAPE, np.uint8)
    kind[20:100, 48:62] = FULL
    boxes = np.array((BOX, BOX + np.array((60.0, 0.0, 0.0, 0.0))))
    labels, shown = regions_of_boxes(boxes, kind)
    assert shown.tolist() == [True, True]
    assert (kind[labels == 1] > 0).all()
    assert np.count_nonzero(labels == 2) == np.count_nonzero(body_in(boxes[1], SHAPE)[1])


def test_who_is_behind_a_nearer_box_altogether_is_not_shown() -> None:
    nearer = np.array((35.0, 10.0, 40.0, 100.0))
    labels, shown = regions_of_boxes(np.array((BOX, nearer)), np.zeros(SHAPE, np.uint8))
    assert shown.tolist() == [False, True]
    assert labels.max() == 1


def test_regions_of_the_foreground_are_numbered_after_those_of_boxes() -> None:
    first, other = np.zeros(SHAPE, np.uint8), np.zeros(SHAPE, np.uint8)
    first[:10] = 1
    other[5:20] = 1
    joined = join_regions(first, other)
    assert joined[7, 0] == 1
    assert joined[15, 0] == 2


def test_no_region_is_lost_where_there_are_more_than_8_bits_tell_apart() -> None:
    numbers = np.arange(150, dtype=np.uint8).reshape(10, 15) + np.uint8(1)
    own = np.kron(numbers, np.ones((12, 6), np.uint8))
    nobody = np.zeros_like(own)
    joined = join_regions(np.hstack((own, nobody)), np.hstack((nobody, own)))
    assert np.unique(joined).tolist() == list(range(1, 301))
    picture = np.full((*joined.shape, 3), 90, np.uint8)
    picture[:, 90:] = (200, 40, 40)
    people = described(joined, picture, (240, 360), Standing(None, 2, SETTINGS), SETTINGS)
    assert len(people) == 300
    assert people.regions[-1, -1] == 300
    assert people.box[299].tolist() == [347.5, 215.5, 12, 24]
    assert not np.isnan(people.clothes).any()
    blue = people.clothes[150:, :, 2]
    assert (blue < -30).all()
