"""Cameras at eye level: the horizon lies inside the picture, and much is seen above it."""

from __future__ import annotations

import shutil
from pathlib import Path

import cv2
import numpy as np
import pytest

from tracking.pipeline import track
from tracking.recording import OpenOptions, open_recording
from tracking.trackers import TRACKERS

SIZE, FRAMES, BASELINE_M = (320, 240), 12, 0.2
FOCAL_PX = 300.0
WALKS = ((40, 200, 9, 0), (250, 110, -7, -3), (150, 90, 4, 4), (90, 140, 0, -8))
"""Of people: where their feet are in the first frame, and px a frame; some rise into the air."""


@pytest.fixture(scope="module")
def street(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of drawn pictures for two cameras; each test says where its floor is."""
    folder = tmp_path_factory.mktemp("street")
    wall = np.random.default_rng(5).integers(80, 180, (60, 80, 3), np.uint8)
    empty = cv2.resize(wall, SIZE, interpolation=cv2.INTER_CUBIC)
    for camera, disparity in (("left", 0), ("right", 12)):
        (folder / camera).mkdir()
        for frame in range(FRAMES):
            picture = empty.copy()
            for u, v, across, down in WALKS if frame else ():
                draw_person(picture, u + across * frame - disparity, v + down * frame)
            cv2.imwrite(str(folder / camera / f"{frame:03}.png"), picture)
    matrix = [FOCAL_PX, 0, SIZE[0] / 2, 0, FOCAL_PX, SIZE[1] / 2, 0, 0, 1]
    shapes = {"M1": (3, matrix), "M2": (3, matrix), "R": (3, np.eye(3).ravel().tolist())}
    shapes |= {"D1": (1, [0.0] * 5), "D2": (1, [0.0] * 5), "T": (3, [-BASELINE_M, 0, 0])}
    said = ["%YAML:1.0", "---", f"image_width: {SIZE[0]}", f"image_height: {SIZE[1]}"]
    for name, (rows, data) in shapes.items():
        said += [f"{name}: !!opencv-matrix", f"   rows: {rows}", f"   cols: {len(data) // rows}"]
        said += ["   dt: d", f"   data: {[float(value) for value in data]}"]
    (folder / "calibration.yaml").write_text("\n".join(said) + "\n")
    return folder


def draw_person(picture: np.ndarray, u: int, v: int) -> None:
    """A trunk with an arm that hangs lower than the feet of the trunk."""
    picture[max(v - 60, 0) : max(v, 0), max(u - 12, 0) : max(u + 12, 0)] = (30, 30, 200)
    picture[max(v - 58, 0) : max(v + 25, 0), max(u + 10, 0) : max(u + 16, 0)] = (120, 40, 30)


@pytest.mark.parametrize("tilt_deg", [-4.0, 0.0, 3.0])
@pytest.mark.parametrize("tracker", sorted(TRACKERS))
def test_every_tracker_goes_over_a_street_at_eye_level(
    street: Path, tmp_path: Path, tracker: str, tilt_deg: float
) -> None:
    folder = shutil.copytree(street, tmp_path / "street")
    (folder / "recording.toml").write_text(
        'format = 1\nfps = 10.0\n[left]\nsource = "left/*.png"\n[right]\nsource = "right/*.png"\n'
        '[calibration]\nfile = "calibration.yaml"\n'
        f"[ground]\nheight = 1.5\ntilt = {tilt_deg}\n"
    )
    with open_recording(folder) as recording, track(recording, tracker) as work:
        assert sum(1 for _ in work) == FRAMES
        run = work.run()
    boxes = [run.tracks[side] for side in ("left", "top", "width", "height")]
    assert np.isfinite(boxes).all()


def test_a_real_street_at_eye_level_is_gone_over(shared_data: Path, tmp_path: Path) -> None:
    calibration = tmp_path / "calibration.yaml"
    matrix = "data: [ 700., 0., 320., 0., 700., 240., 0., 0., 1. ]"
    calibration.write_text(
        "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\n"
        f"M1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   {matrix}\n"
        "D1: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [ 0., 0., 0., 0., 0. ]\n"
    )
    options = OpenOptions(calibration=(calibration,), height_m=1.5, tilt_deg=0.0)
    folder = shared_data / "tud-campus-real"
    with open_recording(folder, options) as recording, track(recording, "three-part") as work:
        assert sum(1 for _ in work) == recording.frame_count
