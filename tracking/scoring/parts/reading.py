"""The truth of body parts beside a recording: truth_parts.csv, and visibility.csv if there."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from tracking.errors import FormatError
from tracking.failure import TRUE_PARTS, read_true_parts
from tracking.failure.truth_table import Row, TruthTable, read_table
from tracking.scoring.parts.rectangles import Floats
from tracking.scoring.parts.rows import PartTruth, Whole, by_person, keys
from tracking.tracks import LARGEST_NUMBER

VISIBILITY = "visibility.csv"


def read_part_truth(folder: Path, frames: int, size_px: tuple[int, int]) -> PartTruth:
    """The truth beside a recording of so many frames.

    Who is not in visibility.csv is not seen; without that file everybody is seen as a whole.

    Raises:
        FormatError: truth_parts.csv is missing, one of the two is no such table, has
            somebody twice or names a frame
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
    whole, shares = read_table(path, _TABLE)
    known = np.append(keys(whole[:, 0], whole[:, 1]), -1)
    share = np.append(shares[:, 0], 0.0)
    asked = keys(frame, person)
    at = np.searchsorted(known[:-1], asked)
    return np.where(known[at] == asked, share[at], 0.0)


def _row(line: list[str]) -> Row:
    """Frame and person, and the share that is seen."""
    frame, person, share = int(line[0]), int(line[1]), float(line[2])
    if not (0 <= frame <= LARGEST_NUMBER and 0 < person <= LARGEST_NUMBER):
        raise ValueError("frame or id")
    if not (math.isfinite(share) and 0 <= share <= 1):
        raise ValueError("a share is from 0 to 1")
    return (frame, person), (share,)


_TABLE = TruthTable(
    ("frame", "id", "visibility"), "visibility", "the same person in the same frame", 2, _row
)
