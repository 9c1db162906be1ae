"""How much the light changed, pixel by pixel, where blocks tell that it did."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground.difference import largest_difference
from tracking.foreground.light_blocks import means, quotient, white

Picture = NDArray[np.uint8]
Mask = NDArray[np.uint8]
Flags = NDArray[np.bool_]
Floats = NDArray[np.float32]

_HOLES = np.ones((9, 9), np.uint8)
"""Holes so wide in what differs are as lit as what is round them: they only differ less."""
_EVEN_PX = (31, 9)
"""Light is even over so many pixels; the nearer it is measured the better, if it can be."""
_FEWEST_LIT = 4.0
"""Grey levels that the mean of so many pixels reaches where enough of them are measured."""
_EXPLAINED = 16
"""Grey levels that another light may leave unexplained of a pixel."""
NEAR = (7, 7)
"""Blocks that cannot be told have the light of those so near."""


def ratio_of_light(
    picture: Picture, background: Picture, mask: Mask, lit: Flags, guessed: Flags
) -> Floats:
    """(height, width, 3) the change of light: measured on lit blocks, taken over on guessed ones.

    What differs near lit blocks, too little to fill its own or beside people, has their light
    if that explains how it looks.
    """
    size = mask.shape[1], mask.shape[0]
    changed = np.asarray(cv2.morphologyEx(mask, cv2.MORPH_CLOSE, _HOLES), np.uint8)
    lit_px = changed & _enlarge(white(lit), size)
    ratio = _spread(picture, background, lit_px, (lit.shape[1], lit.shape[0]))
    there = np.asarray(cv2.multiply(background, ratio, dtype=cv2.CV_8U), np.uint8)
    explained = white(largest_difference(picture, there) < _EXPLAINED)
    near = cv2.dilate(white(lit), np.ones(NEAR, np.uint8))
    taken = changed & explained & _enlarge(np.asarray(near, np.uint8), size)
    taken |= lit_px | _enlarge(white(guessed), size)
    ratio[taken == 0] = 1.0
    return ratio


def _spread(picture: Picture, background: Picture, lit_px: Mask, size: tuple[int, int]) -> Floats:
    """(height, width, 3) the change of light everywhere, as it is on the lit pixels near by.

    Args:
        lit_px: (height, width) 255 there. size: blocks across and down.
    """
    lights = [cv2.copyTo(image, lit_px).astype(np.float32) for image in (picture, background)]
    now, usual = (cv2.boxFilter(means(image, size), -1, NEAR, normalize=False) for image in lights)
    ratio = np.asarray(cv2.resize(quotient(now, usual), lit_px.shape[::-1]), np.float32)
    for side in _EVEN_PX:
        now, usual = (cv2.boxFilter(image, -1, (side, side), normalize=False) for image in lights)
        ratio = np.where(usual > _FEWEST_LIT * side * side, quotient(now, usual), ratio)
    return ratio


def _enlarge(blocks: Mask, size: tuple[int, int]) -> Mask:
    """Blocks in pixels."""
    return np.asarray(cv2.resize(blocks, size, interpolation=cv2.INTER_NEAREST), np.uint8)
