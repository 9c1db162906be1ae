"""What is true of rendered people: where their parts are, and how much of them is seen."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from tracking.arrays import Floats
from tracking.tracks import LARGEST_NUMBER, PART_WORDS
from tracking.truth.table import Row, Rows, TruthTable, read_table

TRUE_PARTS = "truth_parts.csv"
"""The name of the file beside a rendered recording."""

TRUE_PART_COLUMNS = ("frame", "id", "part", "left", "top", "width", "height", "visible_pixels")
_NUMBERS = {word: part for part, word in enumerate(PART_WORDS)}


VISIBILITY = "visibility.csv"
"""The name of the file beside a rendered recording."""

VISIBILITY_COLUMNS = ("frame", "id", "visibility")


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
    whole, box = read_table(path, _TABLE)
    frame, person, part, seen = whole[:, :4].T
    return TrueParts(frame, person, part, box[:, :4], seen)


def _row(line: list[str]) -> Row:
    """Frame, person, part and pixels seen, and the box."""
    frame, person, seen = int(line[0]), int(line[1]), int(line[7])
    box = tuple(map(float, line[3:7]))
    if not all(map(math.isfinite, box)):
        raise ValueError("a number is missing")
    if not (0 <= frame <= LARGEST_NUMBER and 0 < person <= LARGEST_NUMBER):
        raise ValueError("frame or id")
    if min(box[2:]) < 0 or not 0 <= seen <= LARGEST_NUMBER:
        raise ValueError("less than nothing, or far too many pixels")
    return (frame, person, _NUMBERS[line[2]], seen), box


_TABLE = TruthTable(
    TRUE_PART_COLUMNS, "true part", "the same part of the same person in the same frame", 3, _row
)


@dataclass(frozen=True, slots=True, eq=False)
class Visibility:
    """What is seen of people; n rows, sorted by frame, then person, none twice.

    Attributes:
        frame, person: (n,). share: (n,) of the person that is seen, 0 to 1.
    """

    frame: Rows
    person: Rows
    share: Floats


def read_visibility(path: Path) -> Visibility:
    """What is seen of a rendered recording's people.

    Raises FormatError where the file is missing, far too large or no such table, or has somebody
    twice in a frame; names the line.
    """
    whole, shares = read_table(path, _VISIBILITY_TABLE)
    return Visibility(whole[:, 0], whole[:, 1], shares[:, 0])


def _visibility_row(line: list[str]) -> Row:
    """Frame and person, and the share that is seen."""
    frame, person, share = int(line[0]), int(line[1]), float(line[2])
    if not (0 <= frame <= LARGEST_NUMBER and 0 < person <= LARGEST_NUMBER):
        raise ValueError("frame or id")
    if not (math.isfinite(share) and 0 <= share <= 1):
        raise ValueError("a share is from 0 to 1")
    return (frame, person), (share,)


_VISIBILITY_TABLE = TruthTable(
    VISIBILITY_COLUMNS, "visibility", "the same person in the same frame", 2, _visibility_row
)
