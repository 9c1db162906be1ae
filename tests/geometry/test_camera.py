"""One camera: rays of pixels and pixels of rays, with distortion that breaks down."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.errors import CalibrationError
from tracking.geometry import Camera, read_calibration

MATRIX = np.array([[510.0, 0.0, 322.3], [0.0, 512.0, 238.1], [0.0, 0.0, 1.0]])
MILD = st.tuples(
    st.floats(-0.3, 0.3),
    st.floats(-0.1, 0.1),
    st.floats(-0.005, 0.005),
    st.floats(-0.005, 0.005),
    st.floats(-0.05, 0.05),
)
PIXELS = st.lists(
    st.tuples(st.floats(-100, 740), st.floats(-100, 580)), min_size=1, max_size=20
).map(np.array)


def projected(camera: Camera, rays: np.ndarray) -> np.ndarray:
    return camera.project(np.column_stack((rays, np.ones(len(rays)))))


@given(MILD, PIXELS)
@settings(deadline=None)
def test_a_pixel_undistorted_and_projected_is_the_pixel_again(
    distortion: tuple[float, ...], pixels: np.ndarray
) -> None:
    camera = Camera(MATRIX, np.array(distortion), 640, 480)
    np.testing.assert_allclose(projected(camera, camera.undistort(pixels)), pixels, atol=1e-5)


def test_projection_is_the_one_of_opencv_within_the_field() -> None:
    # x = y = 0.25 at k1 = -0.2: radius^2 0.125, factor 1 - 0.025.
    camera = Camera(MATRIX, np.array([-0.2, 0.0, 0.0, 0.0]), 640, 480)
    pixel = camera.project(np.array([[0.5, 0.5, 2.0]]))
    expected = np.array([0.25 * 0.975 * 510 + 322.3, 0.25 * 0.975 * 512 + 238.1])
    np.testing.assert_allclose(pixel[0], expected, atol=1e-9)


def test_a_point_at_or_behind_the_camera_has_no_pixel() -> None:
    camera = Camera(MATRIX, np.zeros(5), 640, 480)
    assert np.isnan(camera.project(np.array([[0, 0, -1.0], [0, 0, 0.0]]))).all()


def test_a_rational_distortion_stays_orderly_past_its_pole(shared_data: Path) -> None:
    """Its denominators vanish inside the picture, at radius 0.78 and 0.85."""
    calibration = read_calibration([shared_data / "overhead-real" / "calibration.yaml"])
    for camera in (calibration.left, calibration.right):
        assert camera is not None
        radius = np.linspace(0, 1.5, 2000)
        shown = camera.lens.distort(np.column_stack((radius, np.zeros(len(radius)))))[:, 0]
        steps = np.diff(shown) / np.diff(radius)
        assert steps.min() > 0.5
        assert steps.max() < 1.5
        pixels = np.random.default_rng(0).uniform((-50, -50), (1330, 850), (2000, 2))
        np.testing.assert_allclose(projected(camera, camera.undistort(pixels)), pixels, atol=1e-6)


def test_a_polynomial_that_turns_back_never_folds_the_far_into_the_picture() -> None:
    camera = Camera(MATRIX, np.array([-0.3, 0.0, 0.0, 0.0]), 640, 480)
    far = camera.project(np.array([[3.0, 0.0, 1.0], [30.0, 0.0, 1.0]]))
    assert far[0, 0] > 640
    assert far[1, 0] > far[0, 0]


def test_pixels_that_are_no_numbers_have_no_ray_and_do_not_spoil_the_others() -> None:
    camera = Camera(MATRIX, np.array([-0.2, 0.05, 0.0, 0.0]), 640, 480)
    rays = camera.undistort(np.array([[np.nan, 1.0], [np.inf, 1.0], [100.0, 200.0]]))
    assert np.isnan(rays[:2]).all()
    assert np.isfinite(rays[2]).all()
    assert camera.undistort(np.zeros((0, 2))).shape == (0, 2)
    assert camera.project(np.zeros((0, 3))).shape == (0, 2)


@pytest.mark.parametrize(
    ("matrix", "distortion", "size"),
    [
        (np.eye(2), np.zeros(5), (640, 480)),
        (np.full((3, 3), np.nan), np.zeros(5), (640, 480)),
        (-MATRIX, np.zeros(5), (640, 480)),
        (MATRIX, np.zeros(6), (640, 480)),
        (MATRIX, np.full(5, np.inf), (640, 480)),
        (MATRIX, np.zeros(5), (0, 480)),
    ],
)
def test_what_makes_no_camera_is_refused_in_one_line(
    matrix: np.ndarray, distortion: np.ndarray, size: tuple[int, int]
) -> None:
    with pytest.raises(CalibrationError) as caught:
        Camera(matrix, distortion, *size)
    assert "\n" not in str(caught.value)


def test_a_fisheye_sees_rays_where_its_model_says_and_takes_them_back() -> None:
    camera = Camera(
        np.array([[300.0, 0, 320], [0, 300.0, 240], [0, 0, 1]]),
        np.array([0.05, -0.01, 0.002, 0.0]),
        640,
        480,
        fisheye=True,
    )
    angle = np.deg2rad([0.0, 20.0, 50.0])
    rays = np.column_stack((np.tan(angle), np.zeros(3), np.ones(3)))
    shown = angle * (1 + 0.05 * angle**2 - 0.01 * angle**4 + 0.002 * angle**6)
    pixels = camera.project(rays)
    np.testing.assert_allclose(pixels[:, 0], 320 + 300 * shown)
    np.testing.assert_allclose(camera.undistort(pixels), rays[:, :2], atol=1e-9)
