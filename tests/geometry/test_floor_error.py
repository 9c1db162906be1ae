"""How far from a camera places on the floor are still known."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.geometry import Camera, Ground, View
from tracking.geometry.floor_error import (
    FOOT_ERROR_PX,
    LARGE_ERROR_M,
    distance_of_large_errors,
)

FOCAL_PX = 500.0


def view(height_m: float, tilt_deg: float) -> View:
    matrix = np.array([[FOCAL_PX, 0, 320], [0, FOCAL_PX, 240], [0, 0, 1]])
    return View(Camera(matrix, np.zeros(5), 640, 480), Ground(height_m, tilt_deg))


@pytest.mark.parametrize("height_m", [0.8, 1.6])
def test_errors_grow_with_the_square_of_the_distance(height_m: float) -> None:
    expected_m = np.sqrt(LARGE_ERROR_M * FOCAL_PX * height_m / FOOT_ERROR_PX)
    found_m = distance_of_large_errors(view(height_m, 2.0))
    assert found_m == pytest.approx(expected_m, rel=0.25)  # rows are looked at in steps


def test_a_camera_that_looks_down_knows_all_places() -> None:
    assert distance_of_large_errors(view(3.0, 80.0)) is None


def test_a_floor_that_is_not_looked_at_does_not_count() -> None:
    near = np.zeros((480, 640), np.uint8)
    near[460:] = 255
    assert distance_of_large_errors(view(1.6, 2.0)) is not None
    assert distance_of_large_errors(view(1.6, 2.0), near) is None
