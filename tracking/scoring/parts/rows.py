"""Body parts as rows, one a person and frame: as they really are, and as a tracker said."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.scoring.parts.rectangles import Bools, bounding
from tracking.tracks import PARTS, pairs_of, row_keys

Whole = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class PartTruth:
    """Where everybody's parts are; n rows, sorted by frame, then person.

    Attributes:
        frame, person: (n,).
        parts: (n, 3, 4) left, top, right, bottom in px of the left picture as recorded, hidden or
            not; NaN where unknown.
        visibility: (n,) share of the person that is seen, 0 to 1.
        size_px: width and height of the pictures.
    """

    frame: Whole
    person: Whole
    parts: Floats
    visibility: Floats
    size_px: tuple[int, int]

    def within(self, start: int, stop: int) -> PartTruth:
        """The rows of the frames start to stop - 1."""
        rows = _rows_within(self.frame, start, stop)
        columns = (self.frame[rows], self.person[rows], self.parts[rows], self.visibility[rows])
        return PartTruth(*columns, self.size_px)

    @property
    def people(self) -> Floats:
        """(n, 4) left, top, right, bottom of whole people."""
        return bounding(self.parts)

    @property
    def whole(self) -> Bools:
        """(n,) whether all of somebody lies in the picture."""
        box = self.people
        width, height = self.size_px
        inside = (box[:, 0] >= 0) & (box[:, 1] >= 0)
        return np.asarray(inside & (box[:, 2] <= width - 1) & (box[:, 3] <= height - 1), np.bool_)


@dataclass(frozen=True, slots=True, eq=False)
class TrackedParts:
    """What a tracker said; n rows, sorted by frame, then track; NaN where it said nothing.

    Attributes:
        frame, track: (n,).
        parts: (n, 3, 4) left, top, right, bottom in px; all NaN where it knows no parts.
        person: (n, 4) the whole person.
    """

    frame: Whole
    track: Whole
    parts: Floats
    person: Floats

    def within(self, start: int, stop: int) -> TrackedParts:
        """The rows of the frames start to stop - 1."""
        rows = _rows_within(self.frame, start, stop)
        return TrackedParts(self.frame[rows], self.track[rows], self.parts[rows], self.person[rows])


def tracked_parts(columns: Mapping[str, NDArray[Any]]) -> TrackedParts:
    """The rectangles of `PART_COLUMNS`; a person is the box round all three parts."""
    middle, size = (_two(columns, *names) for names in (("cx", "cy"), ("width", "height")))
    corners = np.concatenate((middle - size / 2, middle + size / 2), axis=1)
    frame, track, parts = by_person(columns["frame"], columns["track"], columns["part"], corners)
    return TrackedParts(frame, track, parts, bounding(parts))


def tracked_people(columns: Mapping[str, NDArray[Any]]) -> TrackedParts:
    """The boxes of tracks, without parts."""
    low, size = (_two(columns, *names) for names in (("left", "top"), ("width", "height")))
    frame, track = (columns[name].astype(np.int64) for name in ("frame", "track"))
    order = np.lexsort((track, frame))
    nothing = np.full((len(frame), PARTS, 4), np.nan)
    person = np.concatenate((low, low + size), axis=1)
    return TrackedParts(frame[order], track[order], nothing, person[order])


def by_person(
    frame: NDArray[Any], track: NDArray[Any], part: NDArray[Any], corners: Floats
) -> tuple[Whole, Whole, Floats]:
    """Rows of single parts as frame (n,), track (n,) and corners (n, 3, 4) of whole people."""
    known, row = np.unique(row_keys(frame, track), return_inverse=True)
    parts = np.full((len(known), PARTS, 4), np.nan)
    parts[row.reshape(-1), part] = corners
    return *pairs_of(known), parts


def _rows_within(frame: Whole, start: int, stop: int) -> slice:
    """Where the rows of some frames stand; frame is sorted."""
    first, end = np.searchsorted(frame, (start, stop)).tolist()
    return slice(first, end)


def _two(columns: Mapping[str, NDArray[Any]], one: str, other: str) -> Floats:
    return np.column_stack((columns[one], columns[other])).astype(np.float64)
