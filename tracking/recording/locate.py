"""What lies at a path, as a manifest: a folder with or without one, a video, KITTI."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from tracking.errors import RecordingError
from tracking.recording.images import IMAGE_SUFFIXES, image_files
from tracking.recording.manifest import (
    MANIFEST_NAME,
    Manifest,
    format_manifest,
    manifest_text,
    parse_manifest,
)
from tracking.recording.options import OpenOptions

_KITTI_FPS = 10.0
_VIDEO_SUFFIXES = frozenset(
    (".mp4", ".m4v", ".mov", ".avi", ".mkv", ".webm", ".ts", ".mts", ".m2ts", ".mpg", ".mpeg")
)


@dataclass(frozen=True, slots=True)
class Located:
    """A recording found at a path, not opened yet.

    Attributes:
        path: what the user named.
        folder: what the manifest's paths are relative to.
        manifest: the recording's own, or one made up for what was found.
        text: the manifest's text.
        trusted: the paths come from the user or were found, not from a file.
    """

    path: Path
    folder: Path
    manifest: Manifest
    text: str
    trusted: bool


def locate(path: Path, options: OpenOptions) -> Located:
    """Find out what a path holds; options overrule what is found.

    Raises:
        RecordingError: nothing is there, or nothing that could be a recording.
    """
    if options.left is not None:
        return _with_options(
            _made_up(path, options.left.stem, options.left, options.right), options
        )
    if not path.exists():
        raise RecordingError(f"{path}: no such recording; check the path")
    if path.is_dir():
        return _with_options(_in_folder(path), options)
    if path.name == MANIFEST_NAME:
        return _with_options(_in_folder(path.parent), options)
    if path.suffix.lower() in IMAGE_SUFFIXES:
        raise RecordingError(f"{path}: a single image; open the folder it is in")
    return _with_options(_made_up(path, path.stem, path, None), options)


def from_manifest(folder: Path, text: str) -> Located:
    """A recording whose manifest is kept elsewhere; its paths are relative to the folder.

    Raises:
        RecordingError: the text is no manifest.
    """
    where = str(folder / MANIFEST_NAME)
    manifest = parse_manifest(text, where, folder.resolve().name)
    return Located(folder, folder, manifest, text, trusted=False)


def _in_folder(folder: Path) -> Located:
    if (folder / MANIFEST_NAME).exists():
        return from_manifest(folder, manifest_text(folder))
    kitti = _kitti(folder)
    if kitti is not None:
        return kitti
    name = folder.resolve().name
    if image_files([file for file in folder.iterdir() if file.is_file()]):
        return _made_up(folder, name, folder, None)
    left, right = _eye(folder, "left"), _eye(folder, "right")
    if left is not None:
        return _made_up(folder, name, left, right)
    raise RecordingError(
        f"{folder}: no recording in this folder; it needs a {MANIFEST_NAME}, images, or videos "
        "called left and right"
    )


def _made_up(
    path: Path,
    name: str,
    left: Path,
    right: Path | None,
    calibration: Sequence[Path] = (),
    fps: float | None = None,
) -> Located:
    """A manifest for files that have none, with paths relative to a folder they share."""
    files = [Path(os.path.abspath(file)) for file in (left, right) if file is not None]  # noqa: PTH100 - links stay
    try:
        folder = Path(os.path.commonpath([file.parent for file in files]))
    except ValueError:
        folder = files[0].parent
    manifest = Manifest(
        name,
        _relative(files[0], folder),
        _relative(files[1], folder) if right is not None else None,
        fps=fps,
        calibration=tuple(_relative(file, folder) for file in calibration),
    )
    return Located(path, folder, manifest, format_manifest(manifest), trusted=True)


def _with_options(found: Located, options: OpenOptions) -> Located:
    manifest = found.manifest
    calibration = tuple(_relative(file, found.folder) for file in options.calibration)
    changed = replace(
        manifest,
        fps=options.fps or manifest.fps,
        layout=options.layout or manifest.layout,
        first=options.first or manifest.first,
        calibration=calibration or manifest.calibration,
        ground=options.ground(manifest.ground),
    )
    if changed == manifest:
        return found
    if changed.layout and changed.right:
        raise RecordingError(
            f"{found.path}: has a source for each eye; leave out the layout of both in one"
        )
    return replace(found, manifest=changed, text=format_manifest(changed))


def _kitti(folder: Path) -> Located | None:
    """A KITTI sequence: image_02 and image_03 in a folder, or one sequence of the benchmark's.

    Known are the raw data's (image_02/data), the odometry benchmark's (image_2) and the tracking
    benchmark's tree (training/image_02/0000 with training/calib/0000.txt).
    """
    for left_name, right_name in (("image_02", "image_03"), ("image_2", "image_3")):
        left = _images_in(folder / left_name)
        if left is not None:
            right = _images_in(folder / right_name)
            calibration = _first_file(
                (folder, "calib.txt"), (folder, "calib_cam_to_cam.txt"),
                (folder.parent, "calib_cam_to_cam.txt"),
            )  # fmt: skip
            return _made_up(folder, folder.resolve().name, left, right, calibration, _KITTI_FPS)
    if folder.parent.name == "image_02" and _images_in(folder) is not None:
        training = folder.parent.parent
        right = _images_in(training / "image_03" / folder.name)
        calibration = _first_file((training / "calib", f"{folder.name}.txt"))
        return _made_up(folder, folder.name, folder, right, calibration, _KITTI_FPS)
    return None


def _images_in(folder: Path) -> Path | None:
    """The folder, or the `data` folder in it, that has images."""
    for place in (folder, folder / "data"):
        if place.is_dir() and image_files([f for f in place.iterdir() if f.is_file()]):
            return place
    return None


def _eye(folder: Path, side: str) -> Path | None:
    """A video or an image folder with an eye's name."""
    if _images_in(folder / side) is not None:
        return _images_in(folder / side)
    videos = [f for f in folder.glob(f"{side}.*") if f.suffix.lower() in _VIDEO_SUFFIXES]
    return min(videos, default=None)


def _first_file(*places: tuple[Path, str]) -> tuple[Path, ...]:
    return next(((place / name,) for place, name in places if (place / name).is_file()), ())


def _relative(file: Path, folder: Path) -> str:
    """The path as seen from the folder, with forward slashes."""
    absolute = os.path.abspath(file)  # noqa: PTH100 - links stay as they are named
    try:
        return Path(os.path.relpath(absolute, folder)).as_posix()
    except ValueError:
        return Path(absolute).as_posix()
