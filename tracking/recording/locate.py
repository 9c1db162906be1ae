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
from tracking.recording.places import is_pattern, place_inside
from tracking.translation import Message, msg

_KITTI_FPS = 10.0
VIDEO_SUFFIXES = frozenset(
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
        own: the text is the folder's recording.toml, as read.
        notes: what was taken for granted, in words.
    """

    path: Path
    folder: Path
    manifest: Manifest
    text: str
    trusted: bool
    own: bool = False
    notes: tuple[Message, ...] = ()


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
        raise RecordingError("{path}: no such recording; check the path", path=path)
    if path.is_dir():
        return _with_options(_in_folder(path), options)
    if path.name == MANIFEST_NAME:
        return _with_options(_in_folder(path.parent), options)
    if path.suffix.lower() in IMAGE_SUFFIXES:
        raise RecordingError("{path}: a single image; open the folder it is in", path=path)
    return _with_options(_made_up(path, path.stem, path, None), options)


def from_manifest(place: Path, text: str) -> Located:
    """A recording whose manifest is kept elsewhere.

    Args:
        place: the folder the manifest's paths are relative to; or the left (or only) camera's
            pictures, by whatever name they have now, with everything else beside them.
        text: the manifest.

    Raises:
        RecordingError: the text is no manifest.
    """
    manifest = parse_manifest(text, msg("{place}: its manifest", place=place), place.resolve().name)
    folder = place
    if _is_source(place, manifest.left):
        folder = place.parent
        if place.name != manifest.left:
            manifest = replace(manifest, left=place.name)
            text = format_manifest(manifest)
    alone = manifest.right is None and not is_pattern(manifest.left)
    return Located(folder / manifest.left if alone else folder, folder, manifest, text, False)


def _is_source(place: Path, left: str) -> bool:
    """Whether pictures stand at a place, and not the folder from which `left` leads to them."""
    if not place.is_dir():
        return True
    if is_pattern(left) or (place / left).exists():
        return False
    return _images_in(place) == place


def _in_folder(folder: Path) -> Located:
    if (folder / MANIFEST_NAME).exists():
        text = manifest_text(folder)
        manifest = parse_manifest(text, str(folder / MANIFEST_NAME), folder.resolve().name)
        return Located(folder, folder, manifest, text, trusted=False, own=True)
    kitti = _kitti(folder) or _only_sequence(folder)
    if kitti is not None:
        rate = msg(
            "frames per second are not stated: {fps:g}, as KITTI has; --fps says otherwise",
            fps=_KITTI_FPS,
        )
        return replace(kitti, notes=(rate,))
    name = folder.resolve().name
    if image_files([file for file in folder.iterdir() if file.is_file()]):
        return _made_up(folder, name, folder, None)
    left, right = _camera(folder, "left"), _camera(folder, "right")
    if left is not None:
        return _made_up(folder, name, left, right)
    raise RecordingError(
        "{folder}: no recording in this folder; it needs a {manifest}, images, or videos "
        "called left and right",
        folder=folder,
        manifest=MANIFEST_NAME,
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
    cameras = [left] if right is None else [left, right]
    folder = _shared_folder([*cameras, *calibration])
    manifest = Manifest(
        name,
        _relative(left, folder),
        _relative(right, folder) if right is not None else None,
        fps=fps,
        calibration=tuple(_relative(file, folder) for file in calibration),
    )
    return Located(path, folder, manifest, format_manifest(manifest), trusted=True)


def _with_options(found: Located, options: OpenOptions) -> Located:
    if options.calibration:
        found = _with_calibration(found, options)
    manifest = found.manifest
    changed = replace(
        manifest,
        fps=options.rate(manifest.fps),
        layout=options.layout or manifest.layout,
        first=options.first or manifest.first,
        right_lag=manifest.right_lag if options.right_lag is None else options.right_lag,
        ground=options.ground(manifest.ground),
        region=options.region(manifest.region),
    )
    if changed == manifest:
        return found
    if changed.layout and changed.right:
        raise RecordingError(
            "{path}: has a source for each camera; leave out the layout of both in one",
            path=found.path,
        )
    text = format_manifest(changed)
    notes = () if options.fps else found.notes
    return replace(found, manifest=changed, text=text, own=False, notes=notes)


def _with_calibration(found: Located, options: OpenOptions) -> Located:
    """The same with the calibration the user names, relative to a folder that holds both.

    So the manifest leads to everything without climbing out, wherever it is kept.
    """
    manifest = found.manifest
    sources = [manifest.left] if manifest.right is None else [manifest.left, manifest.right]
    inside = found.trusted or options.allow_outside
    cameras = [place_inside(found.folder, source, inside) for source in sources]
    folder = _shared_folder([found.folder / "any", *cameras, *options.calibration])
    left, *right = (_relative(camera, folder) for camera in cameras)
    calibration = tuple(_relative(file, folder) for file in options.calibration)
    changed = replace(
        manifest, left=left, right=right[0] if right else None, calibration=calibration
    )
    text = format_manifest(changed)
    return replace(found, folder=folder, manifest=changed, text=text, own=False)


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


def _only_sequence(folder: Path) -> Located | None:
    """The sequence of a KITTI benchmark's tree that has one; None where it is no such tree.

    Raises:
        RecordingError: there are several, of which the user must choose.
    """
    for half in (folder, folder / "training", folder / "testing"):
        if (half / "image_02").is_dir():
            found = [place for place in sorted((half / "image_02").iterdir()) if _images_in(place)]
            if len(found) > 1:
                raise RecordingError(
                    "{folder}: holds {count} KITTI sequences; open one of them, e.g. {example}",
                    folder=folder,
                    count=len(found),
                    example=found[0],
                )
            return _kitti(found[0]) if found else None
    return None


def _images_in(folder: Path) -> Path | None:
    """The folder, or the `data` folder in it, that has images."""
    for place in (folder, folder / "data"):
        if place.is_dir() and image_files([f for f in place.iterdir() if f.is_file()]):
            return place
    return None


def _camera(folder: Path, side: str) -> Path | None:
    """A video or an image folder with a camera's name."""
    if _images_in(folder / side) is not None:
        return _images_in(folder / side)
    videos = [f for f in folder.glob(f"{side}.*") if f.suffix.lower() in VIDEO_SUFFIXES]
    return min(videos, default=None)


def _first_file(*places: tuple[Path, str]) -> tuple[Path, ...]:
    return next(((place / name,) for place, name in places if (place / name).is_file()), ())


def _shared_folder(files: Sequence[Path]) -> Path:
    """The deepest folder that holds all files; the first one's where they share no drive."""
    folders = [Path(os.path.abspath(file)).parent for file in files]  # noqa: PTH100 - links stay
    try:
        return Path(os.path.commonpath(folders))
    except ValueError:
        return folders[0]


def _relative(file: Path, folder: Path) -> str:
    """The path as seen from the folder, with forward slashes."""
    absolute = os.path.abspath(file)  # noqa: PTH100 - links stay as they are named
    try:
        return Path(os.path.relpath(absolute, folder)).as_posix()
    except ValueError:
        return Path(absolute).as_posix()
