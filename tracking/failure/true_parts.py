"""Where the parts of rendered people really are: the table beside a rendered recording."""

from __future__ import annotations

import csv
import math
from array import array
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.failure.features import Floats
from tracking.tracks import LARGEST_NUMBER

TRUE_PARTS = "truth_parts.csv"
"""The name of the file beside a rendered recording."""

_HEADER = ("frame", "id", "part", "left", "top", "width", "height", "visible_pixels")
_NAMES = {"head": 0, "torso": 1, "hip_leg": 2}
_MOST_BYTES = 256 << 20
"""Three hours of twenty people at 20 frames a second are as large; read, it takes twice that."""

Rows = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class TrueParts:
    """Where the parts of people really are; n rows, sorted by frame, none twice.

    Attributes:
        frame, person, part: (n,). box: (n, 4) left, top, width, height px, hidden or not.
        seen: (n,) pixels of it that are seen.
    """

    frame: Rows
    person: Rows
    part: Rows
    box: Floats
    seen: Rows


def read_true_parts(path: Path) -> TrueParts:
    """The parts of a rendered recording's people.

    Raises FormatError where the file is missing, far too large or no such table, or has a part
    of somebody twice; names the line.
    """
    try:
        size = path.stat().st_size
        if size > _MOST_BYTES:
            raise FormatError(
                f"{path} has {size >> 20} MB, true parts are read up to {_MOST_BYTES >> 20}; "
                "give a shorter recording"
            )
        with path.open(encoding="utf-8-sig", newline="") as stream:
            columns = _columns(path, stream)
    except OSError as error:
        raise FormatError(f"cannot read {path}: {error.strerror}; check the path") from error
    except (UnicodeDecodeError, csv.Error) as error:
        raise FormatError(f"{path} is no table of true parts ({error})") from error
    line, frame, person, part, seen = (np.array(column, np.int64) for column in columns[:5])
    order = np.lexsort((line, part, person, frame))
    _check_once(path, order, line, np.stack((frame, person, part)))
    box = np.array(columns[5], float).reshape(-1, 4)
    order = order[np.argsort(frame[order], kind="stable")]
    return TrueParts(frame[order], person[order], part[order], box[order], seen[order])


def _check_once(path: Path, order: Rows, line: Rows, keys: Rows) -> None:
    """Refuse rows whose frame, person and part, keys (3, n), stand there already."""
    again = np.flatnonzero((np.diff(keys[:, order], axis=1) == 0).all(axis=0))
    if len(again):
        first = again[np.argmin(line[order[again + 1]])]
        before, twice = line[order[first]], line[order[first + 1]]
        raise FormatError(
            f"{path}, line {twice}: line {before} gives the same part of the same person in the "
            "same frame; take one of them out"
        )


def _columns(path: Path, stream: Iterable[str]) -> tuple[array[int] | array[float], ...]:
    """Line, frame, person, part and pixels seen, and the boxes' numbers one after the other."""
    lines = csv.reader(stream)
    if tuple(next(lines, ())) != _HEADER:
        raise FormatError(f"{path}, line 1: the columns are not {','.join(_HEADER)}")
    whole, boxes = tuple(array("q") for _ in range(5)), array("d")
    for line in lines:
        try:
            *numbers, box = _row(line)
        except (ValueError, KeyError, OverflowError) as error:
            raise FormatError(
                f"{path}, line {lines.line_num}: {','.join(line)[:60]!r} is no true part ({error})"
            ) from error
        for column, number in zip(whole, (lines.line_num, *numbers), strict=True):
            column.append(number)
        boxes.extend(box)
    return (*whole, boxes)


def _row(line: list[str]) -> tuple[int, int, int, int, tuple[float, ...]]:
    """Frame, person, part, pixels seen and box. Raises ValueError, KeyError or OverflowError."""
    if len(line) != len(_HEADER):
        raise ValueError(f"{len(line)} values where the header names {len(_HEADER)}")
    frame, person, seen = int(line[0]), int(line[1]), int(line[7])
    box = tuple(map(float, line[3:7]))
    if not all(map(math.isfinite, box)):
        raise ValueError("a number is missing")
    if not (0 <= frame <= LARGEST_NUMBER and 0 < person <= LARGEST_NUMBER):
        raise ValueError("frame or id")
    if min(box[2:]) < 0 or not 0 <= seen <= LARGEST_NUMBER:
        raise ValueError("less than nothing, or far too many pixels")
    return frame, person, _NAMES[line[2]], seen, box
