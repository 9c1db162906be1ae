"""Tsai's XML of PETS and TUD: the lens as a calibration, the pose as a floor."""

from __future__ import annotations

import time
from pathlib import Path

import cv2
import numpy as np
import pytest

from tracking.calibration.floor import floor_by_pose
from tracking.errors import CalibrationError
from tracking.geometry import Ground, read_calibration
from tracking.geometry.calibration_reader import calibration_kind
from tracking.geometry.tsai_calibration import is_tsai

SIZE = (768, 576)
FOCAL, KAPPA, SX = 5.5, 0.004, 1.09
CX, CY, DPX, DPY = 324.0, 282.0, 5.1e-3, 4.65e-3
GROUND = Ground(7.0, 16.0, 1.5)


def angles(rotation: np.ndarray) -> tuple[float, float, float]:
    """rx, ry, rz of Rz Ry Rx."""
    ry = -np.arcsin(rotation[2, 0])
    return (
        float(np.arctan2(rotation[2, 1], rotation[2, 2])),
        float(ry),
        float(np.arctan2(rotation[1, 0], rotation[0, 0])),
    )


def tsai(kappa: float = KAPPA, leave: str = "", geometry: str = "width='768' height='576'") -> str:
    """A file of a camera 7 m above the floor."""
    rotation, centre = GROUND.world_from_camera
    turn, shift = rotation.T, -rotation.T @ centre * 1000.0
    (rx, ry, rz), (tx, ty, tz) = angles(turn), shift
    inner = f"focal='{FOCAL}' kappa1='{kappa}' cx='{CX}' cy='{CY}' sx='{SX}'".replace(leave, "")
    return (
        f"<?xml version='1.0'?><Camera name='View_001'>"
        f"<Geometry {geometry} ncx='795' nfx='752' dx='4.85e-3' dy='4.65e-3' "
        f"dpx='{DPX}' dpy='{DPY}'/><Intrinsic {inner}/>"
        f"<Extrinsic tx='{tx}' ty='{ty}' tz='{tz}' rx='{rx}' ry='{ry}' rz='{rz}'/></Camera>"
    )


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "View_001.xml"
    path.write_text(tsai())
    return path


def test_a_tsai_file_is_told_by_its_content(file: Path) -> None:
    assert calibration_kind((file,)) == "Tsai"


def test_the_lens_maps_pixels_as_tsai_s_model_does(file: Path) -> None:
    camera = read_calibration((file,)).left
    assert camera.size == SIZE
    random = np.random.default_rng(1)
    pixels = random.uniform((0, 0), SIZE, (200, 2))
    sensor = (pixels - (CX, CY)) * (DPX / SX, DPY)
    rays = sensor * (1 + KAPPA * (sensor**2).sum(axis=1))[:, None] / FOCAL
    seen = camera.project(np.column_stack((rays, np.ones(200))))
    assert np.abs(seen - pixels).max() < 0.05


def test_the_pose_is_a_floor(file: Path) -> None:
    camera = read_calibration((file,)).left
    ground = floor_by_pose(file, camera).ground
    assert ground.height_m == pytest.approx(GROUND.height_m, rel=1e-3)
    assert ground.tilt_deg == pytest.approx(GROUND.tilt_deg, abs=0.01)
    assert ground.roll_deg == pytest.approx(GROUND.roll_deg, abs=0.01)


def test_the_size_comes_from_the_recording_where_the_file_has_none(file: Path) -> None:
    file.write_text(tsai(geometry=""))
    assert read_calibration((file,), SIZE).left.size == SIZE
    with pytest.raises(CalibrationError, match="does not say the images' size"):
        read_calibration((file,))


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (tsai(leave=f"cx='{CX}'"), "Intrinsic lacks cx"),
        (tsai(kappa=float("nan")), "no number"),
        (tsai().replace(f"dpx='{DPX}'", "dpx='0'"), "above 0"),
        (tsai()[:-12], "not readable as XML"),
        (tsai().replace(f"focal='{FOCAL}'", "focal='1e200'"), "too large"),
        (tsai(kappa=1e300), "too large"),
        (tsai(kappa=1e8), "out of sight"),
        (tsai().replace(f"dpx='{DPX}'", "dpx='1e-300'"), "above 0"),
        (tsai(geometry="width='1e300' height='576'"), "more than 100000 px"),
    ],
)
def test_what_is_missing_is_told_in_one_line(text: str, why: str, file: Path) -> None:
    file.write_text(text)
    with pytest.raises(CalibrationError, match=why) as error:
        read_calibration((file,))
    assert "\n" not in str(error.value)


def test_a_damaged_pose_is_told(file: Path) -> None:
    text = tsai()
    file.write_text(text[: text.index(" tx=")] + " tx='1e300' " + text[text.index(" ty=") :])
    with pytest.raises(CalibrationError, match="too large"):
        floor_by_pose(file)


def test_many_tags_without_an_end_are_told_apart_at_once() -> None:
    before = time.process_time()
    assert not is_tsai("<Intrinsic " * 20_000)
    assert time.process_time() - before < 1.0


def test_rows_of_turns_make_the_rotation_of_the_camera() -> None:
    rotation = GROUND.world_from_camera[0].T
    rx, ry, rz = angles(rotation)
    about_x, about_y, about_z = (
        cv2.Rodrigues(axis * angle)[0] for axis, angle in zip(np.eye(3), (rx, ry, rz), strict=True)
    )
    assert np.allclose(about_z @ about_y @ about_x, rotation)
