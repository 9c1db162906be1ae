"""Tracks made elsewhere as one edit of the corrected table."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from people_on_a_floor_plan import FPS, VIEW, walking
from tables_of_people import bytes_of, table_of

from tracking.editing import (
    apply_change,
    keyframes_of,
    on_the_floor,
    plan_import,
    plan_thin,
    thin_dense,
)
from tracking.editing.boxes.floor_boxes import boxes_of, places_of
from tracking.editing.core.selection import stack_rows
from tracking.editing.track_import import SeenAs
from tracking.errors import CancelledError, EditError
from tracking.geometry import View
from tracking.tracks import Columns, Labels, Source, TrackLabel, TrackTable

UNKNOWN = ("x", "y", "vx", "vy", "confidence", "visibility")


def rows_of(table: TrackTable, *tracks: int) -> dict[str, np.ndarray]:
    rows = table.columns()
    kept = np.isin(rows["track"], tracks)
    return {name: column[kept].copy() for name, column in rows.items()}


def taken(
    table: TrackTable,
    rows: Columns,
    labels: Labels | None = None,
    told: dict[int, TrackLabel] | None = None,
    view: View | None = None,
) -> Labels:
    said = labels or Labels()
    change = plan_import(table, said, rows, told or {}, "cvat.xml", view=view)
    return apply_change(table, said, change)


def test_tracks_absent_from_the_file_stay_to_the_bit() -> None:
    table = table_of({1: [(0, 5)], 2: [(0, 9)], 3: [(4, 6)]})
    before = rows_of(table, 1, 3)
    rows = rows_of(table, 2)
    rows["left"] += 5
    taken(table, rows)
    after = rows_of(table, 1, 3)
    assert {n: c.tobytes() for n, c in after.items()} == {n: c.tobytes() for n, c in before.items()}
    assert table.track_ids == (1, 2, 3)


def test_a_track_of_the_file_is_as_in_the_file_with_its_gaps() -> None:
    table = table_of({1: [(0, 10)]})
    rows = rows_of(table_of({1: [(2, 4), (7, 13)]}, seed=5), 1)
    taken(table, rows)
    assert table.frames_of_track(1).tolist() == [2, 3, 7, 8, 9, 10, 11, 12]
    assert np.array_equal(boxes_of(table.of_track(1)), boxes_of(rows))


def test_new_tracks_are_added_under_their_ids() -> None:
    table = table_of({1: [(0, 3)]})
    taken(table, rows_of(table_of({70: [(1, 4)]}), 70))
    assert table.track_ids == (1, 70)


def test_dust_of_other_tools_changes_nothing_and_the_rest_of_a_row_stays() -> None:
    table = table_of({1: [(0, 5)]})
    rows = rows_of(table, 1)
    for name in UNKNOWN:
        rows[name][:] = np.nan
    rows["top"] += 1e-9
    with pytest.raises(EditError, match="says what the corrected tracks say"):
        plan_import(table, Labels(), rows, {}, "t.txt")
    rows["top"][2] += 3
    change = plan_import(table, Labels(), rows, {}, "t.txt")
    assert change.after.rows["frame"].tolist() == [2]
    assert change.after.rows["confidence"][0] == table.of_track(1)["confidence"][2]
    assert change.text == "Import 1 from t.txt"


def test_a_place_goes_along_with_its_box_or_is_unknown() -> None:
    table = walking(frames=3)
    rows = rows_of(table, 1)
    for name in UNKNOWN:
        rows[name][:] = np.nan
    rows["left"][1] += 40
    stood = places_of(table.of_track(1))
    blind, seeing = table.snapshot(), table.snapshot()
    taken(blind, rows)
    assert np.isnan(places_of(blind.of_track(1))[1]).all()
    taken(seeing, rows, view=VIEW)
    now = places_of(seeing.of_track(1))
    assert now[1, 0] > stood[1, 0] + 0.05
    assert np.array_equal(now[[0, 2]], stood[[0, 2]])


def test_people_are_put_on_the_floor_by_their_feet() -> None:
    rows = rows_of(walking(frames=4), 1)
    stood = places_of(rows)
    rows["x"][:] = rows["y"][:] = np.nan
    assert np.abs(places_of(on_the_floor(rows, VIEW)) - stood).max() < 0.3


def occluded_or_not(visibility: np.ndarray, predicted: np.ndarray) -> np.ndarray:
    return np.where((visibility < 0.5) | predicted, 0.0, 1.0)


@pytest.mark.parametrize(
    ("seen_as", "told", "frames"),
    [
        (occluded_or_not, [1, 0, 0, 1], [1, 3]),
        (occluded_or_not, [1, 1, 0, 0], []),
        (None, [0.6, 0.5, 0.4, 0.3], [1]),
        (None, [1, 0.9, 0.2, 0.3], [0, 1, 2]),
    ],
)
def test_visibility_changes_where_the_file_says_other_than_it_was_given(
    seen_as: SeenAs | None, told: list[float], frames: list[int]
) -> None:
    table = table_of({1: [(0, 4)]})
    rows = rows_of(table, 1)
    rows["predicted"][:] = False
    rows["visibility"][:] = [0.6, 1.0, 0.4, 0.3]
    rows["predicted"][2] = True
    table = TrackTable(rows)
    rows["visibility"] = np.array(told, np.float32)
    rows["predicted"][:] = False
    told_name = {1: TrackLabel("red coat")}
    change = plan_import(table, Labels(), rows, told_name, "t", seen_as=seen_as)
    assert change.after.rows["frame"].tolist() == frames
    assert change.after.rows["visibility"].tolist() == rows["visibility"][frames].tolist()


def test_a_moved_box_keeps_the_visibility_its_grade_stands_for() -> None:
    rows = rows_of(table_of({1: [(0, 2)]}), 1)
    rows["visibility"][:], rows["predicted"][:] = 0.75, [False, True]
    table = TrackTable(rows)
    told = {**rows, "left": rows["left"] + 9, "predicted": np.zeros(2, bool)}
    told["visibility"] = np.array([1, 0], np.float32)
    change = plan_import(table, Labels(), told, {}, "t", seen_as=occluded_or_not)
    assert change.after.rows["visibility"].tolist() == [0.75, 0]


def test_a_tracker_s_rows_become_a_person_s_where_they_are_vouched_for_or_changed() -> None:
    table = table_of({1: [(0, 4)]})
    rows = rows_of(table, 1)
    rows["source"][:] = Source.PERSON
    rows["left"][1] += 9
    change = plan_import(table, Labels(), rows, {}, "t.xml")
    assert change.after.rows["frame"].tolist() == [1]
    vouched = plan_import(table, Labels(), rows, {}, "t.xml", vouched=True)
    assert vouched.after.rows["source"].tolist() == [Source.PERSON] * 4


def test_keyframes_go_and_come_between_interpolated_rows() -> None:
    rows = rows_of(table_of({1: [(0, 4)]}), 1)
    rows["source"][:] = [1, 2, 1, 1]
    table = TrackTable(rows)
    told = {**rows, "source": np.array([1, 1, 2, 1], np.uint8)}
    taken(table, told)
    assert keyframes_of(table, 1).tolist() == [0, 1, 3]


def test_a_file_without_keyframes_leaves_those_there_are() -> None:
    rows = rows_of(table_of({1: [(0, 4)]}), 1)
    table = TrackTable({**rows, "source": np.ones(4, np.uint8)})
    told = {**rows, "left": rows["left"] + [0, 0, 0, 9]}
    taken(table, told)
    assert keyframes_of(table, 1).tolist() == [0, 1, 2]


def test_names_and_attributes_join_those_there_are() -> None:
    table = table_of({1: [(0, 2)], 2: [(0, 2)]})
    labels = Labels().with_track(1, TrackLabel("red coat", {"bag": "yes", "hat": "no"}))
    told = {1: TrackLabel("", {"hat": "yes"}), 2: TrackLabel("guard")}
    after = taken(table, rows_of(table, 1, 2), labels, told=told)
    assert after.of_track(1) == TrackLabel("red coat", {"bag": "yes", "hat": "yes"})
    assert after.of_track(2) == TrackLabel("guard")


spans = st.dictionaries(
    st.integers(1, 5),
    st.lists(st.tuples(st.integers(0, 8), st.integers(1, 4)), min_size=1, max_size=2),
    min_size=1,
    max_size=4,
)


def made(found: dict[int, list[tuple[int, int]]], seed: int) -> TrackTable:
    ranges = {}
    for track, parts in found.items():
        frames = sorted({f for start, length in parts for f in range(start, start + length)})
        ranges[track] = [(frame, frame + 1) for frame in frames]
    return table_of(ranges, seed)


@settings(max_examples=60, deadline=None)
@given(spans, spans, st.integers(0, 3))
def test_an_import_is_undone_to_the_bit(
    own: dict[int, list[tuple[int, int]]], other: dict[int, list[tuple[int, int]]], seed: int
) -> None:
    table, rows = made(own, seed), made(other, seed + 1).columns()
    before = bytes_of(table)
    change = plan_import(table, Labels(), rows, {}, "f", view=VIEW)
    apply_change(table, Labels(), change)
    assert set(table.track_ids) == set(own) | set(other)
    for track in other:
        assert (
            table.frames_of_track(track).tolist() == rows["frame"][rows["track"] == track].tolist()
        )
    apply_change(table, Labels(), change.inverse)
    assert bytes_of(table) == before


def keyed_walk(frames: int = 120, source: int = Source.PERSON) -> dict[str, np.ndarray]:
    rows = rows_of(walking(frames=frames), 1)
    rows["left"] += 30 * np.sin(np.arange(frames) / 9)
    rows["source"][:] = source
    return rows


@pytest.mark.parametrize("tolerance", [0.5, 2.0, 10.0])
@pytest.mark.parametrize("source", [Source.PERSON, Source.TRACKER])
def test_a_dense_track_is_thinned_within_the_tolerance(tolerance: float, source: int) -> None:
    rows = keyed_walk(source=source)
    thin, told = thin_dense(rows, tolerance)
    off = boxes_of(thin) - boxes_of(rows)
    off[:, 2:] += off[:, :2]
    assert np.abs(off).max() <= tolerance
    keys = int(np.count_nonzero(thin["source"] == Source.PERSON))
    assert (told.tracks, told.boxes, told.keyframes) == (1, 120, keys)
    assert keys < 60
    assert set(np.unique(thin["source"])) == {Source.PERSON, Source.INTERPOLATED}


@pytest.mark.parametrize("view", [None, VIEW])
def test_many_tracks_are_thinned_as_each_of_them_alone(view: View | None) -> None:
    whole = [keyed_walk(60 + 9 * track, Source.TRACKER) for track in range(4)]
    for track, rows in enumerate(whole, 1):
        rows["track"][:] = track
        rows["width"] += track * np.cos(rows["frame"])
    rows = stack_rows(whole)
    table, told = TrackTable(rows), []
    thin, _ = thin_dense(rows, 2.0, view=view, fps=FPS, report=lambda *at: told.append(at))
    for track in table.track_ids:
        change = plan_thin(table, track, tolerance_px=2.0, view=view, fps=FPS)
        apply_change(table, Labels(), change)
    assert thin.keys() == table.columns().keys()
    for name, column in table.columns().items():
        np.testing.assert_allclose(thin[name], column, rtol=1e-6)
    assert told[0] == (0, len(rows["frame"]))
    assert told[-1] == (len(rows["frame"]), len(rows["frame"]))


def test_thinning_ends_where_it_is_cancelled() -> None:
    def cancel(_done: int, _total: int) -> None:
        raise CancelledError

    with pytest.raises(CancelledError):
        thin_dense(keyed_walk(), 2.0, report=cancel)


@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-50, 50), st.floats(0, 40)), min_size=3, max_size=40),
    st.floats(0.1, 30),
)
def test_no_edge_is_ever_farther_off_than_allowed(
    noise: list[tuple[float, float]], tolerance: float
) -> None:
    rows = keyed_walk(len(noise))
    shift, wider = np.array(noise).T
    rows["left"] += shift
    rows["width"] += wider
    thin, _ = thin_dense(rows, tolerance, view=VIEW, fps=FPS)
    off = boxes_of(thin) - boxes_of(rows)
    off[:, 2:] += off[:, :2]
    assert np.abs(off).max() <= tolerance + 1e-9
    assert np.array_equal(thin["frame"], rows["frame"])


def test_tracks_with_keyframes_of_their_own_and_short_ones_are_not_thinned() -> None:
    rows = keyed_walk()
    rows["source"][5:50] = Source.INTERPOLATED
    kept, told = thin_dense(rows, 5.0)
    assert told.tracks == 0
    assert {n: c.tobytes() for n, c in kept.items()} == {n: c.tobytes() for n, c in rows.items()}
    assert thin_dense(keyed_walk(2), 5.0)[1].tracks == 0


def test_a_tolerance_of_nothing_is_refused() -> None:
    with pytest.raises(EditError, match="above 0"):
        thin_dense(keyed_walk(), 0.0)
