"""Folders that an OAK camera's programs write: pictures or videos of each camera, calib.json."""

from __future__ import annotations

import json
from pathlib import Path

from tracking.recording.kinds.folders import camera_in, images_in
from tracking.recording.kinds.kind import FoundSources, RecordingKind
from tracking.recording.tar_pictures import images_of, is_tar, members_of, read_member
from tracking.translation import N_

_NAMES = ("calib.json", "calibration.json")
_FOLDERS = ("left", "right", "depth")
_MOST_BYTES = 256 * 1024


def find_oak(folder: Path) -> FoundSources | None:
    """Left and right, or left and depth, of a folder or a tar; None without its calibration."""
    if is_tar(folder):
        return _in_tar(folder)
    if not folder.is_dir():
        return None
    calibration = [folder / name for name in _NAMES if is_oak_calibration(folder / name)]
    left = camera_in(folder, "left")
    if not calibration or left is None:
        return None
    right = camera_in(folder, "right")
    depth = None if right is not None else images_in(folder / "depth")
    name = folder.resolve().name
    return FoundSources(left, right, depth, calibration=tuple(calibration[:1]), name=name)


def _in_tar(path: Path) -> FoundSources | None:
    members = members_of(path)
    left, right, depth = (bool(images_of(members, name)) for name in _FOLDERS)
    if not left:
        return None
    return FoundSources(
        path,
        path if right else None,
        path if depth and not right else None,
        calibration=(path,) if calibration_in_tar(path) else (),
        topics=("left", "right" if right else "", "depth" if depth and not right else ""),
        name=path.stem,
    )


def calibration_in_tar(path: Path) -> str:
    """The text of an OAK's calibration in a tar; "" where there is none."""
    for member in members_of(path):
        if member.name.name in _NAMES and member.size <= _MOST_BYTES:
            text = read_member(path, member).decode("utf-8", "replace")
            if '"cameraData"' in text:
                return text
    return ""


def is_oak_calibration(path: Path) -> bool:
    """Whether a file is an OAK's calibration."""
    try:
        if not path.is_file() or path.stat().st_size > _MOST_BYTES:
            return False
        values = json.loads(path.read_text("utf-8-sig"))
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(values, dict) and "cameraData" in values


OAK = RecordingKind(
    "oak", N_("OAK folders and tars: left, right or depth, and calib.json"), find_oak
)
