"""How many have passed until a frame, and who is inside in it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.counting import Counts, Paths, Region, inside
from tracking.tracks import Columns

Integers = NDArray[np.int64]


class Tallies:
    """Counts that can be asked for at any frame; each answer is a search, whatever the length."""

    def __init__(self, counts: Counts) -> None:
        found = counts.passages
        parts = [found.of_line(number) for number in range(len(counts.lines))]
        self._ways: list[tuple[Integers, Integers]] = [
            (np.sort(part.frame[part.forward]), np.sort(part.frame[~part.forward]))
            for part in parts
        ]

    def so_far(self, line: int, frame: int) -> tuple[int, int]:
        """Forward and backward until the frame, which is included."""
        forward, backward = self._ways[line]
        return (
            int(np.searchsorted(forward, frame, side="right")),
            int(np.searchsorted(backward, frame, side="right")),
        )


def people_inside(region: Region, rows: Columns) -> int:
    """How many of a frame's rows lie in a region."""
    paths = Paths.in_picture(rows) if region.in_picture else Paths.on_floor(rows)
    return int(np.count_nonzero(inside(region.polygon, paths.place)))
