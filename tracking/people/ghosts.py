"""Ghosts: where somebody stood when the background was learnt."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.people.silhouettes import Labels

_STRONGER = 0.9
"""Edges of the background along an outline, over those of the picture. People seen at all are
below one half, ghosts above 1."""
_EVERYWHERE = 0.55
"""Share of the outline along which the background's edge must be the stronger one besides, where
the floor is not known, as at eye level, before windows and fences: behind somebody it is so here
and there, of a ghost nearly all along."""
_RING = np.ones((5, 5), np.uint8)


def without_ghosts(
    regions: Labels,
    picture: NDArray[np.uint8],
    background: NDArray[np.uint8],
    *,
    floor_known: bool,
) -> Labels:
    """The regions less those that are no people but holes people left in the background.

    Along a person's outline the picture has an edge and the background has none; along a ghost's
    it is the other way round.

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
        if own.any() and not _is_ghost(own, picture, background, along):
            kept += 1
            number[k] = kept
    return regions if kept == count else number[regions]


def _is_ghost(
    own: NDArray[np.uint8],
    picture: NDArray[np.uint8],
    background: NDArray[np.uint8],
    along: float,
) -> bool:
    left, top, width, height = cv2.boundingRect(own)
    inside = np.s_[max(top - 3, 0) : top + height + 3, max(left - 3, 0) : left + width + 3]
    mask = own[inside]
    ring = cv2.morphologyEx(mask, cv2.MORPH_GRADIENT, _RING) > 0
    now, usual = (_edges(image[inside])[ring] for image in (picture, background))
    if float(usual.mean()) <= _STRONGER * float(now.mean()):
        return False
    return bool((usual > now).mean() >= along)


def _edges(picture: NDArray[np.uint8]) -> NDArray[np.float32]:
    """(height, width) how steep the brightness is."""
    light = picture[..., 1].astype(np.float32)
    down, across = np.zeros_like(light), np.zeros_like(light)
    down[1:-1] = np.abs(light[2:] - light[:-2])
    across[:, 1:-1] = np.abs(light[:, 2:] - light[:, :-2])
    return down + across
