from __future__ import annotations

import dataclasses

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from people_on_a_floor import view

from tracking.trackers.shared.tracker_base import TrackIds
from tracking.trackers.stereo.boxes import Bodies, overlap, share_in_view, visibility
from tracking.trackers.stereo.initiation import confirm_tracks
from tracking.trackers.stereo.population import empty_population

FRONT, BEHIND = [100.0, 100.0, 50.0, 150.0], [110.0, 60.0, 50.0, 150.0]


def test_the_one_behind_is_hidden_by_what_the_one_in_front_covers():
    shown = visibility(np.array([FRONT, BEHIND]), np.array([4.0, 5.0]), (640, 480))
    assert shown[0] == 1.0
    assert 0.35 < shown[1] < 0.5


def test_what_lies_outside_the_picture_is_not_seen():
    shown = visibility(np.array([[-25.0, 100.0, 50.0, 100.0]]), np.array([4.0]), (640, 480))
    np.testing.assert_allclose(shown, [0.5])


def test_overlap_is_the_largest_share_in_common_with_another():
    boxes = np.array([[0.0, 0, 10, 10], [5.0, 0, 10, 10], [100.0, 0, 10, 10]])
    np.testing.assert_allclose(overlap(boxes), [0.5, 0.5, 0.0])


def test_a_box_without_width_or_height_is_nowhere_and_overlaps_nothing():
    boxes = np.array([[5.0, 5, 0, 10], [5.0, 5, 10, 0], [0.0, 0, 20, 20]])
    np.testing.assert_array_equal(share_in_view(boxes, (640, 480)), [0.0, 0.0, 1.0])
    np.testing.assert_array_equal(overlap(boxes), 0.0)


@given(st.floats(-3, 3), st.floats(3, 12), st.floats(5, 80), st.floats(20, 300))
def test_an_outline_gives_back_the_box_it_was_taken_from(x, y, width, height):
    box, position = np.array([[200.0, 90.0, width, height]]), np.array([[x, y]])
    bodies = Bodies.at(position, view())
    np.testing.assert_allclose(bodies.boxes(bodies.outlines(box)), box, atol=1e-6)


def test_an_outline_moves_and_shrinks_with_its_person():
    box = view().box_of_person(np.array([[0.0, 4.0]]), 1.7, 0.5)
    outline = Bodies.at(np.array([[0.0, 4.0]]), view()).outlines(box)
    far = Bodies.at(np.array([[1.0, 9.0]]), view()).boxes(outline)
    expected = view().box_of_person(np.array([[1.0, 9.0]]), 1.7, 0.5)
    np.testing.assert_allclose(far, expected, atol=20.0)


def test_ids_go_on_from_the_last_one_and_only_to_people_seen_often_enough():
    empty = empty_population(10, 1, 4)
    columns = {
        field.name: np.zeros((5, *own.shape[1:]), own.dtype)
        for field in dataclasses.fields(empty)
        for own in (getattr(empty, field.name),)
    }
    columns["matches"] = np.array([1, 9, 3, 2, 3], np.int32)
    five = empty.replace(**columns)
    ids = TrackIds(7)
    assert confirm_tracks(five, 3, ids).track.tolist() == [0, 8, 9, 0, 10]
    assert ids.last == 10
