"""A floor that was found with a rough calibration says by how much it may be off."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.calibration.floor import FloorEstimate, with_calibration
from tracking.geometry import Camera, Ground, StereoCalibration

WIDTH_PX, FOV_DEG = 640, 65.0
FOCAL_PX = WIDTH_PX / 2 / np.tan(np.deg2rad(FOV_DEG / 2))


def calibration(*, rough: bool) -> StereoCalibration:
    matrix = np.array([[FOCAL_PX, 0, 320.0], [0, FOCAL_PX, 240.0], [0, 0, 1.0]])
    return StereoCalibration.of_one(Camera(matrix, np.zeros(5), WIDTH_PX, 480), rough=rough)


def found(method: str) -> FloorEstimate:
    return FloorEstimate(Ground(2.5, 30.0), method, 0.01, 0.2, 0.2)


@pytest.mark.parametrize(("method", "share"), [("stereo", 0.108), ("people", 0.096)])
def test_a_rough_calibration_makes_the_height_unsure_by_about_a_tenth(
    method: str, share: float
) -> None:
    unsure = with_calibration(found(method), calibration(rough=True))
    assert unsure.height_sigma_m == pytest.approx(2.5 * share, rel=0.01)
    assert unsure.ground == found(method).ground
    assert f"may be off by {share:.0%}" in unsure.notes[-1]


def test_other_floors_are_as_sure_as_they_were() -> None:
    for kept in (
        with_calibration(found("stereo"), calibration(rough=False)),
        with_calibration(found("stereo"), None),
    ):
        assert kept == found("stereo")
    assert with_calibration(found("pose"), calibration(rough=True)) == found("pose")
