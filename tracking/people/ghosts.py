"""Regions that are nobody: holes people left in the background, and what has no outline."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground.difference import largest_difference
from tracking.people.silhouettes import Labels

_STRONGER = 0.9
"""Edges of the background along an outline, over those of the picture. People seen at all are
below one half, ghosts above 1."""
_EVERYWHERE = 0.55
"""Share of the outline along which the background's edge must be the stronger one besides, where
the floor is not known, as at eye level, before windows and fences: behind somebody it is so here
and there, of a ghost nearly all along."""
_FADES = 0.1
"""How steep the difference from the background is at least along an outline, beside the difference
itself: bodies end within two or three pixels (0.2 to 0.7), most clouds do not (0.01 to 0.1)."""
_RING = np.ones((5, 5), np.uint8)


def without_ghosts(
    regions: Labels,
    picture: NDArray[np.uint8],
    background: NDArray[np.uint8],
    *,
    floor_known: bool,
) -> Labels:
    """The regions less those that are no people but holes people left in the background, or clouds.

    Along a person's outline the picture has an edge and the background has none; along a ghost's
    it is the other way round. Along most of the outline of clouds neither has one: they fade. Where
    the floor is known clouds stand on none, and people dressed like what is behind may fade.

    Args:
        regions: (height, width) k + 1 for the pixels of region k.
        picture, background: (height, width, 3).
        floor_known: whether the camera looks over a known floor.

    Returns:
        The regions that stay, numbered without gaps.
    """
    count = int(regions.max(initial=0))
    number = np.zeros(count + 1, np.uint8)
    along = 0.0 if floor_known else _EVERYWHERE
    kept = 0
    for k in range(1, count + 1):
        own = (regions == k).view(np.uint8)
        if not own.any() or (not floor_known and _fades(own, regions, picture, background)):
            continue
        if not _is_ghost(own, picture, background, along):
            kept += 1
            number[k] = kept
    return regions if kept == count else number[regions]


def _is_ghost(
    own: NDArray[np.uint8],
    picture: NDArray[np.uint8],
    background: NDArray[np.uint8],
    along: float,
) -> bool:
    inside = _around(own)
    ring = cv2.morphologyEx(own[inside], cv2.MORPH_GRADIENT, _RING) > 0
    now, usual = (_edges(image[inside][..., 1])[ring] for image in (picture, background))
    if float(usual.mean()) <= _STRONGER * float(now.mean()):
        return False
    return bool((usual > now).mean() >= along)


def _fades(
    own: NDArray[np.uint8],
    regions: Labels,
    picture: NDArray[np.uint8],
    background: NDArray[np.uint8],
) -> bool:
    """Whether a region has no outline along most of where it borders on no other one."""
    inside = _around(own)
    mask, difference = own[inside], largest_difference(picture[inside], background[inside])
    others = ((regions[inside] > 0) & (mask == 0)).view(np.uint8)
    ring = cv2.morphologyEx(mask, cv2.MORPH_GRADIENT, _RING) > cv2.dilate(others, _RING)
    if not ring.any():
        return False
    within = float(np.median(difference[mask > 0]))
    return float(np.median(_edges(difference)[ring])) < _FADES * within


def _around(own: NDArray[np.uint8]) -> tuple[slice, slice]:
    """The rows and columns of a region and 3 px about it."""
    left, top, width, height = cv2.boundingRect(own)
    return slice(max(top - 3, 0), top + height + 3), slice(max(left - 3, 0), left + width + 3)


def _edges(image: NDArray[np.uint8]) -> NDArray[np.float32]:
    """(height, width) how steep one channel is."""
    light = image.astype(np.float32)
    down, across = np.zeros_like(light), np.zeros_like(light)
    down[1:-1] = np.abs(light[2:] - light[:-2])
    across[:, 1:-1] = np.abs(light[:, 2:] - light[:, :-2])
    return down + across
