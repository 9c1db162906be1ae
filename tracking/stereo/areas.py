"""The parts of a picture in which there is something to match."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Mask = NDArray[np.uint8]
Box = tuple[slice, slice]

_TILE = (4, 8)
"""Rows and columns of pixels that are taken in or left out together; 8 columns are one number."""
_EACH_PX = 1500
"""What a part costs beside its pixels, in pixels."""


def areas(mask: Mask, margin: tuple[int, int]) -> list[Box]:
    """Boxes, rows and columns, that hold all of a mask and little else.

    Args:
        mask: (height, width) uint8, non-zero where it counts.
        margin: rows and columns that a box costs beside its own.

    Returns:
        Boxes of tiles, cut at the picture's sides; the one box round all of it where several would
        cost more. None without anything.
    """
    count, _, stats, _ = cv2.connectedComponentsWithStats(_tiles(mask), connectivity=8)
    if count <= 1:
        return []
    (down, across), (height, width) = _TILE, mask.shape
    # A handful of boxes: plain numbers are quicker than arrays.
    boxes = [
        (
            slice(top * down, min((top + rows) * down, height)),
            slice(left * across, min((left + columns) * across, width)),
        )
        for left, top, columns, rows, _ in np.asarray(stats)[1:].tolist()
    ]
    whole = _round(boxes)
    return boxes if _cost(boxes, margin) <= _cost([whole], margin) else [whole]


def _tiles(mask: Mask) -> Mask:
    """(rows, columns) of tiles, 1 where there is anything in one."""
    below, beside = (-length % tile for length, tile in zip(mask.shape, _TILE, strict=True))
    if below or beside:
        mask = np.asarray(
            cv2.copyMakeBorder(mask, 0, below, 0, beside, cv2.BORDER_CONSTANT, value=(0.0,)),
            np.uint8,
        )
    rows = mask[0 :: _TILE[0]].copy()
    for row in range(1, _TILE[0]):
        rows |= mask[row :: _TILE[0]]
    return np.asarray(rows.view(np.uint64) != 0).view(np.uint8)


def _round(boxes: list[Box]) -> Box:
    """The box round all of them."""
    rows, columns = zip(*boxes, strict=True)
    return (
        slice(min(side.start for side in rows), max(side.stop for side in rows)),
        slice(min(side.start for side in columns), max(side.stop for side in columns)),
    )


def _cost(boxes: list[Box], margin: tuple[int, int]) -> int:
    """Pixels of boxes with their margins, and what each costs beside."""
    return sum(
        (rows.stop - rows.start + margin[0]) * (columns.stop - columns.start + margin[1]) + _EACH_PX
        for rows, columns in boxes
    )
