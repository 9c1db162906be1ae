"""Swap, split, merge and reassign say what they will do and do just that."""

from __future__ import annotations

import numpy as np
import pytest
from tables_of_people import bytes_of, frames, table_of

from tracking.editing import (
    Change,
    State,
    apply_change,
    plan_delete,
    plan_merge_tracks,
    plan_reassign,
    plan_split,
    plan_swap,
)
from tracking.errors import EditError
from tracking.tracks import LARGEST_NUMBER, Labels, TrackLabel, TrackTable


@pytest.fixture
def table() -> TrackTable:
    return table_of({1: [(0, 10)], 2: [(2, 5), (8, 12)], 4: [(20, 25)]})


def apply(table: TrackTable, change: Change) -> None:
    apply_change(table, Labels(), change)


def lefts(table: TrackTable, track: int, start: int = 0, end: int | None = None) -> list[float]:
    return table.of_track(track, start, end)["left"].tolist()


def test_planning_changes_nothing(table: TrackTable) -> None:
    before = bytes_of(table)
    plan_swap(table, 1, 2, 4)
    plan_split(table, 1, 4)
    plan_merge_tracks(table, 1, [2])
    plan_reassign(table, 4, 1)
    assert bytes_of(table) == before


def test_a_swap_from_here_on_leaves_what_was_before(table: TrackTable) -> None:
    first, late_first, late_second = lefts(table, 1, 0, 4), lefts(table, 1, 4), lefts(table, 2, 4)
    change = plan_swap(table, 1, 2, 4)
    apply(table, change)
    assert change.text == "Swap 1 and 2 from frame 4 on"
    assert change.frame == 4
    assert lefts(table, 1) == first + late_second
    assert lefts(table, 2, 4) == late_first


def test_a_swap_in_a_range_ends_with_it(table: TrackTable) -> None:
    whole = lefts(table, 1)
    change = plan_swap(table, 1, 2, 3, 5)
    apply(table, change)
    assert change.text == "Swap 1 and 2 in frames 3 to 4"
    assert lefts(table, 2, 3, 5) == whole[3:5]
    assert lefts(table, 1, 5) == whole[5:]


def test_a_swap_in_one_frame_says_so(table: TrackTable) -> None:
    assert plan_swap(table, 1, 2, 3, 4).text == "Swap 1 and 2 in frame 3"


def test_a_swap_where_only_one_stands_hands_it_over(table: TrackTable) -> None:
    apply(table, plan_swap(table, 1, 4, 20))
    assert frames(table, 1)[-5:] == [20, 21, 22, 23, 24]
    assert 4 not in table


def test_a_split_keeps_the_id_before_the_cut(table: TrackTable) -> None:
    before, after = lefts(table, 1, 0, 6), lefts(table, 1, 6)
    change = plan_split(table, 1, 6)
    apply(table, change)
    assert change.text == "Split 1 at frame 6; the rest is 5"
    assert lefts(table, 1) == before
    assert lefts(table, 5) == after


def test_a_new_id_was_never_used_not_even_by_a_deleted_or_undone_track(table: TrackTable) -> None:
    apply(table, plan_delete(table, 4))
    split = plan_split(table, 1, 6)
    assert split.tracks == (1, 5)
    apply(table, split)
    apply(table, split.inverse)
    assert plan_split(table, 1, 6).tracks == (1, 6)


@pytest.mark.parametrize(("keep", "kept"), [("first", 1), ("second", 2)])
def test_a_merge_keeps_whom_it_was_told_to(table: TrackTable, keep: str, kept: int) -> None:
    both = [2, 3, 4, 8, 9]
    wanted = dict(zip(frames(table, kept), lefts(table, kept), strict=True))
    change = plan_merge_tracks(table, 1, [2], keep)  # type: ignore[arg-type]
    apply(table, change)
    assert change.text == f"Merge 2 into 1; where both stand (5 frames), {kept} is kept"
    assert 2 not in table
    assert frames(table, 1) == list(range(12))
    merged = lefts(table, 1)
    assert [merged[frame] for frame in both] == [wanted[frame] for frame in both]


