"""The truth of body parts beside a recording: truth_parts.csv, and visibility.csv if there."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np

from tracking.errors import FormatError
from tracking.failure import TRUE_PARTS, read_true_parts
from tracking.scoring.parts.rectangles import Floats
from tracking.scoring.parts.rows import PartTruth, Whole, by_person, keys
from tracking.tracks import LARGEST_NUMBER

VISIBILITY = "visibility.csv"
_HEADER = ["frame", "id", "visibility"]
_MOST_BYTES = 1 << 30


def read_part_truth(folder: Path, frames: int, size_px: tuple[int, int]) -> PartTruth:
    """The truth beside a recording of so many frames.

    Who is not in visibility.csv is not seen; without that file everybody is seen as a whole.

    Raises:
        FormatError: truth_parts.csv is missing, one of the two is no such table or names a frame
            that the recording does not have; names the line where there is one.
    """
    place = folder / TRUE_PARTS
    true = read_true_parts(place)
    if len(true.frame) and int(true.frame[-1]) >= frames:
        raise FormatError(
            f"{place}: frame {true.frame[-1]}; the recording has 0 to {frames - 1}; "
            "take the truth of this recording"
        )
    corners = np.concatenate((true.box[:, :2], true.box[:, :2] + true.box[:, 2:]), axis=1)
    frame, person, parts = by_person(true.frame, true.person, true.part, corners)
    seen = _seen(folder / VISIBILITY, frame, person)
    return PartTruth(frame, person, parts, seen, size_px)


def _seen(path: Path, frame: Whole, person: Whole) -> Floats:
    """(n,) share of each person that is seen in each frame."""
    if not path.exists():
        return np.ones(len(frame))
    rows = np.array(_rows_of(path), np.float64).reshape(-1, 3)
    known = keys(rows[:, 0].astype(np.int64), rows[:, 1].astype(np.int64))
    order = np.argsort(known, kind="stable")
    known, share = np.append(known[order], -1), np.append(rows[order, 2], 0.0)
    asked = keys(frame, person)
    at = np.searchsorted(known[:-1], asked)
    return np.where(known[at] == asked, share[at], 0.0)


def _rows_of(path: Path) -> list[tuple[int, int, float]]:
    try:
        if path.stat().st_size > _MOST_BYTES:
            raise FormatError(f"{path} is larger than {_MOST_BYTES >> 20} MiB; give a shorter one")
        with path.open(encoding="utf-8-sig", newline="") as stream:
            return list(_checked(path, stream))
    except OSError as error:
        raise FormatError(f"cannot read {path}: {error.strerror}; check the path") from error
    except (UnicodeDecodeError, csv.Error) as error:
        raise FormatError(f"{path} says nobody's visibility ({error})") from error


def _checked(path: Path, stream: Iterable[str]) -> Iterator[tuple[int, int, float]]:
    lines = csv.reader(stream)
    if next(lines, []) != _HEADER:
        raise FormatError(f"{path}, line 1: the columns are not {','.join(_HEADER)}")
    for line in lines:
        try:
            frame, person, share = int(line[0]), int(line[1]), float(line[2])
            if not (0 <= frame <= LARGEST_NUMBER and 0 < person <= LARGEST_NUMBER):
                raise ValueError("frame or id")
            if len(line) != len(_HEADER) or not (math.isfinite(share) and 0 <= share <= 1):
                raise ValueError("a share is from 0 to 1")
        except (ValueError, IndexError) as error:
            raise FormatError(
                f"{path}, line {lines.line_num}: {','.join(line)[:60]!r} is no visibility ({error})"
            ) from error
        yield frame, person, share
