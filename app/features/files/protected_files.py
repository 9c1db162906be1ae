"""Files that no export replaces, whatever was agreed to: a recording's own, and a session's."""

from __future__ import annotations

import os
from pathlib import Path

from tracking.errors import RecordingError
from tracking.recording import MANIFEST_NAME, TRUTH_NAME, read_manifest
from tracking.recording.images import IMAGE_SUFFIXES
from tracking.translation import Message, msg
from tracking.truth import TRUE_PARTS, VISIBILITY

_BY_NAME = frozenset((MANIFEST_NAME, TRUTH_NAME, TRUE_PARTS, VISIBILITY))
_FOLDERS_ABOVE = 4
"""So far above a picture its recording.toml is looked for."""
_BESIDE_SESSIONS = ".trackwright"
"""Of folders that begin with a dot: lock, journal and backups of a session."""


def why_protected(path: Path) -> Message:
    """What a file is that must not be replaced, as a sentence needs it; "" where it may be."""
    place = Path(os.path.realpath(path))
    parent = place.parent
    if parent.name.startswith(".") and parent.name.endswith(_BESIDE_SESSIONS):
        return msg("a file that a session keeps beside it")
    for folder in list(place.parents)[:_FOLDERS_ABOVE]:
        if (folder / MANIFEST_NAME).is_file() and _is_of(folder, place):
            return msg("part of the recording {name}", name=folder.name)
    return Message()


def _is_of(folder: Path, place: Path) -> bool:
    """Whether the recording of a folder is made of the file, or has its ground truth there."""
    if place.parent == folder and place.name in _BY_NAME:
        return True
    try:
        manifest = read_manifest(folder)
    except RecordingError:
        return False  # it says of no file that the recording is made of it
    cameras = (manifest.left, manifest.right, manifest.depth)
    sources = filter(None, (*cameras, *manifest.calibration))
    return any(_is_named(folder, source, place) for source in sources)


def _is_named(folder: Path, source: str, place: Path) -> bool:
    """Whether a file, a folder of pictures or a glob, relative to the folder, is of that file."""
    named = Path(os.path.realpath(folder / source))
    if named.is_dir():
        return place.parent == named and place.suffix.lower() in IMAGE_SUFFIXES
    inside = place.is_relative_to(folder)
    return place == named or (inside and place.relative_to(folder).match(os.path.normpath(source)))
