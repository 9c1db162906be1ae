"""Pictures of a scene whose light changes between them, brought into one light."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground.difference import largest_difference
from tracking.foreground.gain import brightness_ratio
from tracking.foreground.local_light import MUCH_CHANGED, change_of_light

Picture = NDArray[np.uint8]

_DIFFERS = 16
"""Grey levels by which a pixel is another."""
_SAME_EXPOSURE = 0.03
"""Ratios of brightness so close to 1 are noise and people."""


def in_one_light(pictures: Sequence[Picture]) -> list[Picture]:
    """The pictures in the light of that one which is neither among the brighter nor the darker.

    Lamps that go on or off, the sun and the camera's own exposure change how the empty scene looks;
    without this, what is commonest would be one light here and another there. Pictures in the
    same light stay as they are.

    Args:
        pictures: at least one (height, width, 3).
    """
    order = np.argsort([float(picture[::8, ::8, 1].mean()) for picture in pictures], kind="stable")
    usual = pictures[int(order[len(order) // 2])]
    return [_in_light_of(usual, picture) for picture in pictures]


def _in_light_of(usual: Picture, picture: Picture) -> Picture:
    """The picture as it would be in the light of another."""
    brighter = brightness_ratio(picture, usual)
    if abs(brighter - 1) > _SAME_EXPOSURE:
        picture = np.asarray(cv2.convertScaleAbs(picture, alpha=1 / brighter), np.uint8)
    differs = largest_difference(picture, usual) > _DIFFERS
    if differs.mean() < MUCH_CHANGED:
        return picture
    change = change_of_light(usual, picture, differs.view(np.uint8) * np.uint8(255))
    if change is None:
        return picture
    return np.asarray(cv2.multiply(picture, change, dtype=cv2.CV_8U), np.uint8)