def test_a_merge_takes_over_what_the_label_does_not_say(table: TrackTable) -> None:
    labels = Labels({2: TrackLabel("red coat", {"bag": "yes"}, "limps")})
    labels = labels.with_track(1, TrackLabel("", {"bag": "no"}, "tall"))
    merged = apply_change(table, labels, plan_merge_tracks(table, 1, [2], labels=labels))
    assert merged.tracks == {1: TrackLabel("red coat", {"bag": "no"}, "tall\nlimps")}


def test_a_reassigned_range_belongs_to_the_other_track(table: TrackTable) -> None:
    change = plan_reassign(table, 1, 2, 5, 8)
    apply(table, change)
    assert change.text == "Give 1 to 2 in frames 5 to 7"
    assert frames(table, 2) == list(range(2, 12))
    assert frames(table, 1) == [0, 1, 2, 3, 4, 8, 9]


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table: plan_swap(table, 1, 1, 0), "with itself"),
        (lambda table: plan_swap(table, 1, 9, 0), "track 9 is not in the table"),
        (lambda table: plan_swap(table, 1, 2, 30), "neither"),
        (lambda table: plan_swap(table, 1, 2, 12, 14), "1 nor 2 stands in frames 12 to 13"),
        (lambda table: plan_swap(table, 1, 2, 5, 5), "empty"),
        (lambda table: plan_swap(table, 1, 2, -1), "before frame 0"),
        (lambda table: plan_split(table, 1, 0), "cannot be split"),
        (lambda table: plan_split(table, 1, 10), "cannot be split"),
        (lambda table: plan_merge_tracks(table, 1, [1]), "with itself"),
        (lambda table: plan_merge_tracks(table, 1, [2], "third"), "keep is 'third'"),
        (lambda table: plan_reassign(table, 1, 1), "choose another"),
        (lambda table: plan_reassign(table, 1, 0), "ids are 1 to"),
        (lambda table: plan_reassign(table, 1, 2**31), "ids are 1 to"),
        (lambda table: plan_reassign(table, 1, 1_000_025), "far above 4.* up to 1000004"),
        (lambda table: plan_reassign(table, 1, 2), "both stand in frame 2"),
        (lambda table: plan_reassign(table, 1, 2, 15, 20), "does not stand in frames 15 to 19"),
    ],
)
def test_nonsense_is_refused_in_words(table: TrackTable, plan: object, why: str) -> None:
    with pytest.raises(EditError, match=why):
        plan(table)  # type: ignore[operator]


def test_a_change_planned_on_another_table_is_refused(table: TrackTable) -> None:
    change = plan_swap(table, 1, 2, 4)
    other = table_of({1: [(0, 10)]})
    before = bytes_of(other)
    with pytest.raises(EditError):
        apply(other, change)
    assert bytes_of(other) == before


def test_ids_beyond_16_bits_are_tracks_like_others() -> None:
    table = table_of({70_000: [(0, 5)], 4464: [(0, 5)]})  # the same lowest 16 bits
    first = lefts(table, 70_000)
    apply(table, plan_swap(table, 70_000, 4464, 2))
    assert lefts(table, 4464)[2:] == first[2:]
    assert np.array_equal(table.track_ids, [4464, 70_000])


def test_where_no_higher_id_is_left_nothing_is_split() -> None:
    table = table_of({LARGEST_NUMBER: [(0, 5)]})
    with pytest.raises(EditError, match="no id above"):
        plan_split(table, LARGEST_NUMBER, 2)


def test_a_change_to_an_id_that_no_file_can_hold_changes_nothing(table: TrackTable) -> None:
    before = bytes_of(table)
    here = State(np.array([[1, 0, 10]]))
    there = State(np.array([[2**31, 0, 10]]))
    with pytest.raises(EditError, match="ids go up to"):
        apply(table, Change("reassign", "too high", 0, here, there))
    assert bytes_of(table) == before
    assert frames(table, 1) == list(range(10))
