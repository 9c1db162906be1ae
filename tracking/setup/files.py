"""What in a folder may be cameras."""

from __future__ import annotations

from pathlib import Path

from tracking.errors import CalibrationError, RecordingError
from tracking.geometry import read_calibration
from tracking.recording.bags.bag_pictures import bag_files, is_bag
from tracking.recording.images import IMAGE_SUFFIXES, VIDEO_SUFFIXES
from tracking.recording.locate import locate
from tracking.recording.options import OpenOptions
from tracking.recording.tar_pictures import is_tar
from tracking.translation import Message, msg

_ANY_SIZE = (1920, 1080)
"""Of images, for files that say none: whether it is a calibration does not depend on it."""
_CALIBRATIONS = ("calibration.yaml", "calibration.yml", "calib.txt", "calib.json", "camchain.yaml")


def sources_in(folder: Path) -> tuple[Path, ...]:
    """Videos in a folder, or folders of images in it, or itself where it holds images.

    Raises:
        RecordingError: there are none, or the folder cannot be read.
    """
    try:
        found = _sources_in(folder)
    except OSError as error:
        raise RecordingError(
            "{folder}: cannot be read ({reason}); check the folder",
            folder=folder,
            reason=error.strerror,
        ) from error
    if not found:
        raise RecordingError("{folder}: no videos or images in it; check the folder", folder=folder)
    return found


def _sources_in(folder: Path) -> tuple[Path, ...]:
    inside = sorted(path for path in folder.iterdir() if not path.name.startswith("."))
    videos = tuple(p for p in inside if p.suffix.lower() in VIDEO_SUFFIXES and p.is_file())
    if videos:
        return videos
    folders = tuple(path for path in inside if path.is_dir() and _holds_images(path))
    if folders:
        return folders
    return (folder,) if _holds_images(folder) else ()


def may_be_camera(path: Path) -> bool:
    """Whether a path is a video, or a folder of images; False where it cannot be read."""
    try:
        is_video = path.suffix.lower() in VIDEO_SUFFIXES and path.is_file()
        return is_video or (path.is_dir() and _holds_images(path))
    except OSError:
        return False


def is_document(path: Path) -> bool:
    """Whether a file's name says that it is for people to read: nobody means it as footage."""
    named = path.stem.lower().startswith(_TITLES)
    return (path.suffix.lower() in _DOCUMENTS or named) and not path.is_dir()


_DOCUMENTS = frozenset(
    {".md", ".txt", ".rst", ".pdf", ".doc", ".docx", ".odt", ".rtf", ".html", ".htm", ".log"}
)
_TITLES = ("readme", "license", "licence", "changelog")


def is_container(path: Path) -> bool:
    """Whether a path is a bag or a tar, which says itself what its cameras are."""
    return is_bag(path) or is_tar(path)


def needs_setup(path: Path) -> bool:
    """Whether a path is a folder with videos or images, which cannot be opened as it is.

    False for what cannot be read, and for bags, into which it is not looked: opening tells.
    """
    try:
        if not path.is_dir():
            return False
        return not _can_be_opened(path) and bool(sources_in(path))
    except (RecordingError, OSError):
        return False


def _can_be_opened(folder: Path) -> bool:
    """Whether a folder is a recording, as far as it is told without a bag's program."""
    if is_bag(folder):
        return bool(bag_files(folder))
    try:
        locate(folder, OpenOptions())
    except RecordingError:
        return False
    return True


def _holds_images(folder: Path) -> bool:
    """Whether images lie in a folder; False where it cannot be read."""
    try:
        return any(path.suffix.lower() in IMAGE_SUFFIXES for path in folder.iterdir())
    except OSError:
        return False


def calibration_beside(left: Path) -> tuple[tuple[Path, ...], tuple[Message, ...]]:
    """A calibration by a usual name in the folder of the left camera's file, or none.

    Others have files of these names, too: what is no calibration is left out, and told.
    """
    told: list[Message] = []
    for file in (left.parent / name for name in _CALIBRATIONS):
        if not file.is_file():
            continue
        try:
            read_calibration([file], _ANY_SIZE)
        except CalibrationError as error:
            told.append(msg("not used, as it is no calibration: {why}", why=error))
            continue
        return (file,), tuple(told)
    return (), tuple(told)
