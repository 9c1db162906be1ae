"""Between keyframes people are interpolated, and follow when one is moved, added or let go."""

from __future__ import annotations

import numpy as np
import pytest
from people_on_a_floor_plan import FPS, VIEW, walking
from tables_of_people import frames, table_of

from tests.pace import spent
from tracking.editing import (
    apply_change,
    body_position,
    keyframes_of,
    plan_add_keyframe,
    plan_delete,
    plan_delete_keyframe,
    plan_draw_box,
    plan_interpolate,
    plan_mark_occluded,
    plan_move_box,
    standing_box,
)
from tracking.editing.boxes.floor_boxes import (
    body_boxes,
    body_heights,
    body_positions,
    boxes_of,
    places_of,
)
from tracking.editing.core.change import Change
from tracking.errors import EditError
from tracking.synthesis import SCENES
from tracking.synthesis.rig import Rig
from tracking.tracks import Labels, Source, TrackTable

BOX = (100.0, 50.0, 40.0, 120.0)
FAR = (200.0, 70.0, 60.0, 100.0)


def do(table: TrackTable, change: Change) -> None:
    apply_change(table, Labels(), change)


def annotated(keys: tuple[int, ...] = (0, 10, 20)) -> TrackTable:
    """Track 1 drawn in a few frames and interpolated straight between them."""
    table = TrackTable()
    do(table, plan_draw_box(table, None, keys[0], BOX, (0.0, 4.0)))
    for count, frame in enumerate(keys[1:], 1):
        box = (BOX[0] + 10 * count, *BOX[1:])
        do(table, plan_draw_box(table, 1, frame, box, (0.5 * count, 4.0), fps=FPS, join=True))
    return table


def lefts(table: TrackTable, start: int, end: int) -> list[float]:
    return table.of_track(1, start, end)["left"].tolist()


def test_drawing_keyframes_one_after_another_fills_what_is_between() -> None:
    table = annotated()
    rows = table.of_track(1)
    assert rows["frame"].tolist() == list(range(21))
    assert keyframes_of(table, 1).tolist() == [0, 10, 20]
    assert np.unique(np.delete(rows["source"], [0, 10, 20])).tolist() == [Source.INTERPOLATED]
    assert rows["left"] == pytest.approx(np.linspace(100, 120, 21))
    assert rows["x"] == pytest.approx(np.linspace(0, 1, 21))
    assert rows["vx"][1:20] == pytest.approx(1.0)


def test_a_box_drawn_alone_fills_nothing() -> None:
    table = annotated((0, 5))
    change = plan_draw_box(table, 1, 30, BOX)
    assert change.text == "Draw a box of 1 in frame 30"
    do(table, change)
    assert frames(table, 1) == [*range(6), 30]


def test_moving_a_keyframe_takes_both_neighbouring_stretches_along_and_no_other() -> None:
    table = annotated((0, 10, 20, 30))
    outside = lefts(table, 20, 31)
    change = plan_move_box(table, 1, 10, (210.0, *BOX[1:]), (0.5, 4.0))
    assert change.text == "Move the box of 1 in frame 10; 18 frames around it interpolated"
    do(table, change)
    assert lefts(table, 0, 11) == pytest.approx(np.linspace(100, 210, 11))
    assert lefts(table, 10, 21) == pytest.approx(np.linspace(210, 120, 11))
    assert lefts(table, 20, 31) == outside


@pytest.mark.parametrize(
    ("box", "text"),
    [
        ((210.0, 60.0, *BOX[2:]), "Move the box of 1 in frame 10"),
        ((BOX[0], BOX[1], 44.0, BOX[3]), "Resize the box of 1 in frame 10"),
        ((90.0, 40.0, 60.0, 130.0), "Resize the box of 1 in frame 10"),
    ],
)
def test_a_box_that_is_another_size_afterwards_was_resized(
    box: tuple[float, float, float, float], text: str
) -> None:
    table = annotated((10,))
    assert plan_move_box(table, 1, 10, box).text == text


