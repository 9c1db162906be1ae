"""The floor of recordings with depth, examined."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from tracking.doctor import Examination, examine, mend
from tracking.geometry import (
    Camera,
    Ground,
    StereoCalibration,
    View,
    write_calibration,
)
from tracking.recording import Manifest, open_recording, read_manifest, write_manifest

SIZE = (320, 240)
CAMERA = Camera(np.array([[260.0, 0, 159.5], [0, 260.0, 119.5], [0, 0, 1]]), np.zeros(5), *SIZE)
TRUE = Ground(2.4, 35.0)


def depth_mm() -> np.ndarray:
    """How far the floor is along the optical axis, pixel by pixel."""
    u, v = np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1]))
    pixels = np.column_stack((u.ravel(), v.ravel())).astype(float)
    places = View(CAMERA, TRUE).floor_from_pixel(pixels)
    rotation, centre = TRUE.world_from_camera
    world = np.column_stack((places, np.zeros(len(places))))
    along = ((world - centre) @ rotation)[:, 2]
    known = np.isfinite(along) & (along < 20.0)
    return np.where(known, 1000 * along, 0).round().reshape(SIZE[::-1]).astype(np.uint16)


def examined(folder: Path, ground: Ground | None) -> Examination:
    random = np.random.default_rng(4)
    image = cv2.GaussianBlur(random.integers(0, 255, (*SIZE[::-1], 3), np.uint8), (0, 0), 1.2)
    for name in ("left", "depth"):
        (folder / name).mkdir()
    for number in range(4):
        cv2.imwrite(str(folder / "left" / f"{number:03}.png"), image)
        cv2.imwrite(str(folder / "depth" / f"{number:03}.png"), depth_mm())
    write_calibration(folder / "calibration.yaml", StereoCalibration.of_one(CAMERA))
    written = Manifest(
        "hall",
        "left/*.png",
        depth="depth/*.png",
        fps=10.0,
        calibration=("calibration.yaml",),
        ground=ground,
    )
    write_manifest(folder, written)
    with open_recording(folder) as recording:
        return examine(recording)


def test_a_right_floor_of_a_depth_recording_is_checked_and_sound(tmp_path: Path) -> None:
    examination = examined(tmp_path, TRUE)
    assert examination.findings == ()
    assert "depth-floor" in examination.checked
    assert not examination.is_partial


@pytest.mark.parametrize("told", [Ground(2.64, 35.0), Ground(2.4, 37.0)])
def test_a_wrong_floor_of_a_depth_recording_is_named_and_mended(
    told: Ground, tmp_path: Path
) -> None:
    examination = examined(tmp_path, told)
    (finding,) = examination.findings
    assert finding.code == "depth-floor"
    with open_recording(tmp_path) as recording:
        mend(recording, finding)
    ground = read_manifest(tmp_path).ground
    assert ground is not None
    assert ground.height_m == pytest.approx(2.4, rel=0.01)
    assert ground.tilt_deg == pytest.approx(35.0, abs=0.3)


def test_a_depth_recording_of_unknown_floor_says_so(tmp_path: Path) -> None:
    examination = examined(tmp_path, None)
    assert "depth-floor" in examination.unchecked
