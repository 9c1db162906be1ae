"""What Stereolabs' SVO export writes: left and right or depth PNG, or a video side by side."""

from __future__ import annotations

import re
from pathlib import Path

import av

from tracking.errors import RecordingError
from tracking.recording.images import VIDEO_SUFFIXES
from tracking.recording.kinds.kind import FoundSources, RecordingKind
from tracking.recording.packet_index import open_video
from tracking.translation import N_, Message, msg

_PICTURE = re.compile(r"(left|right|depth)(\d{6})\.png")
_SERIAL = "SN*.conf"
_FPS = 30.0
_WIDTHS = (1344, 1920, 2560, 3840, 4416)
"""Of both cameras side by side, px."""


def find_zed(path: Path) -> FoundSources | None:
    """An export's folder, or its video; None: it is none."""
    if not path.is_dir():
        return _video(path, path.parent) if _is_wide(path) else None
    sides = {found[1] for file in path.iterdir() if (found := _PICTURE.fullmatch(file.name))}
    if "left" in sides and len(sides) > 1:
        return _pictures(path, sides)
    videos = [file for file in path.iterdir() if file.suffix.lower() in VIDEO_SUFFIXES]
    return _video(videos[0], path) if len(videos) == 1 and _is_wide(videos[0]) else None


def _pictures(folder: Path, sides: set[str]) -> FoundSources:
    calibration = _calibration(folder)
    right = folder / "right??????.png" if "right" in sides else None
    depth = folder / "depth??????.png" if right is None else None
    rate = msg(
        "frames per second are not stated: {fps:g}, as a ZED records; --fps says otherwise",
        fps=_FPS,
    )
    return FoundSources(
        folder / "left??????.png",
        right,
        depth,
        calibration=calibration,
        fps=_FPS,
        name=folder.resolve().name,
        notes=(rate, *_rectified(calibration)),
    )


def _video(path: Path, folder: Path) -> FoundSources | None:
    """A video side by side; only where the camera's calibration says that it is a ZED's."""
    calibration = _calibration(folder)
    if not calibration:
        return None
    return FoundSources(
        path,
        calibration=calibration,
        layout="side-by-side",
        name=path.stem,
        notes=_rectified(calibration),
    )


def _is_wide(path: Path) -> bool:
    """Whether a file is a video as wide as both cameras of a ZED."""
    if path.suffix.lower() not in VIDEO_SUFFIXES or not path.is_file():
        return False
    if not _calibration(path.parent):
        return False
    try:
        container, stream = open_video(str(path))
    except (RecordingError, av.error.FFmpegError, OSError):
        return False
    with container:
        return stream.codec_context.width in _WIDTHS


def _calibration(folder: Path) -> tuple[Path, ...]:
    return tuple(sorted(folder.glob(_SERIAL))[:1])


def _rectified(calibration: tuple[Path, ...]) -> tuple[Message, ...]:
    if not calibration:
        return ()
    return (
        msg(
            "{name} is of images as the camera takes them; where they were exported rectified, "
            "give the calibration of the rectified ones",
            name=calibration[0].name,
        ),
    )


ZED = RecordingKind(
    "zed", N_("ZED exports: left and right or depth PNG, video side by side, SN*.conf"), find_zed
)
