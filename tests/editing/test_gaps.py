"""Gaps are found, filled and marked as filled."""

from __future__ import annotations

import numpy as np
import pytest
from people_on_a_floor_plan import FPS, VIEW, walking
from tables_of_people import frames, table_of

from tracking.editing import (
    apply_change,
    gaps_of,
    plan_delete,
    plan_fill_gap,
    plan_fill_gaps,
    plan_merge_tracks,
    plan_move_box,
    plan_split,
)
from tracking.editing.boxes.floor_boxes import boxes_of, places_of
from tracking.editing.core.change import Change
from tracking.errors import EditError
from tracking.tracks import Labels, Source, TrackTable


@pytest.fixture
def table() -> TrackTable:
    return table_of({1: [(0, 3), (6, 8), (20, 22)], 2: [(1, 4), (5, 9)], 3: [(30, 33)]})


def do(table: TrackTable, change: Change) -> None:
    apply_change(table, Labels(), change)


def test_gaps_lie_between_the_first_and_the_last_row(table: TrackTable) -> None:
    assert gaps_of(table, 1) == ((3, 6), (8, 20))
    assert gaps_of(table, 3) == ()


def test_the_gap_looked_at_is_filled_and_marked_so(table: TrackTable) -> None:
    ends = table.of_track(1)["left"][[2, 3]]
    change = plan_fill_gap(table, 1, 4)
    assert change.text == "Fill the gap of 1 in frames 3 to 5"
    do(table, change)
    rows = table.of_track(1, 2, 7)
    assert rows["left"] == pytest.approx(np.linspace(*ends, 5))
    assert rows["source"].tolist() == [0, *[Source.INTERPOLATED] * 3, 0]
    assert gaps_of(table, 1) == ((8, 20),)


def test_all_short_gaps_of_several_people_are_filled_at_once(table: TrackTable) -> None:
    change = plan_fill_gaps(table, [2, 1, 3], 5)
    assert change.text == "Fill 2 gaps of 1, 2 and 3 of up to 5 frames"
    do(table, change)
    assert gaps_of(table, 1) == ((8, 20),)
    assert gaps_of(table, 2) == ()


def test_along_the_floor_the_one_who_was_hidden_walked_on() -> None:
    table = walking(speed=(0.5, 1.4))
    truth = table.of_track(1)
    do(table, plan_delete(table, 1, 10, 30))
    do(table, plan_fill_gap(table, 1, 20, view=VIEW, fps=FPS))
    assert places_of(table.of_track(1)) == pytest.approx(places_of(truth))
    assert boxes_of(table.of_track(1)) == pytest.approx(boxes_of(truth), abs=0.5)


def test_a_filled_gap_follows_when_its_end_is_moved(table: TrackTable) -> None:
    do(table, plan_fill_gap(table, 1, 4))
    do(table, plan_move_box(table, 1, 6, (50.0, 50.0, 50.0, 50.0)))
    rows = table.of_track(1, 2, 7)
    assert rows["left"] == pytest.approx(np.linspace(rows["left"][0], 50, 5))


def test_a_merge_fills_what_is_missing_between_the_two_and_nothing_else(table: TrackTable) -> None:
    change = plan_merge_tracks(table, 2, [3], fill=True)
    assert change.text == "Merge 3 into 2; 21 frames between them interpolated"
    do(table, change)
    assert gaps_of(table, 2) == ((4, 5),)
    assert np.unique(table.of_track(2, 9, 30)["source"]).tolist() == [Source.INTERPOLATED]


def test_a_track_that_was_cut_and_merged_again_is_what_it_was() -> None:
    table = walking()
    before = table.columns()
    do(table, plan_split(table, 1, 20))
    do(table, plan_merge_tracks(table, 1, [2], fill=True))
    for name, column in table.columns().items():
        assert np.array_equal(column, before[name])


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table: plan_fill_gap(table, 1, 1), "lies in no gap"),
        (lambda table: plan_fill_gap(table, 1, 25), "lies in no gap"),
        (lambda table: plan_fill_gaps(table, [1, 2], 0), "no gap of up to 0 frames"),
        (lambda table: plan_fill_gaps(table, [], 5), "no track is chosen"),
        (lambda table: plan_fill_gaps(table, [9], 5), "track 9 is not in the table"),
    ],
)
def test_where_there_is_no_gap_it_is_said(table: TrackTable, plan: object, why: str) -> None:
    before = frames(table, 1)
    with pytest.raises(EditError, match=why):
        plan(table)  # type: ignore[operator]
    assert frames(table, 1) == before
