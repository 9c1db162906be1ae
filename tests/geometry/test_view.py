"""The left camera on its floor, by the contract's world axes, tilt and roll."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.errors import CalibrationError
from tracking.geometry import Camera, Ground, View, read_calibration

MATRIX = np.array([[510.0, 0.0, 322.3], [0.0, 510.0, 238.1], [0.0, 0.0, 1.0]])
GROUNDS = st.builds(Ground, st.floats(1.5, 10), st.floats(10, 90), st.floats(-30, 30))


def view(ground: Ground, distortion: float = 0.0) -> View:
    return View(Camera(MATRIX, np.array([distortion, 0, 0, 0]), 640, 480), ground)


def truth_rows(folder: Path) -> np.ndarray:
    return np.loadtxt(folder / "truth.txt", delimiter=",")


@given(GROUNDS, st.floats(-0.2, 0.1), st.floats(0, 639), st.floats(240, 479), st.floats(0, 1))
@settings(deadline=None)
def test_a_pixel_carried_to_the_floor_and_back_is_the_pixel_again(
    ground: Ground, distortion: float, u: float, v: float, z_m: float
) -> None:
    standing = view(ground, distortion)
    floor = standing.floor_from_pixel(np.array([[u, v]]), z_m)
    if np.isnan(floor).any() or np.abs(floor).max() > 1e3:
        return
    pixel = standing.pixel_from_world(np.column_stack((floor, [z_m])))
    np.testing.assert_allclose(pixel[0], (u, v), atol=1e-3)


@given(GROUNDS)
def test_the_camera_axes_are_a_rotation_with_the_centre_at_its_height(ground: Ground) -> None:
    rotation, centre = view(ground).world_from_camera
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(rotation) == pytest.approx(1)
    assert centre.tolist() == [0, 0, ground.height_m]


@given(GROUNDS, st.tuples(st.floats(-2, 2), st.floats(-2, 2), st.floats(0.5, 9)))
def test_roll_is_the_contracts_formula(ground: Ground, point: tuple[float, float, float]) -> None:
    level, _ = Ground(ground.height_m, ground.tilt_deg).world_from_camera
    rolled, _ = ground.world_from_camera
    x0, y0, z0 = point @ level
    roll = np.deg2rad(ground.roll_deg)
    expected = (
        x0 * np.cos(roll) + y0 * np.sin(roll),
        -x0 * np.sin(roll) + y0 * np.cos(roll),
        z0,
    )
    np.testing.assert_allclose(point @ rolled, expected, atol=1e-12)


def test_without_roll_the_row_of_the_image_is_level_and_its_column_points_down() -> None:
    rotation, _ = Ground(2.0, 30).world_from_camera
    assert rotation[2, 0] == 0
    assert rotation[2, 1] < 0
    assert rotation[1, 2] == pytest.approx(np.cos(np.deg2rad(30)))
    assert rotation[2, 2] == pytest.approx(-0.5)


def test_looking_straight_down_forward_is_the_upper_edge_of_the_image() -> None:
    down = view(Ground(3.0, 90))
    middle, above, right = down.floor_from_pixel(
        np.array([[322.3, 238.1], [322.3, 100], [400, 238.1]])
    )
    np.testing.assert_allclose(middle, (0, 0), atol=1e-12)
    assert above[1] > 0.5
    assert above[0] == pytest.approx(0)
    assert right[0] > 0.4


def test_at_and_above_the_horizon_there_is_no_floor() -> None:
    level = view(Ground(2.0, 0))
    floor = level.floor_from_pixel(np.array([[320, 238.1], [320, 10], [320, 300]]))
    assert np.isnan(floor[:2]).all()
    assert floor[2, 1] == pytest.approx(2.0 * 510 / (300 - 238.1))


def test_each_point_may_lie_at_its_own_height() -> None:
    standing = view(Ground(2.4, 30))
    world = np.array([[0.5, 3.0, 0.0], [0.5, 3.0, 1.7], [-1.0, 5.0, 0.9]])
    floor = standing.floor_from_pixel(standing.pixel_from_world(world), world[:, 2])
    np.testing.assert_allclose(floor, world[:, :2], atol=1e-9)


def test_a_point_behind_the_camera_has_no_pixel() -> None:
    assert np.isnan(view(Ground(2.4, 30)).pixel_from_world(np.array([[0, -5.0, 0]]))).all()


def test_the_feet_of_real_truth_stand_where_the_floor_positions_project(shared_data: Path) -> None:
    folder = shared_data / "pets-s2l1-real"
    camera = read_calibration([folder / "calibration.yaml"]).left
    rows = truth_rows(folder)
    feet = np.column_stack((rows[:, 2] - 1 + rows[:, 4] / 2, rows[:, 3] - 1 + rows[:, 5]))
    seen = View(camera, Ground(7.0657, 16.4825, 3.0877)).pixel_from_world(rows[:, 7:10])
    assert np.linalg.norm(seen - feet, axis=1).max() < 1.5


@pytest.mark.parametrize(
    ("name", "ground"),
    [("rendered-lobby", Ground(2.4, 30)), ("rendered-plaza", Ground(6.4, 60))],
)
def test_the_box_of_a_person_is_much_like_rendered_truth(
    shared_data: Path, name: str, ground: Ground
) -> None:
    rows = truth_rows(shared_data / name)
    rows = rows[rows[:, 6] == 1]
    truth = rows[:, 2:6] - (1, 1, 0, 0)
    boxes = view(ground).box_of_person(rows[:, 7:9], 1.72, 0.52)
    low = np.maximum(truth[:, :2], boxes[:, :2])
    high = np.minimum(truth[:, :2] + truth[:, 2:], boxes[:, :2] + boxes[:, 2:])
    shared = np.maximum(high - low, 0).prod(axis=1)
    iou = shared / (truth[:, 2:].prod(axis=1) + boxes[:, 2:].prod(axis=1) - shared)
    assert np.median(iou) > 0.7


def test_the_field_of_view_holds_the_floor_points_that_are_seen_and_is_cut_at_its_range() -> None:
    standing = view(Ground(2.4, 20))
    field = standing.field_of_view(12.0)
    distances = np.hypot(*field.T)
    assert distances.max() == pytest.approx(12.0)
    floor = standing.floor_from_pixel(np.array([[-0.5, 479.5], [639.5, 479.5]]))
    for corner in floor:
        assert np.abs(field - corner).sum(axis=1).min() < 1e-9


def test_the_field_of_view_straight_down_is_the_image_laid_on_the_floor() -> None:
    field = view(Ground(3.0, 90)).field_of_view()
    width, depth = np.ptp(field, axis=0)
    assert width == pytest.approx(640 * 3 / 510)
    assert depth == pytest.approx(480 * 3 / 510)


@pytest.mark.parametrize("values", [(0.0, 30.0), (-1.0, 30.0), (2.0, 120.0), (float("nan"), 3.0)])
def test_a_floor_that_cannot_be_is_refused(values: tuple[float, float]) -> None:
    with pytest.raises(CalibrationError):
        Ground(*values)
