"""Where nothing moves in a picture, told by another one a moment later."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Picture
from tracking.foreground.difference import largest_difference
from tracking.foreground.gain import channel_ratios, scaled

_MOVED = 12
"""Grey levels by which a pixel is another a moment later."""
_NEAR = ((1 / 12, 1 / 6), (1 / 6, 1 / 3))
"""Shares of the picture's width, across and down, within which motion counts, for people far away
and nearby: plain clothes move at their edges only, and who lingers stands on one leg and then on
the other."""
_MUCH = 0.05
"""Share of what is near that moves and halves the stillness."""


def stillness(picture: Picture, later: Picture) -> NDArray[np.float32]:
    """(height, width) 1 where nothing moves near by, down to 0 where much does.

    Backgrounds are looked for where nothing moves ([Laugraud2015], "LaBGen"): who lingers at a
    place hides it in most pictures, but hardly ever as still as a wall.

    Args:
        picture, later: (height, width, 3) uint8, half a second apart or so.
    """
    in_its_light = scaled(later, channel_ratios(picture, later))
    moved = (largest_difference(picture, in_its_light) > _MOVED).astype(np.float32)
    near = np.zeros_like(moved)
    for across, down in _NEAR:
        size = round(across * picture.shape[1]) | 1, round(down * picture.shape[1]) | 1
        cv2.max(near, cv2.blur(moved, size, borderType=cv2.BORDER_REFLECT), near)
    return np.asarray(1 / (1 + (near / _MUCH) ** 2), np.float32)
