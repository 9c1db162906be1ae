"""The region of interest: where in the left picture people are looked for."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from tracking.arrays import Mask
from tracking.errors import RecordingError
from tracking.translation import Message, msg

Outline = tuple[tuple[float, float], ...]
"""Corners (x, y) in px of the left picture as recorded."""

_MOST_CORNERS = 2000
"""Of all outlines of a recording."""
_FARTHEST_PX = 100_000.0
"""Corners may lie outside of the picture, but not at places that cannot be drawn."""


@dataclass(frozen=True, slots=True)
class RegionOfInterest:
    """What of the left picture counts; no people are looked for outside of it.

    Attributes:
        look: outlines of what is looked at; none: the whole picture.
        mask: outlines that are never looked at, within `look` too.
    """

    look: tuple[Outline, ...] = ()
    mask: tuple[Outline, ...] = ()

    def __bool__(self) -> bool:
        """Whether anything is left out."""
        return bool(self.look or self.mask)

    def pixels(self, size: tuple[int, int]) -> Mask | None:
        """(height, width) uint8, 255 where people are looked for; None: everywhere.

        Args:
            size: width and height of the picture, px.

        Raises:
            RecordingError: nothing of the picture is left.
        """
        if not self:
            return None
        looked_at = np.full(size[::-1], 0 if self.look else 255, np.uint8)
        for outlines, value in ((self.look, 255), (self.mask, 0)):
            for outline in outlines:
                cv2.fillPoly(looked_at, [np.rint(outline).astype(np.int32)], (value,))
        if not looked_at.any():
            raise RecordingError(
                "the region leaves nothing of the picture of {width} x {height} pixels; draw it "
                "within the picture",
                width=size[0],
                height=size[1],
            )
        return looked_at


EVERYWHERE = RegionOfInterest()


def outlines_of(value: Any) -> tuple[Outline, ...] | Message:
    """The outlines of a polygon, or of a list of polygons; what is wrong with them, in words."""
    if not isinstance(value, list):
        return msg("must be a polygon such as [[0, 200], [640, 200], [640, 480]]")
    polygons = [value] if value and all(map(_is_corner, value)) else value
    if not all(isinstance(each, list) and all(map(_is_corner, each)) for each in polygons):
        return msg(
            "must be a polygon such as [[0, 200], [640, 200], [640, 480]], or a list of them, "
            "with corners in pixels"
        )
    return checked_outlines(tuple((_number(x), _number(y)) for x, y in each) for each in polygons)


def checked_outlines(outlines: Iterable[Outline]) -> tuple[Outline, ...] | Message:
    """Outlines that can be drawn; what is wrong with them, in words."""
    found = tuple(outlines)
    if not all(_is_near(side) for outline in found for corner in outline for side in corner):
        return msg("has a corner farther off than {most:g} pixels", most=_FARTHEST_PX)
    if any(len(outline) < 3 for outline in found):
        return msg("has a polygon of fewer than three corners")
    if sum(map(len, found)) > _MOST_CORNERS:
        return msg("has more than {most} corners", most=_MOST_CORNERS)
    return found


def _is_corner(value: object) -> bool:
    return (
        isinstance(value, list)
        and len(value) == 2
        and all(type(side) in (int, float) for side in value)
    )


def _number(side: int | float) -> float:
    """As a float; whole numbers too large for one are infinitely far."""
    return float(side) if abs(side) <= _FARTHEST_PX else math.inf


def _is_near(side: float) -> bool:
    return math.isfinite(side) and abs(side) <= _FARTHEST_PX