def test_moving_an_interpolated_box_makes_a_keyframe() -> None:
    table = annotated((0, 10))
    do(table, plan_move_box(table, 1, 4, (140.0, *BOX[1:])))
    assert keyframes_of(table, 1).tolist() == [0, 4, 10]
    assert lefts(table, 0, 5) == pytest.approx(np.linspace(100, 140, 5))
    assert lefts(table, 4, 11) == pytest.approx(np.linspace(140, 110, 7))


def test_a_tracker_s_rows_beside_a_moved_box_stay() -> None:
    table = table_of({1: [(0, 10)]})
    before = lefts(table, 0, 10)
    do(table, plan_move_box(table, 1, 4, BOX))
    before[4] = BOX[0]
    assert lefts(table, 0, 10) == before


def test_what_was_deleted_between_keyframes_stays_deleted() -> None:
    table = annotated((0, 10))
    do(table, plan_delete(table, 1, 3, 6))
    do(table, plan_move_box(table, 1, 10, (200.0, *BOX[1:])))
    assert frames(table, 1) == [0, 1, 2, 6, 7, 8, 9, 10]
    assert lefts(table, 0, 3) == pytest.approx([100, 110, 120])


def test_what_was_marked_as_occluded_stays_so_when_a_keyframe_moves() -> None:
    table = annotated((0, 10))
    do(table, plan_mark_occluded(table, [1], 3, 6))
    do(table, plan_move_box(table, 1, 10, (200.0, *BOX[1:])))
    assert table.of_track(1)["visibility"].tolist() == [1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1]


def test_a_keyframe_let_go_is_interpolated_from_its_neighbours() -> None:
    table = annotated((0, 10, 20))
    do(table, plan_move_box(table, 1, 10, (300.0, *BOX[1:])))
    change = plan_delete_keyframe(table, 1, 10)
    assert change.text == "Delete the keyframe of 1 in frame 10"
    do(table, change)
    assert keyframes_of(table, 1).tolist() == [0, 20]
    assert lefts(table, 0, 21) == pytest.approx(np.linspace(100, 120, 21))


def test_the_last_keyframe_let_go_takes_along_what_hung_on_it() -> None:
    table = annotated((0, 10, 20))
    change = plan_delete_keyframe(table, 1, 20)
    assert change.text.endswith("in frame 20, and the 9 frames interpolated from it")
    do(table, change)
    assert frames(table, 1) == list(range(11))


def test_a_lonely_keyframe_let_go_is_gone_and_fills_no_gap() -> None:
    table = annotated((0, 5))
    do(table, plan_draw_box(table, 1, 30, BOX))
    do(table, plan_draw_box(table, 1, 40, BOX))
    do(table, plan_delete_keyframe(table, 1, 30))
    assert frames(table, 1) == [*range(6), 40]


def test_a_keyframe_added_moves_nothing() -> None:
    table = annotated((0, 10))
    before = boxes_of(table.of_track(1))
    do(table, plan_add_keyframe(table, 1, 4))
    assert keyframes_of(table, 1).tolist() == [0, 4, 10]
    assert np.array_equal(boxes_of(table.of_track(1)), before)


def test_a_tracker_s_rows_between_keyframes_are_replaced_and_its_gaps_filled() -> None:
    table = table_of({1: [(0, 5), (8, 13)], 2: [(0, 13)]})
    do(table, plan_move_box(table, 1, 9, BOX))
    ends = lefts(table, 2, 3) + lefts(table, 9, 10) + lefts(table, 11, 12)
    change = plan_interpolate(table, 1, 2, 12, "linear")
    assert change.text == "Interpolate 1 in frames 2 to 11, straight between 3 keyframes"
    do(table, change)
    assert frames(table, 1) == list(range(13))
    assert lefts(table, 2, 10) == pytest.approx(np.linspace(*ends[:2], 8))
    assert lefts(table, 9, 12) == pytest.approx(np.linspace(*ends[1:], 3))


