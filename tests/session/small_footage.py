"""Real recordings of three small pictures a camera, and sessions on them."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from tracking.geometry import Camera, Ground, StereoCalibration, write_calibration
from tracking.recording import Manifest, OpenOptions, Recording, open_recording, write_manifest
from tracking.session import Session

GROUND = Ground(2.4, 30.0)


def write_pictures(folder: Path, seed: int) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(seed)
    for number in range(3):
        picture = random.integers(0, 255, (24, 32, 3), np.uint8)
        cv2.imwrite(str(folder / f"{number}.png"), picture)
    return folder


def write_rig(path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    matrix = np.array([[25.0, 0, 16], [0, 25, 12], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), 32, 24)
    rig = StereoCalibration(camera, camera, np.eye(3), np.array([-0.1, 0, 0]))
    write_calibration(path, rig)
    return path


def write_footage(folder: Path) -> Path:
    """A folder with recording.toml: two cameras, calibrated, over a floor."""
    write_pictures(folder / "left", 1)
    write_pictures(folder / "right", 2)
    write_rig(folder / "rig.yaml")
    manifest = Manifest("Hall", "left", "right", fps=10, calibration=("rig.yaml",), ground=GROUND)
    write_manifest(folder, manifest)
    return folder


def session_on(path: Path, recording: Path, options: OpenOptions | None = None) -> Path:
    """A saved and closed session on a recording."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open_recording(recording, options) as opened:
        Session.create(opened, path=path).close()
    return path


def reopened(path: Path) -> Session:
    """The session, open for reading."""
    session = Session.open(path)
    session.close()
    return session


def is_whole(recording: Recording) -> bool:
    """Whether both cameras, the calibration and the floor are there; closes it."""
    recording.close()
    return (
        recording.is_stereo
        and recording.rectification is not None
        and recording.ground == GROUND
        and recording.fps == 10
        and recording.frame_count == 3
    )
