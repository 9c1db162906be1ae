"""EuRoC's folders (ASL format): mav0/cam0/data.csv, data/*.png and sensor.yaml."""

from __future__ import annotations

from pathlib import Path

from tracking.errors import CalibrationError
from tracking.geometry.calibration_file_text import parse_yaml, read_text
from tracking.geometry.file_values import pose_of
from tracking.recording.kinds.folders import images_in
from tracking.recording.kinds.kind import FoundSources, RecordingKind
from tracking.translation import N_

_TABLE, _SENSOR = "data.csv", "sensor.yaml"


def find_euroc(folder: Path) -> FoundSources | None:
    """The cameras of a sequence, opened at its folder or at `mav0`; None: it is none."""
    for root in (folder / "mav0", folder):
        cameras = [root / name for name in ("cam0", "cam1")]
        if (cameras[0] / _TABLE).is_file() and images_in(cameras[0]) is not None:
            return _found(folder, [camera for camera in cameras if images_in(camera)])
    return None


def _found(folder: Path, cameras: list[Path]) -> FoundSources:
    files = [camera / _SENSOR for camera in cameras]
    calibration = tuple(files) if all(file.is_file() for file in files) else ()
    if len(cameras) == 2 and calibration and _second_is_left(calibration):
        cameras, calibration = cameras[::-1], calibration[::-1]
    left, *right = [images_in(camera) or camera for camera in cameras]
    name = folder.resolve().name
    return FoundSources(left, right[0] if right else None, calibration=calibration, name=name)


def _second_is_left(calibration: tuple[Path, ...]) -> bool:
    """Whether camera 1 stands left of camera 0; what cannot be read is told when it is opened."""
    try:
        values = [parse_yaml(read_text(path), path) for path in calibration]
        poses = [pose_of(one, "T_BS", path) for one, path in zip(values, calibration, strict=True)]
    except CalibrationError:
        return False
    (turn, first), (_, second) = poses
    return float((turn.T @ (second - first))[0]) < 0


EUROC = RecordingKind(
    "euroc", N_("EuRoC (ASL) folders: mav0/cam0 with data.csv and sensor.yaml"), find_euroc
)
