"""How much brighter a picture is than its background, people or not."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_SAMPLES_PER_SIDE = 48
_DARKEST, _BRIGHTEST = 24, 246
_FEWEST_SAMPLES = 50


def brightness_ratio(picture: NDArray[np.uint8], background: NDArray[np.uint8]) -> float:
    """The median ratio of picture to background over a grid of pixels.

    Pixels too dark to give a ratio and overexposed ones are left out; 1.0 where too few are left.
    The median holds as long as people cover less than half of what is left.

    Args:
        picture, background: (height, width, 3) uint8.
    """
    rows = max(1, picture.shape[0] // _SAMPLES_PER_SIDE)
    columns = max(1, picture.shape[1] // _SAMPLES_PER_SIDE)
    now = picture[rows // 2 :: rows, columns // 2 :: columns, 1].ravel()
    usual = background[rows // 2 :: rows, columns // 2 :: columns, 1].ravel()
    usable = (now < _BRIGHTEST) & (usual < _BRIGHTEST) & (usual > _DARKEST) & (now > _DARKEST)
    if np.count_nonzero(usable) < _FEWEST_SAMPLES:
        return 1.0
    return _median(now[usable] / usual[usable].astype(np.float32))


def _median(values: NDArray[np.floating]) -> float:
    """As `numpy.median`, without its checks, which cost several times as much as the rest."""
    middle = len(values) // 2
    ordered = np.partition(values, (middle - 1, middle))
    if len(values) % 2:
        return float(ordered[middle])
    return float((ordered[middle - 1] + ordered[middle]) / 2)
