"""What lies at a path, as a manifest: a folder with or without one, a video, KITTI."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from tracking.errors import RecordingError
from tracking.recording.images import IMAGE_SUFFIXES, image_files
from tracking.recording.kinds.catalogue import find_sources, told_of_plugins
from tracking.recording.kinds.folders import camera_in, images_in
from tracking.recording.kinds.kind import FoundSources
from tracking.recording.manifest import (
    MANIFEST_NAME,
    Manifest,
    manifest_text,
    names_sources,
    parse_manifest,
)
from tracking.recording.manifest_writer import format_manifest
from tracking.recording.options import OpenOptions
from tracking.recording.places import is_pattern, place_inside
from tracking.translation import Message, msg


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
        sourceless: the folder at `path` has a recording.toml that names no sources, taken as read.
        notes: what was taken for granted, in words.
    """

    path: Path
    folder: Path
    manifest: Manifest
    text: str
    trusted: bool
    own: bool = False
    sourceless: bool = False
    notes: tuple[Message, ...] = ()


def locate(path: Path, options: OpenOptions) -> Located:
    """Find out what a path holds; options overrule what is found.

    Raises:
        RecordingError: nothing is there, or nothing that could be a recording.
    """
    if options.left is not None:
        return _with_options(_of_sources(path, _named(options.left, options)), options)
    if not path.exists():
        raise RecordingError("{path}: no such recording; check the path", path=path)
    if path.is_dir():
        return _with_options(_in_folder(path), options)
    if path.name == MANIFEST_NAME:
        return _with_options(_in_folder(path.parent), options)
    if path.suffix.lower() in IMAGE_SUFFIXES:
        raise RecordingError("{path}: a single image; open the folder it is in", path=path)
    found = find_sources(path)
    if found is not None:
        return _with_options(_of_sources(path, found), options)
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
    return images_in(place) == place


def _in_folder(folder: Path) -> Located:
    if (folder / MANIFEST_NAME).exists():
        text = manifest_text(folder)
        where, name = str(folder / MANIFEST_NAME), folder.resolve().name
        if not names_sources(text, where):
            return _with_manifest(folder, text, where)
        manifest = parse_manifest(text, where, name)
        return Located(folder, folder, manifest, text, trusted=False, own=True)
    found = find_sources(folder)
    if found is not None:
        return _of_sources(folder, found)
    name = folder.resolve().name
    if image_files([file for file in folder.iterdir() if file.is_file()]):
        return _made_up(folder, name, folder, None)
    left, right = camera_in(folder, "left"), camera_in(folder, "right")
    if left is not None:
        return _made_up(folder, name, left, right)
    failed = told_of_plugins()
    raise RecordingError(
        "{folder}: no recording in this folder; it needs a {manifest}, images, or videos "
        "called left and right{failed}",
        folder=folder,
        manifest=MANIFEST_NAME,
        failed=" (" + failed + ")" if failed else "",
    )


def _made_up(path: Path, name: str, left: Path, right: Path | None) -> Located:
    """A manifest for files that have none."""
    return _of_sources(path, FoundSources(left, right, name=name))


def _named(left: Path, options: OpenOptions) -> FoundSources:
    """The sources that the options name."""
    return FoundSources(
        left,
        options.right,
        options.depth,
        depth_scale_m=options.depth_scale_m,
        topics=options.topics,
        name=left.stem,
    )


def _of_sources(path: Path, found: FoundSources, base: Path | None = None) -> Located:
    """A manifest for what was found.

    Paths are relative to `base`, or to a folder that all of it shares.
    """
    sources = (found.left, found.right, found.depth)
    files = [*(one for one in sources if one is not None), *found.calibration]
    folder = _shared_folder(files) if base is None else base
    left, right, depth = (None if one is None else _relative(one, folder) for one in sources)
    assert left is not None
    manifest = Manifest(
        found.name or path.resolve().name,
        left,
        right,
        layout=found.layout,
        depth=depth,
        depth_scale_m=found.depth_scale_m,
        topics=found.topics,
        fps=found.fps,
        calibration=tuple(_relative(file, folder) for file in found.calibration),
    )
    text = format_manifest(manifest)
    return Located(path, folder, manifest, text, trusted=True, notes=found.notes)


def _with_manifest(folder: Path, text: str, where: str) -> Located:
    """What a folder holds, with a recording.toml that names no sources: floor, rate, region."""
    found = find_sources(folder)
    if found is None:
        parse_manifest(text, where, folder.name)  # says what is missing
        raise RecordingError("{where}: names no sources", where=where)
    located = _of_sources(folder, found, folder)
    own = parse_manifest(text, where, located.manifest.name, located.manifest)
    # What was found may lie above the folder, as KITTI's calibration does; what a text names not.
    trusted = own.calibration == located.manifest.calibration
    if trusted and any(".." in Path(file).parts for file in own.calibration):
        # A session keeps the text, which must lead to everything without climbing out.
        located = _of_sources(folder, found)
        seen = located.manifest
        own = replace(
            own, left=seen.left, right=seen.right, depth=seen.depth, calibration=seen.calibration
        )
    text = format_manifest(own)
    return replace(located, manifest=own, text=text, trusted=trusted, sourceless=True)


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
    return replace(found, manifest=changed, text=text, own=False, sourceless=False, notes=notes)


def _with_calibration(found: Located, options: OpenOptions) -> Located:
    """The same with the calibration the user names, relative to a folder that holds both.

    So the manifest leads to everything without climbing out, wherever it is kept.
    """
    manifest = found.manifest
    inside = found.trusted or options.allow_outside
    left, right, depth = (
        None if source is None else place_inside(found.folder, source, inside)
        for source in (manifest.left, manifest.right, manifest.depth)
    )
    sources = [source for source in (left, right, depth) if source is not None]
    folder = _shared_folder([found.folder / "any", *sources, *options.calibration])
    assert left is not None, "each manifest has a left source"
    changed = replace(
        manifest,
        left=_relative(left, folder),
        right=_relative(right, folder) if right else None,
        depth=_relative(depth, folder) if depth else None,
        calibration=tuple(_relative(file, folder) for file in options.calibration),
    )
    text = format_manifest(changed)
    return replace(found, folder=folder, manifest=changed, text=text, own=False, sourceless=False)


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
