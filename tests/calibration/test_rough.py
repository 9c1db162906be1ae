"""A pair calibrated by what it films."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.calibration.rendered_boards import pair_of
from tracking.calibration.rough import RoughRequest, calibrate_roughly
from tracking.errors import CalibrationError
from tracking.geometry import Camera, StereoCalibration, read_calibration, write_calibration

SIZE = (640, 480)
CAMERA = Camera(np.array([[520.0, 0, 319.5], [0, 520.0, 239.5], [0, 0, 1]]), np.zeros(5), *SIZE)
FOV_DEG = 2 * np.rad2deg(np.arctan(320 / 520))
PAIR = pair_of(CAMERA)


def write_views(folder: Path, pair: StereoCalibration = PAIR) -> tuple[str, str]:
    """Pictures of textured planes at several distances by both cameras."""
    random = np.random.default_rng(5)
    for number, away_m in enumerate((2.0, 3.0, 5.0)):
        texture = random.integers(0, 255, (90, 120), np.uint8)
        texture = cv2.resize(texture, (1200, 900), interpolation=cv2.INTER_CUBIC)
        for side, turn, shift in (
            ("left", np.eye(3), np.zeros(3)),
            ("right", pair.rotation, pair.translation),
        ):
            u, v = np.meshgrid(np.arange(640.0), np.arange(480.0))
            rays = np.stack(((u - 319.5) / 520, (v - 239.5) / 520, np.ones_like(u)), -1) @ turn
            centre = -turn.T @ shift
            tilted = np.array([0.1 * number, 0.3, 1.0])
            far = (away_m - tilted @ centre) / (rays @ tilted)
            place = (centre + rays * far[..., None])[..., :2] / away_m * 400 + (600, 450)
            image = cv2.remap(texture, np.float32(place), None, cv2.INTER_LINEAR)
            cv2.imwrite(str(folder / f"{side}{number}.png"), image)
    return str(folder / "left*.png"), str(folder / "right*.png")


def test_the_right_cameras_pose_is_found_and_the_file_is_marked_as_rough(tmp_path: Path) -> None:
    found = calibrate_roughly(RoughRequest(*write_views(tmp_path), FOV_DEG, 0.12))
    turn = cv2.Rodrigues(found.calibration.rotation @ PAIR.rotation.T)[0]
    assert np.rad2deg(np.linalg.norm(turn)) < 0.3
    assert found.calibration.baseline_m == pytest.approx(0.12)
    write_calibration(tmp_path / "rough.yaml", found.calibration)
    assert read_calibration([tmp_path / "rough.yaml"]).rough


def test_swapped_cameras_are_told(tmp_path: Path) -> None:
    left, right = write_views(tmp_path)
    with pytest.raises(CalibrationError, match="swap left and right"):
        calibrate_roughly(RoughRequest(right, left, FOV_DEG, 0.12))


def test_views_of_different_scenes_are_told(tmp_path: Path) -> None:
    left, _ = write_views(tmp_path)
    random = np.random.default_rng(6)
    (tmp_path / "other").mkdir()
    for number in range(3):
        noise = cv2.resize(random.integers(0, 255, (60, 80, 3), np.uint8), SIZE)
        cv2.imwrite(str(tmp_path / "other" / f"{number}.png"), noise)
    with pytest.raises(CalibrationError, match="same place"):
        calibrate_roughly(RoughRequest(left, str(tmp_path / "other"), FOV_DEG, 0.12))


@pytest.mark.parametrize(("fov_deg", "baseline_m"), [(1.0, 0.1), (179.0, 0.1), (60.0, 0.0)])
def test_fields_of_view_and_distances_that_cannot_be_are_refused(
    fov_deg: float, baseline_m: float
) -> None:
    with pytest.raises(CalibrationError, match=r"degrees|metres"):
        calibrate_roughly(RoughRequest("left", "right", fov_deg, baseline_m))
