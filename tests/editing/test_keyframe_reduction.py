"""A tracker's stretch becomes a few keyframes that say the same within a tolerance."""

from __future__ import annotations

import numpy as np
import pytest
from people_on_a_floor_plan import FPS, VIEW, walking

from tracking.editing import (
    apply_change,
    keyframes_of,
    plan_add_keyframe,
    plan_interpolate,
    plan_thin,
)
from tracking.editing.boxes.floor_boxes import boxes_of, places_of
from tracking.editing.boxes.interpolation import Way
from tracking.editing.boxes.keyframe_reduction import thin_tracks
from tracking.errors import EditError
from tracking.tracks import Labels, Source, TrackTable


def strolling(frames: int = 400) -> TrackTable:
    """Somebody whose way bends, seen with a little noise."""
    rows = {name: column.copy() for name, column in walking(frames=frames).columns().items()}
    random = np.random.default_rng(3101)
    bend = 40 * np.sin(np.arange(frames) / 25)
    rows["left"] = rows["left"] + bend + random.normal(0, 0.5, frames)
    rows["x"] = rows["x"] + bend / 100
    return TrackTable(rows)


def off(table: TrackTable, before: dict[str, np.ndarray]) -> tuple[float, float]:
    now = table.of_track(1)
    edges = boxes_of(now) - boxes_of(before)
    edges[:, 2:] += edges[:, :2]
    return float(np.abs(edges).max()), float(np.abs(places_of(now) - places_of(before)).max())


@pytest.mark.parametrize("how", ["linear", "floor"])
def test_few_keyframes_are_left_and_no_box_is_off_by_more_than_was_allowed(how: str) -> None:
    table = strolling()
    before = table.of_track(1)
    change = plan_thin(table, 1, 0, None, 4.0, 0.1, how, view=VIEW, fps=FPS)  # type: ignore[arg-type]
    apply_change(table, Labels(), change)
    count = len(keyframes_of(table, 1))
    assert change.text == f"Thin 1 from frame 0 on to {count} keyframes of 400 boxes"
    assert 5 <= count <= 120
    edges, places = off(table, before)
    assert edges <= 4.0
    assert places <= 0.1


def test_a_larger_tolerance_leaves_fewer_keyframes() -> None:
    counts = []
    for tolerance in (2.0, 8.0, 32.0):
        table = strolling()
        apply_change(table, Labels(), plan_thin(table, 1, 0, None, tolerance, 1.0, "linear"))
        counts.append(len(keyframes_of(table, 1)))
    assert counts == sorted(counts, reverse=True)
    assert counts[0] > 2 * counts[2]


def test_only_the_stretch_is_thinned_and_keyframes_that_are_there_stay() -> None:
    table = strolling()
    apply_change(table, Labels(), plan_add_keyframe(table, 1, 137))
    apply_change(table, Labels(), plan_thin(table, 1, 100, 200, 30.0, 1.0))
    rows = table.of_track(1)
    assert rows["source"][:100].tolist() == rows["source"][200:300].tolist() == [0] * 100
    assert {100, 137, 199} <= set(keyframes_of(table, 1).tolist())
    assert Source.TRACKER not in rows["source"][100:200]


def test_a_way_on_the_floor_without_boxes_is_kept_within_the_tolerance() -> None:
    rows = {name: column.copy() for name, column in strolling().columns().items()}
    for name in ("left", "top", "width", "height"):
        rows[name][:] = np.nan
    table = TrackTable(rows)
    apply_change(table, Labels(), plan_thin(table, 1, 0, None, 3.0, 0.1))
    assert np.abs(places_of(table.of_track(1)) - places_of(rows)).max() <= 0.1


def test_no_known_number_is_lost_beside_unknown_ones() -> None:
    rows = {name: column.copy() for name, column in strolling().columns().items()}
    rows["x"][:30] = rows["x"][200:210] = rows["x"][-1] = np.nan
    rows["left"][300:320] = np.nan
    table = TrackTable(rows)
    apply_change(table, Labels(), plan_thin(table, 1, 0, None, 40.0, 2.0))
    assert len(keyframes_of(table, 1)) < 60
    for name in ("x", "left"):
        assert np.array_equal(np.isnan(table.of_track(1)[name]), np.isnan(rows[name]))


def test_interpolating_a_thinned_stretch_again_changes_nothing_of_note() -> None:
    table = strolling()
    apply_change(table, Labels(), plan_thin(table, 1, 0, None, how="linear"))
    before = boxes_of(table.of_track(1))
    apply_change(table, Labels(), plan_interpolate(table, 1, 0, 400, "linear", fps=FPS))
    assert boxes_of(table.of_track(1)) == pytest.approx(before)


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table: plan_thin(table, 1, 0, 2), "fewer than three boxes in frames 0 to 1"),
        (lambda table: plan_thin(table, 1, 0, 50, 0.0), "both are above 0"),
        (lambda table: plan_thin(table, 1, 0, 50, 1e-9, 1e-9), "allow a larger tolerance"),
    ],
)
def test_what_cannot_be_thinned_is_told(plan: object, why: str) -> None:
    with pytest.raises(EditError, match=why):
        plan(strolling())  # type: ignore[operator]


def test_a_long_track_is_thinned_in_few_rounds_over_its_rows() -> None:
    """Rounds grow with the logarithm of the length; were it squared, sixteen times as many."""
    short, long = (_rounds_to_thin(strolling(frames)) for frames in (625, 10_000))
    assert 5 < short < long < 3 * short


def _rounds_to_thin(table: TrackTable) -> int:
    reports: list[tuple[int, int]] = []
    way = Way(None, VIEW, FPS)
    thin_tracks(table.of_track(1), 3.0, way, lambda *done: reports.append(done))
    return len(reports) - 1
