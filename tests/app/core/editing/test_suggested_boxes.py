"""Ghosts of people without a box, and found boxes that may be theirs."""

import numpy as np
import pytest

from app.core.editing.suggested_boxes import (
    find_ghost,
    ghosts_before,
    suggest_boxes,
    suggestion_at,
    unclaimed,
)
from tracking.editing import apply_change, plan_put_box
from tracking.tracks import CORRECTED_COLUMNS, Labels, TrackTable

FPS = 10.0


def _table(*boxes: tuple[int, int, float]) -> TrackTable:
    """Boxes of 20 x 60 px drawn by hand: track, frame, left."""
    table = TrackTable()
    for track, frame, left in boxes:
        known = track if track in table else None
        box = (left, 10.0, 20.0, 60.0)
        apply_change(table, Labels(), plan_put_box(table, known, frame, box))
    return table


def _tracked() -> TrackTable:
    rows = {name: np.zeros(2, dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    rows["frame"][:], rows["track"][:] = (0, 1), 1
    rows["width"][:], rows["height"][:] = 20, 60
    return TrackTable(rows)


def test_a_ghost_is_the_last_box_and_is_expected_where_the_person_was_going():
    ghost = find_ghost(_table((1, 0, 0.0), (1, 5, 20.0)), 1, 10, FPS)
    assert (ghost.frame, ghost.box[0]) == (5, 20.0)
    assert ghost.expected == pytest.approx((40.0, 10.0, 20.0, 60.0))


def test_before_the_first_box_the_ghost_is_the_first():
    ghost = find_ghost(_table((1, 20, 50.0), (1, 30, 60.0)), 1, 15, FPS)
    assert (ghost.frame, ghost.box[0]) == (20, 50.0)
    assert ghost.expected[0] == pytest.approx(45.0)


@pytest.mark.parametrize(("track", "frame"), [(1, 0), (1, 51), (2, 1), (0, 1)])
def test_who_has_a_box_or_left_long_ago_has_no_ghost(track, frame):
    assert find_ghost(_table((1, 0, 0.0)), track, frame, FPS) is None


def test_those_who_were_tracked_are_left_out_where_only_drawn_ones_are_meant():
    assert ghosts_before(_tracked(), 3, FPS, drawn_only=True) == ()
    assert [ghost.track for ghost in ghosts_before(_tracked(), 3, FPS)] == [1]
    drawn = _table((1, 0, 0.0))
    assert [one.track for one in ghosts_before(drawn, 3, FPS, drawn_only=True)] == [1]


def test_boxes_that_a_track_has_or_another_source_found_are_left_out():
    there = np.array([[0.0, 0, 20, 60], [np.nan] * 4])
    first = np.array([[2.0, 0, 20, 60], [100, 0, 20, 60]])
    second = np.array([[103.0, 2, 20, 60], [200, 0, 20, 60], [np.nan] * 4])
    assert [box[0] for box in unclaimed([first, second], there).boxes] == [100, 200]


def test_boxes_go_to_those_who_together_are_nearest_and_far_ones_to_nobody():
    table = _table((1, 0, 0.0), (2, 0, 25.0))
    ghosts = ghosts_before(table, 1, FPS)
    left, right, far = (12.0, 10, 20, 60), (37.0, 10, 20, 60), (200.0, 10, 20, 60)
    found = suggest_boxes([right, left, far], ghosts)
    assert [one.track for one in found] == [2, 1, 0]


def test_a_box_of_quite_another_size_is_nobody_s():
    ghosts = ghosts_before(_table((1, 0, 0.0)), 1, FPS)
    assert suggest_boxes([(0.0, 0, 40, 120)], ghosts)[0].track == 0


def test_of_boxes_around_a_place_the_smallest_is_meant():
    found = suggest_boxes([(0.0, 0, 100, 100), (10.0, 10, 20, 20)], ())
    assert suggestion_at(found, 15, 15).box[2] == 20
    assert suggestion_at(found, 90, 90).box[2] == 100
    assert suggestion_at(found, 200, 0) is None


def test_who_walks_out_of_the_picture_is_expected_no_more():
    ghost = find_ghost(_table((1, 0, 20.0), (1, 5, 0.0)), 1, 12, FPS)
    assert not ghost.is_inside((100, 100))
    assert find_ghost(_table((1, 0, 20.0), (1, 5, 0.0)), 1, 6, FPS).is_inside((100, 100))


def test_a_box_on_somebody_who_is_there_is_not_suggested_for_who_is_missing_beside_them():
    ghosts = ghosts_before(_table((4, 0, 0.0)), 10, FPS)
    there = np.array([[12.0, 10, 20, 60]])
    loose = (12.0, 6, 40, 66)  # around the body of who is there, yet overlapping it too little
    found = unclaimed([np.array([loose])], there)
    assert found.boxes == (loose,)
    assert suggest_boxes(found.boxes, ghosts)[0].track == 1
    assert suggest_boxes(found.boxes, ghosts, found.alone) == ()


def test_who_is_there_with_a_box_of_their_own_takes_no_other():
    there = np.array([[12.0, 10, 20, 60]])
    found = unclaimed([np.array([[12.0, 10, 20, 60], [0.0, 10, 20, 60]])], there)
    assert found.alone == ()
    assert [box[0] for box in found.boxes] == [0]