def test_along_the_floor_people_walk_at_constant_velocity_and_the_box_follows() -> None:
    table = walking(frames=61, speed=(0.4, 1.5))
    truth = table.of_track(1)
    do(table, plan_delete(table, 1, 1, 60))
    do(table, plan_interpolate(table, 1, 0, 61, "floor", view=VIEW, fps=FPS))
    rows = table.of_track(1)
    assert places_of(rows) == pytest.approx(places_of(truth))
    assert boxes_of(rows) == pytest.approx(boxes_of(truth), abs=0.6)
    assert np.column_stack([rows["vx"], rows["vy"]]) == pytest.approx(np.tile([0.4, 1.5], (61, 1)))
    do(table, plan_interpolate(table, 1, 0, 61, "linear", fps=FPS))
    straight = boxes_of(table.of_track(1))
    assert np.abs(straight - boxes_of(truth)).max() > 5  # perspective is no straight line


def test_a_growing_person_grows_between_keyframes() -> None:
    places = np.array([[0.0, 4.0], [0.0, 4.0]])
    boxes = body_boxes(VIEW, places, np.array([1.5, 1.9]))
    table = TrackTable()
    do(table, plan_draw_box(table, None, 0, tuple(boxes[0].tolist()), (0.0, 4.0)))
    do(
        table,
        plan_draw_box(table, 1, 2, tuple(boxes[1].tolist()), (0.0, 4.0), view=VIEW, join=True),
    )
    middle = boxes_of(table.of_track(1, 1, 2))[0]
    assert middle == pytest.approx(standing_box(VIEW, (0.0, 4.0), 1.7), abs=0.5)


def test_a_stretch_that_ran_straight_runs_straight_again_and_one_along_the_floor_again_there() -> (
    None
):
    for how in ("linear", "floor"):
        table = walking(frames=41, speed=(0.2, 1.6))
        do(table, plan_interpolate(table, 1, 0, 41, how, view=VIEW, fps=FPS))
        moved = plan_move_box(table, 1, 20, (200.0, 90.0, 60.0, 150.0), view=VIEW, fps=FPS)
        wanted = plan_move_box(
            table, 1, 20, (200.0, 90.0, 60.0, 150.0), view=VIEW, fps=FPS, how=how
        )
        assert boxes_of(moved.after.rows) == pytest.approx(boxes_of(wanted.after.rows), abs=1e-6)


def test_without_a_rate_velocities_between_keyframes_are_unknown() -> None:
    table = walking()
    do(table, plan_interpolate(table, 1, 0, 40))
    assert np.isnan(table.of_track(1, 1, 39)["vx"]).all()


def test_a_box_moved_over_the_floor_takes_the_place_along() -> None:
    table = walking()
    row = table.of_track(1, 5, 6)
    x, y = places_of(row)[0] + (0.4, 1.0)
    box = boxes_of(row)[0]
    body, there = (standing_box(VIEW, spot, 1.68) for spot in (places_of(row)[0], (x, y)))
    share = (box - body) / np.tile(body[2:], 2)
    goal = tuple((np.array(there) + share * np.tile(there[2:], 2)).tolist())
    do(table, plan_move_box(table, 1, 5, goal, view=VIEW))
    assert places_of(table.of_track(1, 5, 6))[0] == pytest.approx((x, y), abs=0.05)


def test_a_box_whose_foot_stays_keeps_its_place_without_a_view() -> None:
    table = walking()
    row = table.of_track(1, 5, 6)
    left, top, width, height = boxes_of(row)[0].tolist()
    do(table, plan_move_box(table, 1, 5, (left, top - 10, width, height + 10)))
    assert np.array_equal(places_of(table.of_track(1, 5, 6)), places_of(row))
    do(table, plan_move_box(table, 1, 5, (left + 30, top, width, height)))
    assert np.isnan(places_of(table.of_track(1, 5, 6))).all()


