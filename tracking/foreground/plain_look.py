"""Another look of a plain scene, without what is left in it of who stood there."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground.difference import largest_difference
from tracking.foreground.first_look import OtherLook

_AROUND_PX, _LEAST_SHARE = 15, 0.1
"""Side of the square round a pixel that says what is there, and how much of it must be known."""
_GAP_PX, _EDGE_PX = 9, 2
"""Width of spots that are closed, and of the edge round them that shows both looks mixed."""
_PLAIN = 4.0
"""Deviation, grey levels, up to which a scene is plain there."""
_SPOT = 30
"""Grey levels by which a spot may differ: what differs by more is another thing."""

Floats = NDArray[np.float32]


def without_spots(look: OtherLook) -> OtherLook:
    """A look in which spots and the edge of the commonest one are drawn over where it is plain.

    Of somebody before a wall some spots are nearly as bright as the wall. No other look is known
    of them, so that they stay in the picture, and are all that can be ranged in it.
    """
    own = (look.where != 0).astype(np.float32)
    known = _mean(own)
    light, deviation = _light_around(look.picture, own, known)
    spots = _near(look.where) & (own == 0) & (known > _LEAST_SHARE) & (deviation < _PLAIN)
    spots &= largest_difference(look.picture, light) < _SPOT
    picture, where = look.picture.copy(), look.where.copy()
    picture[spots], where[spots] = light[spots], 255
    return OtherLook(picture, where)


def _light_around(
    picture: NDArray[np.uint8], own: Floats, known: Floats
) -> tuple[NDArray[np.uint8], Floats]:
    """What the other look is like around each pixel, and (height, width) how much it varies."""
    values = picture.astype(np.float32)
    share = np.maximum(known, np.float32(1e-6))[..., None]
    mean = _mean(values * own[..., None]) / share
    squares = _mean(values * values * own[..., None]) / share
    deviation = np.sqrt(np.maximum(squares - mean * mean, 0)).max(axis=2)
    return np.rint(mean).astype(np.uint8), deviation


def _mean(values: Floats) -> Floats:
    return np.asarray(cv2.blur(values, (_AROUND_PX, _AROUND_PX)), np.float32)


def _near(where: NDArray[np.uint8]) -> NDArray[np.bool_]:
    """Small gaps of a mask, itself and its edge."""
    gap, edge = (np.ones((side, side), np.uint8) for side in (_GAP_PX, 2 * _EDGE_PX + 1))
    closed = cv2.morphologyEx(where, cv2.MORPH_CLOSE, gap)
    return np.asarray(cv2.dilate(closed, edge), np.bool_)
