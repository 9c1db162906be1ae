"""Rectified pairs: rows agree, the picture stays whole, metres come out of disparity."""

from __future__ import annotations

from pathlib import Path

import av
import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.errors import CalibrationError
from tracking.geometry import (
    Camera,
    Ground,
    Rectification,
    StereoCalibration,
    View,
    read_calibration,
)

MATRIX = np.array([[510.0, 0.0, 322.3], [0.0, 510.0, 238.1], [0.0, 0.0, 1.0]])
GROUND = Ground(2.74, 90)
WORLD = st.tuples(st.floats(-1.0, 1.0), st.floats(-0.6, 0.6), st.floats(0.0, 1.5))


def rectified_already(cx_right: float = 322.3) -> Rectification:
    right = MATRIX.copy()
    right[0, 2] = cx_right
    left = Camera(MATRIX, np.zeros(5), 640, 480)
    rig = StereoCalibration(
        left, Camera(right, np.zeros(5), 640, 480), np.eye(3), np.array([-0.12, 0, 0])
    )
    return Rectification(rig, Ground(2.4, 30))


@pytest.fixture(scope="module")
def real(shared_data: Path) -> Rectification:
    file = shared_data / "overhead-real" / "calibration.yaml"
    return Rectification(read_calibration([file]), GROUND)


def test_a_rectified_pair_is_passed_through_untouched() -> None:
    rectification = rectified_already()
    left, right = (np.full((480, 640, 3), value, np.uint8) for value in (1, 2))
    assert rectification.identity
    seen = rectification.rectify(left, right)
    assert seen[0] is left
    assert seen[1] is right
    assert rectification.principal == (322.3, 238.1)
    assert rectification.baseline_m == pytest.approx(0.12)


def test_principal_points_that_differ_along_the_row_only_shift_the_disparity() -> None:
    rectification = rectified_already(cx_right=330.0)
    assert rectification.identity
    assert rectification.disparity_offset_px == pytest.approx(-7.7)
    world = np.array([[0.4, 3.0, 1.0]])
    u, v = rectification.rectified_from_world(world)[0]
    d = rectification.disparity_from_world(world)
    right = rectification.right_pixel_from_world(world)[0]
    assert right == pytest.approx((u - d[0], v))
    np.testing.assert_allclose(
        rectification.world_from_disparity(np.array([u]), np.array([v]), d), world, atol=1e-9
    )


@given(WORLD)
@settings(deadline=None)
def test_a_world_point_lies_on_one_row_of_both_rectified_cameras(
    real: Rectification, point: tuple[float, float, float]
) -> None:
    world = np.array([point])
    u, v = real.rectified_from_world(world)[0]
    d = real.disparity_from_world(world)[0]
    assert real.right_recorded_from_rectified(np.array([[u - d, v]]))[0] == pytest.approx(
        real.right_pixel_from_world(world)[0], abs=1e-6
    )


@given(WORLD)
@settings(deadline=None)
def test_disparity_gives_the_world_point_back(
    real: Rectification, point: tuple[float, float, float]
) -> None:
    world = np.array([point])
    pixel = real.rectified_from_world(world)
    found = real.world_from_disparity(pixel[:, 0], pixel[:, 1], real.disparity_from_world(world))
    np.testing.assert_allclose(found, world, atol=1e-9)


@given(WORLD)
@settings(deadline=None)
def test_the_turn_of_rectification_does_not_move_the_world(
    real: Rectification, point: tuple[float, float, float]
) -> None:
    world = np.array([point])
    recorded = View(real.calibration.left, GROUND).pixel_from_world(world)
    rectified = real.rectified_from_world(world)
    assert real.recorded_from_rectified(rectified)[0] == pytest.approx(recorded[0], abs=1e-5)
    assert real.rectified_from_recorded(recorded)[0] == pytest.approx(rectified[0], abs=1e-5)


def test_disparity_of_infinity_or_less_has_no_place_in_the_world() -> None:
    found = rectified_already().world_from_disparity(
        np.array([300.0, 300.0]), np.array([200.0, 200.0]), np.array([0.0, -3.0])
    )
    assert np.isnan(found).all()