def test_a_box_over_the_horizon_has_no_place_and_is_no_deletion() -> None:
    table = walking()
    do(table, plan_move_box(table, 1, 5, (300.0, -500.0, 30.0, 80.0), view=VIEW))
    row = table.of_track(1, 5, 6)
    assert row["top"].tolist() == [-500.0]
    assert np.isnan(places_of(row)).all()


@pytest.mark.parametrize("scene", ["lobby", "plaza", "ceiling"])
def test_where_bodies_stand_is_told_by_their_boxes_from_every_height(scene: str) -> None:
    view = Rig.of_scene(SCENES[scene], (640, 480)).view
    near = np.array([[0.5, 1.0], [-1.0, 0.3], [0.2, -0.4], [0.0, 0.8]])
    places = near if scene == "ceiling" else near + np.array((0.0, 4.0))
    heights = np.array([1.5, 1.7, 1.9, 1.75])
    boxes = body_boxes(view, places, heights)
    assert body_heights(view, places, boxes) == pytest.approx(heights, abs=0.01)
    assert body_positions(view, boxes, heights) == pytest.approx(places, abs=0.03)


def test_the_place_of_a_drawn_box_is_told_by_the_view() -> None:
    box = standing_box(VIEW, (0.7, 5.0), 1.75)
    assert body_position(VIEW, box) == pytest.approx((0.7, 5.0), abs=1e-3)
    table = TrackTable()
    do(table, plan_draw_box(table, None, 0, box, view=VIEW))
    assert places_of(table.of_track(1))[0] == pytest.approx((0.7, 5.0), abs=1e-3)


@pytest.mark.parametrize(
    ("plan", "why"),
    [
        (lambda table: plan_interpolate(table, 1, 3, 4), "fewer than two boxes"),
        (lambda table: plan_interpolate(table, 1, 5, 5), "empty"),
        (lambda table: plan_interpolate(table, 1, 3, 5), "nothing lies between"),
        (lambda table: plan_interpolate(table, 1, 0, 9, "curved"), "choose 'linear' or 'floor'"),
        (lambda table: plan_interpolate(table, 1, 0, 9, "floor"), "interpolate linearly instead"),
        (lambda table: plan_interpolate(table, 1, 0, 11, fps=FPS), "is interpolated so already"),
        (lambda table: plan_add_keyframe(table, 1, 99), "does not stand in frame 99"),
        (lambda table: plan_add_keyframe(table, 1, 10), "is a keyframe of track 1 already"),
        (lambda table: plan_delete_keyframe(table, 1, 5), "no keyframe"),
        (lambda table: plan_move_box(table, 1, 0, BOX), "nothing to change"),
        (lambda table: plan_draw_box(table, 1, 5, BOX), "move its box instead"),
    ],
)
def test_nonsense_between_keyframes_is_refused_in_words(plan: object, why: str) -> None:
    table = annotated((0, 10))
    with pytest.raises(EditError, match=why):
        plan(table)  # type: ignore[operator]


def test_where_no_floor_is_seen_the_floor_is_refused_in_words() -> None:
    table = TrackTable()
    do(table, plan_draw_box(table, None, 0, (300.0, -500.0, 30.0, 80.0)))
    do(table, plan_draw_box(table, 1, 9, BOX))
    with pytest.raises(EditError, match="no floor is seen below its box in frame 0"):
        plan_interpolate(table, 1, 0, 10, "floor", view=VIEW)


def test_a_thousand_frames_are_interpolated_in_a_moment() -> None:
    table = walking(frames=1001, speed=(0.02, 0.05))
    for frame in range(100, 1000, 100):
        do(table, plan_add_keyframe(table, 1, frame))
    paces = []
    for how in ("linear", "floor") * 5:
        with spent() as time:
            plan_interpolate(table, 1, 0, 1001, how, view=VIEW, fps=FPS)
        paces.append(time.paces)
    assert min(paces[1::2]) < 4
    assert min(paces[0::2]) < 4
