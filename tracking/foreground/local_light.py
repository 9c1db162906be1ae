"""Light that changes on a part of the scene only, told from people by what it leaves as it was."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Mask = NDArray[np.uint8]
Floats = NDArray[np.float32]

_BLOCK_PX = 16
"""Side of the squares compared: smaller than a person, with detail enough to be told again."""
_MOSTLY = 0.5
"""A block is looked at if this share of it differs from the background."""
_ALIKE = 0.6
"""Correlation of a block's detail with the background's from which on it is the same thing."""
_DETAIL = 1.5
"""Deviation of brightness, grey levels, below which a block has no detail to compare."""
_SHARE = 0.3
"""Of the blocks that differ and have detail, so many must be the same thing in other light."""
_NEAR = (7, 7)
"""Blocks that cannot be told have the light of those so near."""
_RATIOS = (0.2, 5.0)
"""Changes of light that are believed."""


def change_of_light(picture: Picture, background: Picture, mask: Mask) -> Floats | None:
    """How much brighter each pixel's place became, 1 where nothing is known; None: no change.

    Where only the light changed, a block of the picture shows the same detail as the background,
    brighter or darker as a whole. People cover the detail with their own; behind them the light
    is that of the places near by.

    Args:
        picture, background: (height, width, 3). mask: (height, width), 255 where they differ.

    Returns:
        (height, width) float32.
    """
    height, width = mask.shape
    size = (-(-width // _BLOCK_PX), -(-height // _BLOCK_PX))
    differs = _means(mask, size) > _MOSTLY * 255
    now, usual = picture[..., 1].astype(np.float32), background[..., 1].astype(np.float32)
    light, before = _means(now, size), _means(usual, size)
    spread, spread_before = (
        np.sqrt(np.maximum(_means(eye * eye, size) - mean * mean, 0))
        for eye, mean in ((now, light), (usual, before))
    )
    alike = (_means(now * usual, size) - light * before) > _ALIKE * spread * spread_before
    ratio = np.clip((light + 1) / (before + 1), *_RATIOS)
    detail = differs & (spread > _DETAIL) & (spread_before > _DETAIL)
    lit = detail & alike
    if not lit.any() or lit.sum() < _SHARE * detail.sum():
        return None
    near = _mean_near(ratio, lit)
    found = np.where(lit, ratio, np.where(differs, near, np.float32(1))).astype(np.float32)
    return np.asarray(cv2.resize(found, (width, height), interpolation=cv2.INTER_NEAREST))


def _means(values: NDArray[np.uint8] | Floats, size: tuple[int, int]) -> Floats:
    """The mean of each block."""
    small = cv2.resize(values.astype(np.float32), size, interpolation=cv2.INTER_AREA)
    return np.asarray(small, np.float32)


def _mean_near(ratio: Floats, lit: NDArray[np.bool_]) -> Floats:
    """The mean change of the lit blocks near each block, 1 where there are none."""
    known = lit.astype(np.float32)
    total = np.asarray(cv2.boxFilter(ratio * known, -1, _NEAR, normalize=False), np.float32)
    count = np.asarray(cv2.boxFilter(known, -1, _NEAR, normalize=False), np.float32)
    return np.where(count > 0.5, total / np.maximum(count, 1), np.float32(1))
