"""When images were taken, as files beside them or their names say."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.owned_files import A_FILE, SAFE_FLAGS, kind_of

Stamps = NDArray[np.int64]
"""(n,) ns since 1970, or since anything that all cameras of a recording share."""

_MOST_BYTES = 64 << 20
_EUROC, _KITTI = "data.csv", "timestamps.txt"
_LINE = re.compile(r"(\d{4}-\d{2}-\d{2} \d{2}:\d{2}:\d{2})(?:\.(\d{1,9}))?\s*")
_MOST_DIGITS = 19
_NANOSECONDS = 18
"""Digits that a name has at the least which is a time in ns: from 2001 on it has 19."""


def stamps_of(files: Sequence[Path], folders: Sequence[Path]) -> Stamps | None:
    """When each image was taken; None where nothing says it of all, or it does not increase.

    Known are EuRoC's data.csv and KITTI's timestamps.txt beside the folder of the images, and names
    that are ns.

    Args:
        files: the images. folders: of the recording; a table that lies in none of them is not read.
    """
    if not files:
        return None
    above = files[0].parent.parent
    if any(lies_in(above, folder) for folder in folders):
        for found in (_of_table(above / _EUROC, files), _of_lines(above / _KITTI, files)):
            if found is not None:
                return _increasing(found)
    return stamps_of_names([file.stem for file in files])


def stamps_of_names(named: Sequence[str]) -> Stamps | None:
    """When each image was taken where all names, without their endings, are ns; else None."""
    if all(_is_number(name) and len(name) >= _NANOSECONDS for name in named):
        return _increasing([int(name) for name in named])
    return None


def has_stamps(folder: Path) -> bool:
    """Whether a table of times stands beside a folder of images."""
    return any(_is_plain(folder.parent / name) for name in (_EUROC, _KITTI))


def lies_in(place: Path, folder: Path) -> bool:
    """Whether a path leads into a folder, links followed."""
    try:
        return place.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError):
        return False


def _is_plain(path: Path) -> bool:
    """Whether a regular file stands there, and no link to one."""
    try:
        return kind_of(path) == A_FILE
    except OSError:
        return False


def _increasing(stamps: Sequence[int]) -> Stamps | None:
    if any(abs(stamp) >= 2**63 for stamp in stamps):
        return None
    found = np.array(stamps, np.int64)
    return found if (np.diff(found) > 0).all() else None


def _of_table(path: Path, files: Sequence[Path]) -> list[int] | None:
    """Of EuRoC's table: a time in ns and a file's name a row."""
    text = _text(path)
    if text is None:
        return None
    named: dict[str, int] = {}
    for row in csv.reader(text.splitlines()):
        if len(row) >= 2 and _is_number(row[0].strip()):
            named[row[1].strip()] = int(row[0])
    stamps = [named.get(file.name) for file in files]
    return [s for s in stamps if s is not None] if None not in stamps else None


def _of_lines(path: Path, files: Sequence[Path]) -> list[int] | None:
    """Of KITTI's lines: date and time of the image of that number."""
    text = _text(path)
    if text is None:
        return None
    lines = text.splitlines()
    stamps = []
    for file in files:
        number = int(file.stem) if _is_number(file.stem) else len(lines)
        found = _LINE.fullmatch(lines[number]) if number < len(lines) else None
        if found is None:
            return None
        stamps.append(_nanoseconds(found[1], found[2] or "0"))
    return stamps


def _is_number(text: str) -> bool:
    """Whether a text is a whole number that 64 bits hold, or nearly."""
    return text.isascii() and text.isdecimal() and len(text) <= _MOST_DIGITS


def _nanoseconds(second: str, fraction: str) -> int:
    try:
        moment = datetime.strptime(second, "%Y-%m-%d %H:%M:%S").replace(tzinfo=UTC)
    except ValueError:  # a 31st of February
        return 0
    return int(moment.timestamp()) * 10**9 + int(fraction.ljust(9, "0"))


def _text(path: Path) -> str | None:
    if not _is_plain(path):
        return None
    try:
        with os.fdopen(os.open(path, os.O_RDONLY | SAFE_FLAGS), "rb") as file:
            held = file.read(_MOST_BYTES + 1)
        return held.decode("utf-8-sig") if len(held) <= _MOST_BYTES else None
    except (OSError, UnicodeDecodeError):
        return None
