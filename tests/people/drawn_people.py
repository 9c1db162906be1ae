"""Plain pictures with people drawn as a head, a trunk and legs."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
SIZE = (240, 320)


def floor(size: tuple[int, int] = SIZE, seed: int = 0) -> Picture:
    """An empty floor with some texture."""
    rng = np.random.default_rng(seed)
    grain = rng.normal(0, 6, size).astype(np.float32)
    return (
        np.clip(cv2.GaussianBlur(grain, (0, 0), 1.5)[..., None] * 3 + 150, 0, 255)
        .astype(np.uint8)
        .repeat(3, axis=2)
    )


def with_person(picture: Picture, u: int, top: int, height: int) -> Picture:
    """The picture with somebody upright whose head's top is at (u, top)."""
    drawn = picture.copy()
    head = round(0.07 * height)
    cv2.circle(drawn, (u, top + head), head, (90, 120, 190), -1)
    half = round(0.12 * height)
    neck, hip = top + round(0.14 * height), top + round(0.48 * height)
    drawn[neck:hip, u - half : u + half] = (30, 30, 160)
    drawn[hip : top + height, u - half : u - half // 4] = (120, 40, 30)
    drawn[hip : top + height, u + half // 4 : u + half] = (120, 40, 30)
    return drawn


def with_shadow(picture: Picture, u: int, bottom: int, length: int) -> Picture:
    """The picture with a shadow on the floor that runs to the right of (u, bottom)."""
    drawn = picture.copy()
    cut = drawn[bottom - 8 : bottom + 4, u : u + length]
    cut[:] = (cut * 0.6).astype(np.uint8)
    return drawn
