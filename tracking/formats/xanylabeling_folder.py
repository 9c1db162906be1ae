"""The folder X-AnyLabeling keeps its files in: which file is of which frame."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from tracking.errors import FormatError
from tracking.formats.read_result import Reading
from tracking.formats.row_rules import MAX_FRAME
from tracking.formats.track_format import HEAD_BYTES
from tracking.translation import msg

ENDING = ".json"
_START = re.compile(rb"(?:\xef\xbb\xbf)?\s*\{")
_MEMBERS = (rb'"shapes"\s*:\s*\[', rb'"(?:version|imagePath|imageHeight)"\s*:')
_PICTURES = frozenset(
    {".bmp", ".gif", ".jpeg", ".jpg", ".png", ".pbm", ".pgm", ".ppm", ".tif", ".tiff", ".webp"}
    | {".avif", ".heic", ".heif", ".jp2", ".jfif"}
)
_MOST_FILES = 1_000_000
"""Entries of a folder: ten hours of pictures at 25 a second."""
_LOOKED_INTO = 20
"""So many of a folder's JSON files are looked into before it is none of these."""
_MOST_DIGITS = 9


@dataclass(frozen=True, slots=True)
class FrameFile:
    """A file of a folder, and the frame it is of."""

    path: Path
    frame: int


def looks_like_frame(_path: Path, head: bytes) -> bool:
    """Whether a file begins as one frame of X-AnyLabeling's, or LabelMe's."""
    return _START.match(head) is not None and all(re.search(each, head) for each in _MEMBERS)


def holds_frames(folder: Path) -> bool:
    """Whether a folder has such files."""
    try:
        files, _, _ = _listed(folder)
        for path in files[:_LOOKED_INTO]:
            with path.open("rb") as stream:
                if looks_like_frame(path, stream.read(HEAD_BYTES)):
                    return True
    except (OSError, FormatError):
        return False
    return False


def frame_files(reading: Reading) -> tuple[list[FrameFile], int | None]:
    """The JSON files of a folder by frame, and how many frames there are; None: that is not known.

    Links are not followed, and told as bad. Raises FormatError where it cannot be read, holds far
    too many files, or two files are of one frame.
    """
    files, pictures = files_in(reading, ENDING)
    places = {name: at for at, name in enumerate(pictures)}
    if files and all(path.stem in places for path in files):
        return [FrameFile(path, places[path.stem]) for path in files], len(places)
    found = [FrameFile(path, _number_in(path.stem)) for path in files]
    _check_unique(reading.path, found)
    if found:
        first = min(found, key=lambda each: each.frame)
        reading.notes.append(
            msg(
                "frames are the numbers in files' names: {name} is frame {frame}",
                name=first.path.name,
                frame=first.frame,
            )
        )
    return sorted(found, key=lambda each: each.frame), None


def files_in(reading: Reading, wanted: str) -> tuple[list[Path], list[str]]:
    """Files of a folder with this ending, and the names of pictures without theirs.

    Both are in natural order. Links are not followed, and told as bad. Raises FormatError where it
    cannot be read, or holds far too many files.
    """
    try:
        files, pictures, links = _listed(reading.path, wanted)
    except OSError as error:
        raise FormatError(
            "cannot read {path}: {reason}", path=reading.path, reason=error.strerror
        ) from error
    for name in links:
        reading.bad(name, msg("is a link, and links are not followed"))
    return files, pictures


def _listed(folder: Path, wanted: str = ENDING) -> tuple[list[Path], list[str], list[str]]:
    """Files with the wanted ending and names of pictures, in natural order; names of links."""
    files, pictures, links = [], [], []
    with os.scandir(folder) as entries:
        for number, entry in enumerate(entries):
            if number >= _MOST_FILES:
                raise FormatError(
                    "{folder} holds more than {most} files; split it first",
                    folder=folder,
                    most=_MOST_FILES,
                )
            path = folder / entry.name
            ending = path.suffix.lower()
            if ending == wanted and entry.is_symlink():
                links.append(entry.name)
            elif ending == wanted and entry.is_file(follow_symlinks=False):
                files.append(path)
            elif ending in _PICTURES:
                pictures.append(path.stem)
    files.sort(key=lambda path: _natural(path.stem))
    return files, sorted(set(pictures), key=_natural), sorted(links)


def _natural(name: str) -> list[tuple[int, int, str]]:
    """The order in which people read names: numbers in them count as numbers."""
    return [
        (0, int(part), "") if part.isdigit() and len(part) < 4000 else (1, 0, part)
        for part in re.split(r"([0-9]+)", name.lower())
        if part
    ]


def _number_in(stem: str) -> int:
    """The frame a name tells; 0 where it has no digits. One that can be none is beyond all."""
    last = stem.rsplit("_")[-1]
    found = re.search(r"[0-9]+", last)
    digits = found[0] if found else "0"
    return int(digits) if len(digits.lstrip("0")) <= _MOST_DIGITS else MAX_FRAME


def _check_unique(folder: Path, files: Sequence[FrameFile]) -> None:
    first: dict[int, str] = {}
    for each in files:
        other = first.setdefault(each.frame, each.path.name)
        if other != each.path.name:
            raise FormatError(
                "{folder}: {other} and {name} are both of frame {frame}; put the images beside "
                "them, or number them anew",
                folder=folder,
                other=other,
                name=each.path.name,
                frame=each.frame,
            )
