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
    found = np.asarray(stats, np.intp)[1:]
    low = found[:, [cv2.CC_STAT_TOP, cv2.CC_STAT_LEFT]] * _TILE
    size = found[:, [cv2.CC_STAT_HEIGHT, cv2.CC_STAT_WIDTH]] * _TILE
    high = np.minimum(low + size, mask.shape)
    whole_low, whole_high = low.min(axis=0, keepdims=True), high.max(axis=0, keepdims=True)
    if _cost(low, high, margin) > _cost(whole_low, whole_high, margin):
        low, high = whole_low, whole_high
    return [
        (slice(top, bottom), slice(left, right))
        for (top, left), (bottom, right) in zip(low.tolist(), high.tolist(), strict=True)
    ]


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


def _cost(low: NDArray[np.intp], high: NDArray[np.intp], margin: tuple[int, int]) -> int:
    """Pixels of boxes (n, 2) with their margins, and what each costs beside."""
    sides = high - low + margin
    return int((sides[:, 0] * sides[:, 1]).sum()) + _EACH_PX * len(sides)
