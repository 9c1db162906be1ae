"""Edits of several tracks at once, new tracks, and what is said of them."""

from __future__ import annotations

import numpy as np
import pytest
from people_on_a_floor_plan import VIEW
from tables_of_people import frames, table_of

from tracking.editing import (
    apply_change,
    plan_delete_tracks,
    plan_mark_occluded,
    plan_merge_tracks,
    plan_new_track,
    standing_box,
)
from tracking.editing.boxes.floor_boxes import boxes_of, places_of
from tracking.editing.core.change import Change
from tracking.editing.core.scope import tracks_text
from tracking.errors import EditError
from tracking.tracks import Labels, Source, TrackLabel, TrackTable


@pytest.fixture
def table() -> TrackTable:
    return table_of({1: [(0, 10)], 2: [(5, 15)], 3: [(8, 20)], 7: [(30, 40)]})


def do(table: TrackTable, change: Change) -> None:
    apply_change(table, Labels(), change)


@pytest.mark.parametrize(
    ("tracks", "said"),
    [
        ([4], "4"),
        ([4, 7], "4 and 7"),
        ([1, 2, 3, 4, 5], "1, 2, 3, 4 and 5"),
        ([1, 2, 3, 4, 5, 6], "1, 2, 3, 4 and 2 more"),
    ],
)
def test_tracks_are_told_in_words(tracks: list[int], said: str) -> None:
    assert tracks_text(tracks) == said


@pytest.mark.parametrize(
    ("start", "end", "text", "left"),
    [
        (0, None, "Delete tracks 1, 2 and 3", [[], [], []]),
        (9, None, "Delete 1, 2 and 3 from frame 9 on", [[*range(9)], [*range(5, 9)], [8]]),
        (6, 9, "Delete 1, 2 and 3 in frames 6 to 8",
         [[*range(6), 9], [5, *range(9, 15)], [*range(9, 20)]]),
        (0, 7, "Delete 1 and 2 in frames 0 to 6", [[7, 8, 9], [*range(7, 15)], [*range(8, 20)]]),
    ],
)  # fmt: skip
def test_several_are_deleted_in_one_scope(
    table: TrackTable, start: int, end: int | None, text: str, left: list[list[int]]
) -> None:
    change = plan_delete_tracks(table, [3, 1, 2, 1], start, end)
    assert change.text == text
    do(table, change)
    assert [frames(table, track) for track in (1, 2, 3)] == left
    assert frames(table, 7) == list(range(30, 40))


def test_several_become_one(table: TrackTable) -> None:
    rows = {}
    for track in (1, 2, 3):
        left = table.of_track(track)["left"].tolist()
        rows[track] = dict(zip(frames(table, track), left, strict=True))
    change = plan_merge_tracks(table, 2, [3, 1])
    assert change.text == (
        "Merge 3 and 1 into 2; where several stand (10 frames), the first of them is kept"
    )
    do(table, change)
    assert table.track_ids == (2, 7)
    wanted = {**rows[1], **rows[3], **rows[2]}
    assert table.of_track(2)["left"].tolist() == [wanted[frame] for frame in range(20)]


def test_where_both_stand_the_surer_row_can_be_kept(table: TrackTable) -> None:
    both = list(range(5, 10))
    a, b = table.of_track(1, 5, 10), table.of_track(2, 5, 10)
    change = plan_merge_tracks(table, 1, [2], "surer")
    assert change.text == "Merge 2 into 1; where both stand (5 frames), the surer row is kept"
    do(table, change)
    wanted = np.where(a["confidence"] >= b["confidence"], a["left"], b["left"])
    assert table.of_track(1, 5, 10)["left"].tolist() == wanted.tolist()
    assert len({*wanted} & {*a["left"]}) in range(1, len(both))  # some of each


def test_a_row_without_a_confidence_is_the_least_sure() -> None:
    rows = {
        name: column.copy()
        for name, column in table_of({1: [(0, 2)], 2: [(0, 2)]}).columns().items()
    }
    rows["confidence"][:] = [np.nan, 0.0, 0.5, np.nan]
    table = TrackTable(rows)
    wanted = [rows["left"][1], rows["left"][2]]
    do(table, plan_merge_tracks(table, 1, [2], "surer"))
    assert table.of_track(1)["left"].tolist() == wanted


