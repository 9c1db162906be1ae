"""Whoever is dragged over the floor is seen there by both cameras."""

from __future__ import annotations

import numpy as np
import pytest
from people_on_a_floor_plan import FPS, VIEW, turned_rig, walking

from tracking.editing import apply_change, plan_drag, plan_interpolate, standing_box
from tracking.editing.boxes.floor_boxes import body_heights, boxes_of, places_of
from tracking.errors import EditError
from tracking.geometry import Rectification, View
from tracking.synthesis import SCENES
from tracking.synthesis.rig import Rig
from tracking.tracks import CORRECTED_COLUMNS, Labels, Source, TrackTable

RENDERED = Rig.of_scene(SCENES["lobby"], (640, 480))
RIGS = {
    "rendered": Rectification(RENDERED.calibration, RENDERED.view.ground),
    "turned": turned_rig(),
}


def drag(table: TrackTable, frame: int, to: tuple[float, float], view: View = VIEW) -> None:
    apply_change(table, Labels(), plan_drag(table, 1, frame, to, view, fps=FPS))


@pytest.mark.parametrize("name", RIGS)
def test_both_cameras_agree_on_where_the_foot_of_a_dragged_person_is(name: str) -> None:
    rig = RIGS[name]
    assert rig.ground is not None
    view = View(rig.calibration.left, rig.ground)
    table = walking(view)
    for frame, to in enumerate([(0.3, 4.6), (-1.4, 3.6), (1.2, 6.0), (0.0, 8.0)]):
        drag(table, frame, to, view)
        place = places_of(table.of_track(1, frame, frame + 1))
        assert place.tolist() == [list(to)]
        foot = np.column_stack([place, [0.0]])
        left, right = view.pixel_from_world(foot), rig.right_pixel_from_world(foot)
        assert off_epipolar_line_px(rig, left, right) < 0.5
        assert np.abs(triangulated(rig, left, right) - foot).max() < 0.01


def off_epipolar_line_px(rig: Rectification, left: np.ndarray, right: np.ndarray) -> float:
    """How far a right pixel is from the line that belongs to the left one, from R and T alone."""
    cameras, turn = rig.calibration, rig.calibration.rotation
    assert cameras.right is not None
    x, y, z = cameras.translation
    essential = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]]) @ turn
    rays = [
        np.append(side.undistort(at)[0], 1)
        for side, at in ((cameras.left, left), (cameras.right, right))
    ]
    line = essential @ rays[0]
    return float(abs(rays[1] @ line) / np.hypot(*line[:2]) * cameras.right.matrix[0, 0])


def triangulated(rig: Rectification, left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """The world point where both rays meet best."""
    cameras = rig.calibration
    assert cameras.right is not None
    assert rig.ground is not None
    a = np.append(cameras.left.undistort(left)[0], 1)
    b = cameras.rotation.T @ np.append(cameras.right.undistort(right)[0], 1)
    centre = -cameras.rotation.T @ cameras.translation
    along = np.linalg.lstsq(np.column_stack([a, -b]), centre, rcond=None)[0]
    rotation, origin = rig.ground.world_from_camera
    return rotation @ ((a * along[0] + centre + b * along[1]) / 2) + origin


def test_the_box_goes_along_as_a_body_of_the_same_height_would() -> None:
    table = walking(height_m=1.68)
    row = table.of_track(1, 5, 6)
    assert body_heights(VIEW, places_of(row), boxes_of(row)) == pytest.approx([1.68], abs=0.08)
    drag(table, 5, (0.8, 5.5))
    _, top, width, height = boxes_of(table.of_track(1, 5, 6))[0]
    _, body_top, body_width, body_height = standing_box(VIEW, (0.8, 5.5), 1.68)
    assert height / body_height == pytest.approx(1.03, abs=0.01)
    assert width / body_width == pytest.approx(1.1, abs=0.01)
    assert top == pytest.approx(body_top - 0.02 * body_height, abs=1.0)


def test_dragging_there_and_back_gives_the_same_box() -> None:
    table = walking()
    before = boxes_of(table.of_track(1, 5, 6))
    home = tuple(places_of(table.of_track(1, 5, 6))[0].tolist())
    drag(table, 5, (1.0, 6.0))
    drag(table, 5, home)
    assert boxes_of(table.of_track(1, 5, 6)) == pytest.approx(before, abs=0.5)


def test_a_person_without_a_place_is_dragged_from_where_the_box_stands() -> None:
    rows = {name: column.copy() for name, column in walking().columns().items()}
    truth = boxes_of(rows)[5]
    rows["x"][:] = rows["y"][:] = np.nan
    table = TrackTable(rows)
    drag(table, 5, (-0.75, 4.125))  # where the body of this box stands
    row = table.of_track(1, 5, 6)
    assert boxes_of(row)[0] == pytest.approx(truth, rel=0.05)
    assert row["source"][0] == Source.PERSON
    assert np.isnan(table.of_track(1, 6, 7)["x"][0])


def test_dragging_takes_interpolated_neighbours_along() -> None:
    table = walking(frames=41)
    apply_change(table, Labels(), plan_interpolate(table, 1, 0, 41, "floor", view=VIEW, fps=FPS))
    change = plan_drag(table, 1, 20, (0.5, 6.0), VIEW, fps=FPS)
    assert change.text == "Drag 1 on the floor in frame 20; 38 frames around it interpolated"
    apply_change(table, Labels(), change)
    rows = table.of_track(1)
    ends = places_of(rows)[[0, 20, 40]]
    assert places_of(rows)[10] == pytest.approx(ends[:2].mean(axis=0))
    assert places_of(rows)[30] == pytest.approx(ends[1:].mean(axis=0))
    speeds = np.diff(ends, axis=0) * FPS / 20
    assert np.column_stack([rows["vx"], rows["vy"]])[[10, 20, 30]] == pytest.approx(
        np.array([speeds[0], speeds.mean(axis=0), speeds[1]])
    )


def test_visibility_stays_said_when_somebody_is_dragged() -> None:
    table = walking()
    drag(table, 5, (0.8, 5.5))
    assert table.of_track(1, 5, 6)["visibility"][0] == np.float32(0.8)


@pytest.mark.parametrize(
    ("frame", "to", "why"),
    [
        (99, (0.0, 4.0), "draw a box there instead"),
        (5, (0.0, np.nan), "x and y in metres"),
        (5, (0.0, -3.0), "behind the camera"),
    ],
)
def test_nowhere_is_refused_in_words(frame: int, to: tuple[float, float], why: str) -> None:
    with pytest.raises(EditError, match=why):
        plan_drag(walking(), 1, frame, to, VIEW)


def test_all_columns_of_a_dragged_row_are_there() -> None:
    change = plan_drag(walking(), 1, 5, (0.0, 5.0), VIEW)
    assert set(change.after.rows) == set(CORRECTED_COLUMNS)
