"""Jumps between boxes that a person made are not flagged; all others are, however near."""

from __future__ import annotations

import numpy as np
import pytest
from walks_on_a_floor import FPS, SIZE, Walk, made_run, straight

from tracking.editing import apply_change, plan_interpolate, plan_move_box, plan_thin
from tracking.review import ReviewItem, find_review_items
from tracking.tracks import PART_COLUMNS, Labels, Run, TrackTable


def slid(**aside_m: float) -> Run:
    """A track that slides aside at frames, e.g. f60=0.5."""
    path = straight((-3, 5), (1, 0), 120)
    for frame, metres in aside_m.items():
        path[int(frame[1:]) :] += (0.0, metres)
    return made_run([Walk(path)])


def moved(run: Run, frames: range | list[int], aside_m: float = 0.0) -> TrackTable:
    """The run's tracks with boxes put aside by hand, or confirmed where they are."""
    table = TrackTable(run.tracks)
    for frame in frames:
        x, y = (float(table.of_track(1, frame, frame + 1)[name][0]) for name in ("x", "y"))
        change = plan_move_box(table, 1, frame, (200, 90, 30, 90), (x, y + aside_m))
        apply_change(table, Labels(), change)
    return table


def found(run: Run, table: TrackTable | None = None) -> tuple[ReviewItem, ...]:
    tracks = TrackTable(run.tracks) if table is None else table
    return find_review_items(tracks, run, FPS, size=SIZE)


def jumps(run: Run, table: TrackTable) -> list[int]:
    return [one.frame for one in found(run, table) if one.kind == "jump"]


def test_a_jump_between_two_boxes_that_a_person_moved_is_not_flagged() -> None:
    run = slid(f60=0.5)
    assert jumps(run, TrackTable(run.tracks)) == [60]
    assert jumps(run, moved(run, [59, 60])) == []


def test_a_jump_between_a_moved_and_an_interpolated_box_is_not_flagged() -> None:
    run = slid(f60=0.3)
    table = moved(run, [59, 61])
    assert jumps(run, table) == [60]
    apply_change(table, Labels(), plan_interpolate(table, 1, 59, 62))
    assert jumps(run, table) == []


def test_what_was_kept_while_thinning_was_looked_at() -> None:
    run = slid(f60=1.0)
    table = TrackTable(run.tracks)
    apply_change(table, Labels(), plan_thin(table, 1, how="linear"))
    assert jumps(run, table) == []


@pytest.mark.parametrize(
    ("boxes", "aside_m", "told"),
    [
        ([57], 0.0, 60),
        ([59], 0.0, 60),
        ([60], 0.0, 60),
        ([60], -0.5, 61),
        (range(60, 63), -0.5, 63),
        (range(50, 60), 0.5, 50),
    ],
)
def test_where_a_corrected_stretch_meets_the_tracker_s_rows_a_jump_is_flagged(
    boxes: range | list[int], aside_m: float, told: int
) -> None:
    """The last box put right stands next to the first that is wrong: there is work left."""
    run = slid(f60=0.5)
    assert jumps(run, moved(run, boxes, aside_m)) == [told]


@pytest.mark.parametrize("own", [50, 54, 66, 70])
def test_a_greater_jump_that_a_person_made_hides_no_lesser_one_near_it(own: int) -> None:
    run = slid(f60=0.5, **{f"f{own}": 1.5})
    assert jumps(run, moved(run, [own - 1, own])) == [60]


@pytest.mark.parametrize("own", [51, 54, 66, 69])
def test_a_box_moved_far_and_back_is_flagged_itself_beside_the_tracker_s_jump(own: int) -> None:
    run = slid(f60=0.5)
    assert any(abs(frame - own) <= 1 for frame in jumps(run, moved(run, [own], 1.5)))


@pytest.mark.parametrize(
    ("kind", "predicted", "boxes"),
    [
        ("drift", range(80, 160), [79]),
        ("predicted", range(30, 80), [80]),
        ("reversal", range(76, 84), [79, 80]),
        ("part", (), [79]),
    ],
)
def test_what_is_no_jump_is_flagged_whoever_made_the_boxes(
    kind: str, predicted: range, boxes: list[int]
) -> None:
    """A box says nothing of a part, nor of who is out of sight beside it."""
    path = straight((-3, 5), (1.2, 0), 160)
    if kind == "reversal":
        path[80:] = path[80] - (path[80:] - path[80])
    run = made_run([Walk(path, predicted=predicted)])
    if kind == "part":
        rows = {name: np.zeros(1, dtype) for name, dtype in PART_COLUMNS.items()}
        rows["frame"][:], rows["track"][:], rows["failed"][:] = 80, 1, True
        run.parts.update(rows)
    assert kind in {one.kind for one in found(run)}
    assert kind in {one.kind for one in found(run, moved(run, boxes))}