def test_the_rectified_picture_of_a_real_rig_keeps_its_middle_and_is_well_covered(
    real: Rectification,
) -> None:
    """Here an automatic principal point lands off the image."""
    width, height = real.size
    middle = np.array([[width / 2, height / 2]])
    assert np.abs(real.rectified_from_recorded(middle) - middle).max() < 30
    u, v = np.meshgrid(np.arange(0.0, width, 10), np.arange(0.0, height, 10))
    grid = np.column_stack((u.ravel(), v.ravel()))
    for recorded in (
        real.recorded_from_rectified(grid), real.right_recorded_from_rectified(grid)
    ):  # fmt: skip
        inside = ((recorded >= 0) & (recorded <= (width - 1, height - 1))).all(axis=1)
        assert inside.mean() > 0.9
    edges = np.array([[0, 400], [1279, 400], [640, 0], [640, 799.0]])
    seen = real.rectified_from_recorded(edges)
    assert (seen > -40).all()
    assert (seen < (width + 40, height + 40)).all()


def test_rows_of_a_real_rectified_pair_agree(real: Rectification, shared_data: Path) -> None:
    """Corners matched between the cameras of real footage lie on the same row."""
    left, right = real.rectify(*_real_pair(shared_data))
    matches = _matched_corners(left, right)
    assert len(matches) > 50
    rows_apart = matches[:, 1] - matches[:, 3]
    assert abs(np.median(rows_apart)) < 0.5
    assert np.median(np.abs(rows_apart)) < 0.7
    assert np.median(matches[:, 0] - matches[:, 2]) > 10


def test_metres_need_to_know_the_floor() -> None:
    calibration = rectified_already().calibration
    with pytest.raises(CalibrationError, match="height and tilt"):
        Rectification(calibration, None).rectified_from_world(np.zeros((1, 3)))


def test_one_camera_cannot_be_rectified() -> None:
    one = StereoCalibration.of_one(Camera(MATRIX, np.zeros(5), 640, 480))
    with pytest.raises(CalibrationError, match="two cameras"):
        Rectification(one, None)


@pytest.mark.parametrize(
    ("rotation", "translation", "says"),
    [
        (np.eye(3) * 2, [-0.12, 0, 0], "not a rotation"),
        (np.diag([1.0, 1.0, -1.0]), [-0.12, 0, 0], "not a rotation"),
        (np.eye(3), [0.12, 0, 0], "swap the cameras"),
        (np.eye(3), [0, -0.12, 0], "side by side"),
        (np.eye(3), [0, 0, 0], "0 m apart"),
        (np.eye(3), [-120.0, 0, 0], "in metres"),
        (np.eye(3), [np.nan, 0, 0], "finite"),
    ],
)
def test_a_rig_that_cannot_be_is_refused(
    rotation: np.ndarray, translation: list[float], says: str
) -> None:
    camera = Camera(MATRIX, np.zeros(5), 640, 480)
    with pytest.raises(CalibrationError, match=says):
        StereoCalibration(camera, camera, rotation, np.array(translation))


def test_a_calibration_of_another_size_is_told() -> None:
    with pytest.raises(CalibrationError, match=r"640 x 480.*320 x 240"):
        rectified_already().calibration.check_size((320, 240))


def test_cameras_turned_so_far_that_nothing_is_left_are_refused() -> None:
    camera = Camera(MATRIX, np.zeros(5), 640, 480)
    turned, _ = cv2.Rodrigues(np.array([0.0, 1.2, 0.0]))
    calibration = StereoCalibration(camera, camera, turned, turned @ np.array([-0.12, 0.0, 0.0]))
    with pytest.raises(CalibrationError, match="covered"):
        Rectification(calibration, None)


def _real_pair(shared_data: Path) -> tuple[np.ndarray, np.ndarray]:
    pair = []
    for side in ("left", "right"):
        with av.open(str(shared_data / "overhead-real" / f"{side}.mp4")) as container:
            frame = next(f for n, f in enumerate(container.decode(video=0)) if n == 70)
            pair.append(frame.to_ndarray(format="bgr24"))
    return pair[0], pair[1]


def _matched_corners(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Matches (n, 4), u v in the left and u v in the right picture."""
    detector = cv2.ORB_create(600)
    seen = [detector.detectAndCompute(image, None) for image in (left, right)]
    matches = cv2.BFMatcher(cv2.NORM_HAMMING, crossCheck=True).match(seen[0][1], seen[1][1])
    best = sorted(matches, key=lambda match: match.distance)[:150]
    return np.array([[*seen[0][0][m.queryIdx].pt, *seen[1][0][m.trainIdx].pt] for m in best])
