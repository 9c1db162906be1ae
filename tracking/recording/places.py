"""Paths that a recording names, kept inside its folder."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path, PurePosixPath, PureWindowsPath

from tracking.errors import RecordingError
from tracking.recording.depth_pictures import DepthImages, DepthSource
from tracking.recording.images import IMAGE_SUFFIXES, ImageSource, image_files
from tracking.recording.pictures import PictureSource
from tracking.recording.time_stamps import lies_in, stamps_of
from tracking.recording.video import VideoSource

_GLOB_SIGNS = "*?["


def place_inside(folder: Path, named: str, allow_outside: bool) -> Path:
    """The path a manifest names, relative to the recording's folder.

    Raises:
        RecordingError: it is absolute or climbs out, also by a link, and that is not allowed.
    """
    path = folder / named
    if "\\" in named and not path.exists():
        # Written on Windows.
        path = folder / named.replace("\\", "/")
    if allow_outside:
        return path
    absolute = PurePosixPath(named).is_absolute() or PureWindowsPath(named).anchor
    inside = not absolute and ".." not in path.relative_to(folder).parts
    if not inside or not all(lies_in(place, folder) for place in _places(path)):
        raise RecordingError(
            "{folder}: its manifest names {named!r} outside the folder; move the file inside, "
            "or add --allow-outside where you trust the recording",
            folder=folder,
            named=named,
        )
    return path


def open_pictures(path: Path, name: str, folders: Sequence[Path] | None = None) -> PictureSource:
    """The pictures at a path: a video, one image, an image folder or a glob of images.

    Args:
        path: where they are.
        name: what to call them in messages.
        folders: in which files may tell when the images were taken; None: the path's own.

    Raises:
        RecordingError: nothing is there, or it cannot be read.
    """
    files = _images_at(path)
    if files is None:
        return VideoSource(path, name)
    return ImageSource(files, name, stamps_of(files, folders or (path.parent,)))


def open_depth(path: Path, name: str, scale_m: float) -> DepthSource:
    """The depth at a path: one image, an image folder or a glob of images.

    Args:
        path: where it is. name: what to call it in messages. scale_m: metres of a unit.

    Raises:
        RecordingError: nothing is there, or it is no depth.
    """
    if not is_pattern(path.name) and not path.exists():
        raise RecordingError("{path}: no such depth images; check the path", path=path)
    files = _images_at(path)
    if files is None:
        raise RecordingError(
            "{path}: depth is read from images of 16 bits; give such as depth/*.png", path=path
        )
    return DepthImages(files, name, scale_m)


def _images_at(path: Path) -> list[Path] | None:
    """The images at a path in order; None where it leads to another file."""
    if is_pattern(path.name) and not path.exists():
        return image_files(_matching(path))
    if path.is_dir():
        return image_files([file for file in path.iterdir() if file.is_file()])
    return [path] if path.suffix.lower() in IMAGE_SUFFIXES and path.is_file() else None


def _places(path: Path) -> Iterator[Path]:
    """What a path leads to: itself, or the folders whose files a pattern takes."""
    if not is_pattern(path.name) or path.exists():
        yield path
        return
    fixed = _fixed(path)
    yield fixed
    if fixed != path.parent and fixed.is_dir():
        yield from fixed.glob(path.parent.relative_to(fixed).as_posix())


def _fixed(pattern: Path) -> Path:
    """The deepest folder of a pattern that is there: signs in its own name are no pattern."""
    fixed = pattern.parent
    while is_pattern(str(fixed)) and not fixed.is_dir():
        fixed = fixed.parent
    return fixed


def _matching(pattern: Path) -> list[Path]:
    fixed = _fixed(pattern)
    if not fixed.is_dir():
        raise RecordingError(
            "{pattern}: there is no folder {fixed}; check the path", pattern=pattern, fixed=fixed
        )
    return [file for file in fixed.glob(pattern.relative_to(fixed).as_posix()) if file.is_file()]


def is_pattern(name: str) -> bool:
    """Whether a source is a glob of images."""
    return any(sign in name for sign in _GLOB_SIGNS)
