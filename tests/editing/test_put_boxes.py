"""Boxes that are put at once: one, the same over some frames, those of several people."""

from __future__ import annotations

import numpy as np
import pytest
from tables_of_people import bytes_of, frames, table_of

from tracking.editing import (
    apply_change,
    is_by_hand,
    plan_draw_box,
    plan_propagate,
    plan_put_box,
    plan_put_boxes,
)
from tracking.errors import EditError
from tracking.tracks import Labels, Source, TrackTable

BOX = (10.0, 20.0, 30.0, 40.0)
RIGHT = (50.0, 20.0, 30.0, 40.0)
SIDES = ("left", "top", "width", "height")


@pytest.fixture
def drawn() -> TrackTable:
    """Track 1, drawn by hand in frame 2."""
    table = TrackTable()
    apply_change(table, Labels(), plan_draw_box(table, None, 2, BOX))
    return table


def _box(table: TrackTable, track: int, frame: int) -> list[float]:
    row = table.of_track(track, frame, frame + 1)
    return [float(row[name][0]) for name in SIDES]


def _sources(table: TrackTable, track: int) -> list[int]:
    return table.of_track(track)["source"].tolist()


def test_a_box_put_later_is_joined_to_the_one_before_by_interpolation(drawn) -> None:
    apply_change(drawn, Labels(), plan_put_box(drawn, 1, 6, RIGHT))
    assert frames(drawn, 1) == [2, 3, 4, 5, 6]
    key, between = Source.PERSON, Source.INTERPOLATED
    assert _sources(drawn, 1) == [key, between, between, between, key]
    assert _box(drawn, 1, 4) == [30.0, *BOX[1:]]


def test_a_box_put_where_there_is_one_moves_it(drawn) -> None:
    change = plan_put_box(drawn, 1, 2, RIGHT)
    apply_change(drawn, Labels(), change)
    assert _box(drawn, 1, 2) == list(RIGHT)
    assert change.text == "Move the box of 1 in frame 2"


def test_a_box_of_nobody_begins_a_track(drawn) -> None:
    apply_change(drawn, Labels(), plan_put_box(drawn, None, 2, RIGHT))
    assert frames(drawn, 2) == [2]


def test_what_a_tracker_found_is_not_joined_to_a_box() -> None:
    table = table_of({1: [(0, 3)]})
    assert not is_by_hand(table, 1)
    apply_change(table, Labels(), plan_put_box(table, 1, 6, BOX))
    assert frames(table, 1) == [0, 1, 2, 6]
    assert is_by_hand(table, 1)


def test_boxes_of_several_are_one_edit_that_is_undone_bit_for_bit(drawn) -> None:
    apply_change(drawn, Labels(), plan_put_box(drawn, None, 3, RIGHT))
    before = bytes_of(drawn)
    change = plan_put_boxes(drawn, 5, {1: RIGHT, 2: BOX})
    apply_change(drawn, Labels(), change)
    assert frames(drawn, 1) == [2, 3, 4, 5]
    assert frames(drawn, 2) == [3, 4, 5]
    assert change.text == "Put boxes of 1 and 2 in frame 5"
    apply_change(drawn, Labels(), change.inverse)
    assert bytes_of(drawn) == before


def test_no_boxes_are_no_edit(drawn) -> None:
    with pytest.raises(EditError, match="no boxes"):
        plan_put_boxes(drawn, 5, {})


def test_a_box_is_copied_onto_the_frames_up_to_the_end_of_the_range(drawn) -> None:
    change = plan_propagate(drawn, 1, 2, 7)
    apply_change(drawn, Labels(), change)
    assert frames(drawn, 1) == [2, 3, 4, 5, 6]
    assert all(_box(drawn, 1, frame) == list(BOX) for frame in range(2, 7))
    assert _sources(drawn, 1) == [1, 2, 2, 2, 1]
    assert change.text == "Copy the box of 1 in frame 2 up to frame 6"


def test_moving_the_last_copy_takes_those_between_along(drawn) -> None:
    apply_change(drawn, Labels(), plan_propagate(drawn, 1, 2, 7))
    apply_change(drawn, Labels(), plan_put_box(drawn, 1, 6, RIGHT))
    assert _box(drawn, 1, 4) == [30.0, *BOX[1:]]


def test_copies_end_before_a_keyframe_and_what_hangs_on_it_follows(drawn) -> None:
    apply_change(drawn, Labels(), plan_put_box(drawn, 1, 12, RIGHT))
    apply_change(drawn, Labels(), plan_propagate(drawn, 1, 2, 8))
    assert _box(drawn, 1, 7) == list(BOX)
    assert _box(drawn, 1, 12) == list(RIGHT)
    assert np.isclose(_box(drawn, 1, 10)[0], 10 + 40 * 3 / 5)
    apply_change(drawn, Labels(), plan_propagate(drawn, 1, 7, 30))
    assert frames(drawn, 1)[-1] == 12
    assert _box(drawn, 1, 11) == list(BOX)


@pytest.mark.parametrize(
    ("track", "frame", "end", "why"),
    [(1, 2, 3, "no frame to copy"), (1, 4, 9, "does not stand"), (9, 2, 9, "track 9")],
)
def test_a_box_that_cannot_be_copied_says_why(drawn, track, frame, end, why) -> None:
    with pytest.raises(EditError, match=why):
        plan_propagate(drawn, track, frame, end)


def test_copying_onto_copies_changes_nothing_and_says_so(drawn) -> None:
    apply_change(drawn, Labels(), plan_propagate(drawn, 1, 2, 7))
    with pytest.raises(EditError, match="no frame to copy"):
        plan_propagate(drawn, 1, 5, 7)
