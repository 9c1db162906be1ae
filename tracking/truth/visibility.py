"""How much the camera sees of rendered people: the table beside a rendered recording."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from tracking.arrays import Floats
from tracking.tracks import LARGEST_NUMBER
from tracking.truth.table import Row, Rows, TruthTable, read_table

VISIBILITY = "visibility.csv"
"""The name of the file beside a rendered recording."""

VISIBILITY_COLUMNS = ("frame", "id", "visibility")


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
    whole, shares = read_table(path, _TABLE)
    return Visibility(whole[:, 0], whole[:, 1], shares[:, 0])


def _row(line: list[str]) -> Row:
    """Frame and person, and the share that is seen."""
    frame, person, share = int(line[0]), int(line[1]), float(line[2])
    if not (0 <= frame <= LARGEST_NUMBER and 0 < person <= LARGEST_NUMBER):
        raise ValueError("frame or id")
    if not (math.isfinite(share) and 0 <= share <= 1):
        raise ValueError("a share is from 0 to 1")
    return (frame, person), (share,)


_TABLE = TruthTable(VISIBILITY_COLUMNS, "visibility", "the same person in the same frame", 2, _row)
