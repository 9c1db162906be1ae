"""What in a folder may be cameras."""

from __future__ import annotations

from pathlib import Path

from tracking.errors import RecordingError
from tracking.recording.images import IMAGE_SUFFIXES, VIDEO_SUFFIXES
from tracking.recording.locate import locate
from tracking.recording.options import OpenOptions


def sources_in(folder: Path) -> tuple[Path, ...]:
    """Videos in a folder, or folders of images in it, or itself where it holds images.

    Raises:
        RecordingError: there are none.
    """
    inside = sorted(path for path in folder.iterdir() if not path.name.startswith("."))
    videos = tuple(p for p in inside if p.suffix.lower() in VIDEO_SUFFIXES and p.is_file())
    if videos:
        return videos
    folders = tuple(path for path in inside if path.is_dir() and _holds_images(path))
    if folders:
        return folders
    if _holds_images(folder):
        return (folder,)
    raise RecordingError("{folder}: no videos or images in it; check the folder", folder=folder)


def may_be_camera(path: Path) -> bool:
    """Whether a path is a video, or a folder of images."""
    is_video = path.suffix.lower() in VIDEO_SUFFIXES and path.is_file()
    return is_video or (path.is_dir() and _holds_images(path))


def needs_setup(path: Path) -> bool:
    """Whether a path is a folder with videos or images, which cannot be opened as it is."""
    if not path.is_dir():
        return False
    try:
        locate(path, OpenOptions())
    except RecordingError:
        pass
    else:
        return False
    try:
        return bool(sources_in(path))
    except RecordingError:
        return False


def _holds_images(folder: Path) -> bool:
    return any(path.suffix.lower() in IMAGE_SUFFIXES for path in folder.iterdir())
