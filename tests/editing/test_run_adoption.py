"""Taking what a run found: what a person touched stays, nobody is doubled, nobody is lost."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from runs_of_people import FPS, Walk, bits, done, places, rows_of, run_of, table_of
from tables_of_people import bytes_of

from tracking.editing import (
    Change,
    Difference,
    History,
    apply_change,
    differences,
    find_protected,
    plan_delete,
    plan_mark_reviewed,
    plan_move_box,
    plan_swap,
    plan_take,
)
from tracking.errors import EditError
from tracking.tracks import (
    LARGEST_NUMBER,
    Columns,
    Labels,
    ReviewedRange,
    Run,
    TrackLabel,
    TrackTable,
)

TWO = [(1, 0, 100, 0.0), (2, 0, 100, 1.0)]
WALKS = st.lists(
    st.tuples(st.integers(1, 5), st.integers(0, 20), st.integers(1, 12), st.integers(0, 4)),
    min_size=1,
    max_size=8,
)


def walks_of(drawn: list[tuple[int, int, int, int]]) -> list[Walk]:
    """People who stand in a frame at most once, each in a lane of their own there."""
    kept: list[Walk] = []
    ids: set[tuple[int, int]] = set()
    lanes: set[tuple[int, int]] = set()
    for track, start, length, lane in drawn:
        frames = range(start, start + length)
        if any((f, track) in ids or (f, lane) in lanes for f in frames):
            continue
        ids |= {(f, track) for f in frames}
        lanes |= {(f, lane) for f in frames}
        kept.append((track, start, start + length, float(lane)))
    return kept


def taken(
    table: TrackTable,
    run: Run,
    frames: tuple[int, int] | None = None,
    tracks: Sequence[int] | None = None,
    *,
    labels: Labels | None = None,
    history: History | None = None,
    only: Sequence[Difference] | None = None,
) -> TrackTable:
    """The table after a take, as a copy."""
    labels, history = labels or Labels(), history or History()
    change = plan_take(table, labels, history, run, frames, tracks, only=only, fps=FPS)
    after = table.snapshot()
    assert apply_change(after, labels, change) is labels or labels.parts
    return after


def test_a_run_that_says_the_same_has_nothing_to_take():
    table = table_of(TWO)
    with pytest.raises(EditError, match="nothing to take from frame 0 on: the run says the same"):
        plan_take(table, Labels(), History(), run_of(TWO, (0, 100)), None)


def test_frames_outside_the_range_stay_as_they_are():
    table = table_of(TWO)
    after = taken(table, run_of([(1, 0, 100, 0.2), (2, 0, 100, 1.0)], (0, 100)), (40, 60))
    assert [lane for _, lane in places(after, 1)] == [0.0] * 40 + [0.2] * 20 + [0.0] * 40
    assert places(after, 2) == places(table, 2)


def test_a_frame_range_the_run_was_not_run_over_is_refused():
    with pytest.raises(EditError, match="frames 200 to 299 are not in the run, which is over"):
        plan_take(table_of(TWO), Labels(), History(), run_of(TWO, (0, 100)), (200, 300))


def test_ids_of_a_run_of_its_own_are_matched_by_where_people_stand():
    table = table_of(TWO, highest=9)
    run = run_of([(7, 0, 120, 0.1), (1, 0, 100, 1.1), (3, 50, 100, 3.0)], (0, 120))
    after = taken(table, run)
    assert after.track_ids == (1, 2, 10)
    assert after.frame_range(1) == (0, 120)
    assert {lane for _, lane in places(after, 2)} == {1.1}
    assert {lane for _, lane in places(after, 10)} == {3.0}


def test_ids_a_run_went_on_with_stay_even_where_the_table_says_otherwise():
    table = table_of([(1, 0, 50, 0.0), (2, 0, 50, 1.0), (2, 50, 100, 0.0), (1, 50, 100, 1.0)])
    after = taken(table, run_of([(1, 50, 100, 0.0), (2, 50, 100, 1.0)], (50, 100), known=2))
    assert {lane for _, lane in places(after, 1)} == {0.0}
    assert {lane for _, lane in places(after, 2)} == {1.0}


def test_somebody_who_enters_later_keeps_the_corrected_id():
    table = table_of([*TWO, (3, 70, 100, 2.0)])
    again = [(1, 50, 100, 0.1), (2, 50, 100, 1.1), (4, 68, 100, 2.1)]
    after = taken(table, run_of(again, (50, 100), known=3))
    assert after.track_ids == (1, 2, 3)
    assert after.frame_range(3) == (68, 100)


def test_a_person_on_a_protected_row_is_not_there_twice():
    table = table_of([*TWO, (3, 50, 100, 2.0)])
    labels = Labels(reviewed=(ReviewedRange(3, 50, 80),))
    again = [(1, 40, 100, 0.0), (2, 40, 100, 1.0), (4, 45, 100, 2.1)]
    after = taken(table, run_of(again, (40, 100), known=3), labels=labels)
    assert after.track_ids == (1, 2, 3)
    assert places(after, 3) == (
        [(f, 2.1) for f in range(45, 50)]
        + [(f, 2.0) for f in range(50, 80)]
        + [(f, 2.1) for f in range(80, 100)]
    )


def test_who_is_not_the_protected_person_of_that_id_is_somebody_new():
    table = table_of([*TWO, (3, 0, 100, 2.0)])
    labels = Labels(reviewed=(ReviewedRange(3, 50, 80),))
    again = [(1, 40, 100, 0.0), (2, 40, 100, 1.0), (3, 40, 100, 4.0), (4, 45, 100, 2.1)]
    after = taken(table, run_of(again, (40, 100), known=3), labels=labels)
    assert {lane for frame, lane in places(after, 3) if frame >= 50} == {2.0, 2.1}
    (stranger,) = {
        int(rows["track"][rows["x"] == 4.0][0]) for rows in map(after.of_frame, range(50, 100))
    }
    assert stranger > 3


def test_a_protected_row_says_who_somebody_is_from_there_on():
    """The run changed 1 and 2 over; a person had reviewed them later on."""
    table = table_of(TWO)
    labels = Labels(reviewed=(ReviewedRange(0, 60, 70),))
    swapped = [(1, 40, 100, 1.05), (2, 40, 100, 0.05)]
    after = taken(table, run_of(swapped, (40, 100), known=2), labels=labels)
    assert {lane for frame, lane in places(after, 1) if frame >= 60} == {0.0, 0.05}
    assert {lane for frame, lane in places(after, 2) if frame >= 60} == {1.0, 1.05}


def test_somebody_new_is_from_the_first_who_protected_rows_say():
    table = table_of([(1, 0, 100, 0.0), (2, 30, 50, 1.0), (3, 50, 100, 1.0)])
    labels = Labels(reviewed=(ReviewedRange(2, 40, 50), ReviewedRange(3, 50, 60)))
    again = [(1, 20, 100, 0.0), (4, 28, 100, 1.1)]
    after = taken(table, run_of(again, (20, 100), known=3), labels=labels)
    assert after.frame_range(2) == (28, 50)
    assert after.frame_range(3) == (50, 100)


def test_deleted_people_do_not_come_back_under_another_id():
    table, history = table_of([*TWO, (3, 20, 90, 3.0)]), History()
    done(table, Labels(), history, plan_delete(table, 3))
    again = [(1, 10, 100, 0.1), (2, 10, 100, 1.1), (4, 20, 90, 3.05)]
    after = taken(table, run_of(again, (10, 100), known=3), history=history)
    assert after.track_ids == (1, 2)


def test_a_deleted_double_does_not_keep_the_person_away():
    table, history = table_of([*TWO, (3, 20, 90, 0.2)]), History()
    done(table, Labels(), history, plan_delete(table, 3))
    after = taken(
        table, run_of([(1, 10, 100, 0.1), (2, 10, 100, 1.1)], (10, 100), known=3), history=history
    )
    assert {lane for frame, lane in places(after, 1) if frame >= 10} == {0.1}


def test_names_and_labels_stay():
    table = table_of(TWO)
    labels = Labels({1: TrackLabel("red coat")}, reviewed=(ReviewedRange(2, 0, 5),))
    change = plan_take(table, labels, History(), run_of([(1, 0, 90, 0.1)], (0, 100), 2), None)
    assert apply_change(table, labels, change) == labels


def test_one_track_alone_is_taken_where_that_loses_nobody():
    after = taken(table_of(TWO), run_of([(1, 0, 100, 0.1), (2, 0, 100, 1.1)], (0, 100)), tracks=[2])
    assert {lane for _, lane in places(after, 1)} == {0.0}
    assert {lane for _, lane in places(after, 2)} == {1.1}


def test_one_of_two_that_change_over_is_not_taken_alone():
    run = run_of([(1, 0, 100, 1.0), (2, 0, 100, 0.0)], (0, 100), known=2)
    with pytest.raises(EditError, match="nothing to take"):
        taken(table_of(TWO), run, tracks=[1])
    after = taken(table_of(TWO), run, tracks=[1, 2])
    assert {lane for _, lane in places(after, 1)} == {1.0}


def test_only_the_differences_chosen_are_taken():
    table = table_of(TWO)
    run = run_of([(1, 0, 60, 0.0), (2, 0, 100, 1.0), (3, 10, 30, 4.0)], (0, 100), known=2)
    found = differences(table, Labels(), History(), run, None, fps=FPS)
    added = [each for each in found if each.kind == "added"]
    assert len(found) == 2
    after = taken(table, run, only=added)
    assert after.frame_range(1) == (0, 100)
    assert after.frame_range(3) == (10, 30)


def test_tracks_without_metres_are_told_by_their_boxes():
    rows = rows_of(TWO)
    for name in ("x", "y"):
        rows[name][:] = np.nan
    run = run_of([], (0, 100), tracks={**rows, "track": 3 - rows["track"]})
    order = np.lexsort((run.tracks["track"], run.tracks["frame"]))
    run = run_of([], (0, 100), tracks={n: c[order] for n, c in run.tracks.items()})
    with pytest.raises(EditError, match="says the same"):
        taken(TrackTable(rows), run)


def test_a_take_is_told_in_words():
    run = run_of([(1, 0, 100, 0.1), (2, 0, 100, 1.0)], (0, 100))
    change = plan_take(table_of(TWO), Labels(), History(), run, (20, 50))
    assert change.kind == "take"
    assert change.text == "Take 1 in frames 20 to 49, from the run of stereo-direction"
    assert change.frame == 20


def drawn_edit(data: st.DataObject, table: TrackTable, labels: Labels) -> Change | None:
    """Any edit; None where what was drawn is nonsense on this table."""
    a, b, start = data.draw(st.tuples(*[st.integers(1, 5)] * 2, st.integers(0, 30)))
    end = data.draw(st.none() | st.integers(start + 1, 35))
    plans = (
        lambda: plan_swap(table, a, b, start, end),
        lambda: plan_delete(table, a, start, end),
        lambda: plan_mark_reviewed(labels, data.draw(st.integers(0, 5)), start, end or 40),
        lambda: plan_move_box(table, a, start, (1.0, 2.0, 3.0, 4.0), (9.0, 9.0)),
    )
    try:
        return data.draw(st.sampled_from(plans))()
    except EditError:
        return None


def corrected(data: st.DataObject, walks: list[Walk]) -> tuple[TrackTable, Labels, History]:
    """A table that somebody worked on."""
    table, labels, history = table_of(walks), Labels(), History()
    for _ in range(data.draw(st.integers(0, 4))):
        change = drawn_edit(data, table, labels)
        if change is not None:
            labels = done(table, labels, history, change)
    return table, labels, history


@settings(max_examples=150, deadline=None)
@given(st.data(), WALKS, WALKS, st.sampled_from((0, 5)))
def test_protected_rows_stay_to_the_bit_and_undo_brings_all_back(
    data: st.DataObject,
    drawn: list[tuple[int, int, int, int]],
    others: list[tuple[int, int, int, int]],
    known: int,
):
    table, labels, history = corrected(data, walks_of(drawn))
    start = data.draw(st.integers(0, 20))
    run = run_of(walks_of(others), (0, 40), known)
    before, protection = bytes_of(table), find_protected(table, labels, history, fps=FPS)
    tracks = data.draw(st.none() | st.sets(st.integers(1, 8)))
    try:
        change = plan_take(table, labels, history, run, (start, 40), tracks, fps=FPS)
    except EditError:
        return
    rows = table.columns()
    kept = protection.covers(rows["track"], rows["frame"]) | (rows["frame"] < start)
    assert apply_change(table, labels, change) == labels
    now = table.columns()
    TrackTable(now)  # still a table, nobody twice in a frame
    still = protection.covers(now["track"], now["frame"]) | (now["frame"] < start)
    assert bits({n: c[still] for n, c in now.items()}) == bits(
        {n: c[kept] for n, c in rows.items()}
    )
    apply_change(table, labels, change.inverse)
    assert bytes_of(table) == before


@settings(max_examples=100, deadline=None)
@given(st.data(), WALKS, WALKS, st.sampled_from((0, 5)))
def test_nobody_stands_where_somebody_protected_does(
    data: st.DataObject,
    drawn: list[tuple[int, int, int, int]],
    others: list[tuple[int, int, int, int]],
    known: int,
):
    table, labels, history = corrected(data, walks_of(drawn))
    run = run_of(walks_of(others), (0, 40), known)
    try:
        change = plan_take(table, labels, history, run, None, fps=FPS)
    except EditError:
        return
    crowded = doubles(table)
    apply_change(table, labels, change)
    assert doubles(table) <= crowded


@settings(max_examples=100, deadline=None)
@given(st.data(), WALKS, WALKS, st.sampled_from((0, 5)))
def test_nobody_whom_both_sides_see_is_lost(
    data: st.DataObject,
    drawn: list[tuple[int, int, int, int]],
    others: list[tuple[int, int, int, int]],
    known: int,
):
    table, labels, history = corrected(data, walks_of(drawn))
    run = run_of(walks_of(others), (0, 40), known)
    tracks = data.draw(st.none() | st.sets(st.integers(1, 8)))
    seen_by_both = spots(table.columns()) & spots(run.tracks)
    try:
        change = plan_take(table, labels, history, run, None, tracks, fps=FPS)
    except EditError:
        return
    apply_change(table, labels, change)
    assert seen_by_both <= spots(table.columns())


def spots(rows: Columns) -> set[tuple[int, float, float]]:
    """Where somebody stands in which frame."""
    places = (rows["x"].round(2).tolist(), rows["y"].round(2).tolist())
    return set(zip(rows["frame"].tolist(), *places, strict=True))


def doubles(table: TrackTable) -> int:
    """How many frames have two people at one place."""
    rows = table.columns()
    spots = np.column_stack((rows["frame"], rows["x"].round(2), rows["y"].round(2)))
    return len(spots) - len(np.unique(spots, axis=0))


@settings(max_examples=60, deadline=None)
@given(WALKS, st.integers(0, 20), st.sampled_from((0, 5)))
def test_taking_everything_from_an_identical_run_changes_nothing(
    drawn: list[tuple[int, int, int, int]], start: int, known: int
):
    walks = walks_of(drawn)
    table = table_of(walks, highest=5)
    assert differences(table, Labels(), History(), run_of(walks, (0, 40), known), (start, 40)) == ()
    with pytest.raises(EditError, match="nothing to take"):
        plan_take(table, Labels(), History(), run_of(walks, (0, 40), known), (start, 40))


def test_an_ended_track_does_not_go_on():
    table, history = table_of(TWO), History()
    done(table, Labels(), history, plan_delete(table, 1, 50))
    found = find_protected(table, Labels(), history, fps=FPS)
    assert found.of_track(1).tolist() == [[50, LARGEST_NUMBER]]
    again = run_of([(1, 30, 100, 0.0), (2, 30, 100, 1.1)], (30, 100), known=2)
    assert taken(table, again, history=history).frame_range(1) == (0, 50)
