"""Deleting rows, moving and drawing boxes."""

from __future__ import annotations

import numpy as np
import pytest
from tables_of_people import frames, table_of

from tracking.editing import apply_change, plan_delete, plan_draw_box, plan_move_box
from tracking.errors import EditError
from tracking.tracks import Labels, Source, TrackTable

BOX = (10.0, 20.0, 30.0, 40.0)


@pytest.fixture
def table() -> TrackTable:
    return table_of({1: [(0, 10)], 2: [(2, 5)]})


@pytest.mark.parametrize(
    ("start", "end", "text", "left"),
    [
        (0, None, "Delete track 1", []),
        (0, 99, "Delete track 1", []),
        (6, None, "Delete 1 from frame 6 on", [0, 1, 2, 3, 4, 5]),
        (2, 8, "Delete 1 in frames 2 to 7", [0, 1, 8, 9]),
        (3, 4, "Delete 1 in frame 3", [0, 1, 2, 4, 5, 6, 7, 8, 9]),
    ],
)
def test_a_deletion_says_its_scope(
    table: TrackTable, start: int, end: int | None, text: str, left: list[int]
) -> None:
    change = plan_delete(table, 1, start, end)
    apply_change(table, Labels(), change)
    assert change.text == text
    assert change.frame == start
    assert frames(table, 1) == left


def test_a_moved_box_comes_from_a_person(table: TrackTable) -> None:
    before = table.of_track(1, 4, 5)
    change = plan_move_box(table, 1, 4, BOX, (1.5, 2.5))
    apply_change(table, Labels(), change)
    row = table.of_track(1, 4, 5)
    assert [row[name][0] for name in ("left", "top", "width", "height")] == list(BOX)
    assert (row["x"][0], row["y"][0]) == (1.5, 2.5)
    assert row["source"][0] == Source.PERSON
    assert not row["predicted"][0]
    assert row["vx"][0] == before["vx"][0]


def test_a_moved_box_without_a_place_has_none(table: TrackTable) -> None:
    apply_change(table, Labels(), plan_move_box(table, 1, 4, BOX))
    assert np.isnan(table.of_track(1, 4, 5)["x"][0])


def test_a_drawn_box_begins_a_new_track(table: TrackTable) -> None:
    change = plan_draw_box(table, None, 7, BOX)
    apply_change(table, Labels(), change)
    assert change.text == "Draw new track 3 in frame 7"
    assert frames(table, 3) == [7]


def test_a_drawn_box_fills_a_track_s_gap(table: TrackTable) -> None:
    apply_change(table, Labels(), plan_draw_box(table, 2, 5, BOX))
    assert frames(table, 2) == [2, 3, 4, 5]


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table: plan_delete(table, 9), "track 9"),
        (lambda table: plan_delete(table, 1, 20), "no rows to delete"),
        (lambda table: plan_delete(table, 1, 5, 5), "empty"),
        (lambda table: plan_move_box(table, 2, 7, BOX), "draw a box there instead"),
        (lambda table: plan_move_box(table, 2, 3, (0, 0, 0, 5)), "positive width"),
        (lambda table: plan_move_box(table, 2, 3, (np.nan, 0, 5, 5)), "positive width"),
        (lambda table: plan_move_box(table, 2, 3, (0, 0, 5)), "positive width"),
        (lambda table: plan_move_box(table, 2, 3, BOX, (np.inf, 0)), "x and y in metres"),
        (lambda table: plan_draw_box(table, 2, 3, BOX), "move its box instead"),
        (lambda table: plan_draw_box(table, 2, -1, BOX), "negative"),
        (lambda table: plan_draw_box(table, 0, 1, BOX), "track 0"),
    ],
)
def test_nonsense_is_refused_in_words(table: TrackTable, plan: object, why: str) -> None:
    with pytest.raises(EditError, match=why):
        plan(table)  # type: ignore[operator]


@pytest.mark.parametrize(
    ("track", "frame", "why"),
    [
        (0, 5, "ids are 1 to"),
        (2**31, 5, "ids are 1 to"),
        (2**31 - 1, 5, "far above"),
        (1, 2**31 - 1, "go up to"),
    ],
)
def test_a_box_of_an_id_or_frame_that_no_file_can_hold_is_refused(
    table: TrackTable, track: int, frame: int, why: str
) -> None:
    with pytest.raises(EditError, match=why):
        plan_draw_box(table, track, frame, BOX)
