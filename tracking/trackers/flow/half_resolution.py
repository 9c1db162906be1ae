"""Pictures at half resolution, of any size: every part of flow means the same pixels by it."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.recording.frame import Image

Size = tuple[int, int]


def half_size(size: Size) -> Size:
    """Width and height at half resolution; a last odd column or row is left out."""
    return max(1, size[0] // 2), max(1, size[1] // 2)


def halve(picture: Image) -> Image:
    """A picture, grey or BGR, of which pixel (u, v) is the mean of four round 2u + 0.5, 2v + 0.5.

    Of odd sizes the last column or row is cut off, so that this holds all over the picture.
    """
    columns, rows = half_size((picture.shape[1], picture.shape[0]))
    even = picture[: 2 * rows, : 2 * columns]
    return np.asarray(cv2.resize(even, (columns, rows), interpolation=cv2.INTER_AREA), np.uint8)


def halve_mask(mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A mask (height, width) of which pixel (u, v) is that of 2u, 2v."""
    columns, rows = half_size((mask.shape[1], mask.shape[0]))
    return mask[: 2 * rows : 2, : 2 * columns : 2]


def double(half: Image, size: Size) -> Image:
    """What is known at half resolution, of a picture of that width and height: each pixel four.

    What `half_size` left out is as what lies beside it.
    """
    rows, columns = half.shape[:2]
    even = cv2.resize(half, (2 * columns, 2 * rows), interpolation=cv2.INTER_NEAREST)
    spare = max(0, size[1] - 2 * rows), max(0, size[0] - 2 * columns)
    whole = cv2.copyMakeBorder(even, 0, spare[0], 0, spare[1], cv2.BORDER_REPLICATE)
    return np.asarray(whole[: size[1], : size[0]], np.uint8)
