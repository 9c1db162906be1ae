"""Who is concerned, and where they are in both pictures and on the floor while that matters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from app.core.projection.right_image import boxes_in_right_image
from app.core.projection.trails import floor_points
from tracking.arrays import Floats
from tracking.recording import Recording
from tracking.tracks import Columns
from tracking.tracks.columns import boxes_of

Part = tuple[float, float, float, float]
"""Left, top (on the floor: bottom), width and height of a part of a view, in its own units."""
CONCERNED = ("track", "left", "top", "width", "height", "x", "y")
"""Columns that tell where people are."""
_CLOSEST = 4.0
"""A picture is enlarged at most so many times: beyond it nothing more is to be seen."""
_AROUND_BODIES, _AROUND_M, _LEAST_M = 0.75, 1.5, 4.0


@dataclass(frozen=True, slots=True, eq=False)
class Concern:
    """People and when they are looked at.

    Attributes:
        rows: of them, `CONCERNED`. start, end: half-open range of frames.
    """

    rows: Columns
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class ConcernParts:
    """The parts of the views that show them; None where that is not known."""

    left: Part | None = None
    right: Part | None = None
    floor: Part | None = None


def parts_concerned(recording: Recording, concern: Concern) -> ConcernParts:
    """Where its people are, with room around them."""
    rows = concern.rows
    boxes = boxes_of(rows).astype(np.float64)
    right: Floats = np.zeros((0, 4))
    if recording.rectification is not None and recording.ground is not None and len(boxes):
        right = boxes_in_right_image(recording.rectification, boxes, floor_points(rows))
    size = recording.size
    return ConcernParts(_around(boxes, size), _around(right, size), _on_floor(rows))


def corners_around(boxes: Floats, margin: float) -> tuple[Floats, Floats] | None:
    """(2,) left top and (2,) right bottom around boxes; None where no box is known.

    Args:
        boxes: (n, 4) left, top, width, height; NaN where one is not known.
        margin: on each side, in heights of the tallest box.
    """
    known = boxes[np.isfinite(boxes).all(axis=1)]
    if not len(known):
        return None
    around = margin * known[:, 3].max()
    return known[:, :2].min(axis=0) - around, (known[:, :2] + known[:, 2:]).max(axis=0) + around


def _around(boxes: Floats, size: tuple[int, int]) -> Part | None:
    """What holds boxes, and most of a body more on each side, of the picture and no more than it.

    Whoever is so large or so close to its edge that more would be shown is not shown smaller.
    """
    corners = corners_around(boxes, _AROUND_BODIES)
    if corners is None:
        return None
    whole = np.array(size, np.float64)
    low, high = (np.clip(corner, 0.0, whole) for corner in corners)
    return _at_least(low, high, whole / _CLOSEST)


def _on_floor(rows: Columns) -> Part | None:
    places = floor_points(rows)
    places = places[np.isfinite(places).all(axis=1)]
    if not len(places):
        return None
    low, high = places.min(axis=0) - _AROUND_M, places.max(axis=0) + _AROUND_M
    return _at_least(low, high, np.full(2, _LEAST_M))


def _at_least(low: Floats, high: Floats, least: Floats) -> Part:
    """A part of the view, grown about its middle to a size."""
    middle, size = (low + high) / 2, np.maximum(high - low, least)
    left, top = (middle - size / 2).tolist()
    width, height = size.tolist()
    return left, top, width, height