def test_the_labels_of_several_become_one(table: TrackTable) -> None:
    labels = Labels({1: TrackLabel("red"), 3: TrackLabel("coat", {"bag": "yes"}, "tall")})
    change = plan_merge_tracks(table, 2, [3, 1], labels=labels)
    merged = apply_change(table, labels, change)
    assert merged.tracks == {2: TrackLabel("coat", {"bag": "yes"}, "tall")}
    assert apply_change(table, merged, change.inverse) == labels


def test_several_are_marked_as_occluded_and_visible_again(table: TrackTable) -> None:
    boxes = boxes_of(table.columns())
    change = plan_mark_occluded(table, [1, 3], 8, 12)
    assert change.text == "Mark 1 and 3 as occluded in frames 8 to 11"
    do(table, change)
    assert table.of_track(1, 8)["visibility"].tolist() == [0, 0]
    assert table.of_track(3, 8, 12)["visibility"].tolist() == [0] * 4
    assert table.of_track(3, 12)["visibility"].all()
    assert table.of_track(2)["visibility"].all()
    again = plan_mark_occluded(table, [3], 10, None, False)
    assert again.text == "Mark 3 as visible from frame 10 on"
    do(table, again)
    assert table.of_track(3)["visibility"][:3].tolist()[:2] == [0, 0]
    assert table.of_track(3, 10)["visibility"].tolist() == [1] * 10
    assert np.array_equal(boxes_of(table.columns()), boxes)


def test_only_rows_that_say_otherwise_are_in_the_change(table: TrackTable) -> None:
    do(table, plan_mark_occluded(table, [1], 0, 9))
    assert plan_mark_occluded(table, [1]).after.rows["frame"].tolist() == [9]


def test_a_new_track_begins_with_a_place_on_the_floor() -> None:
    table = table_of({4: [(0, 3)]})
    change = plan_new_track(table, 6, position=(0.5, 5.0), view=VIEW, height_m=1.6)
    assert change.text == "Draw new track 5 in frame 6"
    do(table, change)
    row = table.of_track(5)
    assert places_of(row).tolist() == [[0.5, 5.0]]
    assert boxes_of(row)[0] == pytest.approx(standing_box(VIEW, (0.5, 5.0), 1.6))
    assert row["source"].tolist() == [Source.PERSON]


def test_a_new_track_begins_with_a_box() -> None:
    table = table_of({4: [(0, 3)]})
    do(table, plan_new_track(table, 6, standing_box(VIEW, (0.5, 5.0), 1.75), view=VIEW))
    assert places_of(table.of_track(5))[0] == pytest.approx((0.5, 5.0), abs=1e-3)


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table: plan_delete_tracks(table, []), "no track is chosen"),
        (lambda table: plan_delete_tracks(table, [1, 9]), "track 9 is not in the table"),
        (
            lambda table: plan_delete_tracks(table, [1, 2], 20, 30),
            "1 and 2: no rows to delete in frames 20 to 29",
        ),
        (lambda table: plan_merge_tracks(table, 1, []), "at least one more track"),
        (lambda table: plan_merge_tracks(table, 1, [2, 2]), "track 2 with itself"),
        (lambda table: plan_merge_tracks(table, 1, [2, 1]), "track 1 with itself"),
        (lambda table: plan_mark_occluded(table, [1], 20), "no rows to mark from frame 20 on"),
        (lambda table: plan_mark_occluded(table, [1], 3, 3), "empty"),
        (lambda table: plan_new_track(table, 6), "needs a box"),
        (lambda table: plan_new_track(table, 6, position=(0, 5)), "and a calibration"),
        (lambda table: plan_new_track(table, 6, position=(0, -5), view=VIEW), "is none"),
    ],
)
def test_nonsense_of_several_is_refused_in_words(table: TrackTable, plan: object, why: str) -> None:
    with pytest.raises(EditError, match=why):
        plan(table)  # type: ignore[operator]


def test_what_is_marked_already_is_told(table: TrackTable) -> None:
    do(table, plan_mark_occluded(table, [1]))
    with pytest.raises(EditError, match="1: marked as occluded from frame 0 on already"):
        plan_mark_occluded(table, [1])
