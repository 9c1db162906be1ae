"""The scale at which people are looked for: wide pictures are shrunk by a whole number."""

from __future__ import annotations

import cv2
import numpy as np

from tracking.recording.frame import Image

_WIDEST_PX = 800
"""Wider pictures are shrunk before anything is done with them."""


def shrink_of(width_px: int) -> int:
    """How many recorded pixels a working pixel is wide, in pictures so wide."""
    return -(-width_px // _WIDEST_PX)


def shrunk(image: Image, shrink: int) -> Image:
    """The camera at the working scale; itself where that is its own."""
    if shrink == 1:
        return image
    size = (image.shape[1] // shrink, image.shape[0] // shrink)
    return np.asarray(cv2.resize(image, size, interpolation=cv2.INTER_AREA), np.uint8)
