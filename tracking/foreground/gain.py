"""How much brighter a picture is than its background, channel by channel, people or not."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

_SAMPLES_PER_SIDE = 48
_DARKEST, _BRIGHTEST = 24, 246
_FEWEST_SAMPLES = 50
_SAME_RATIO = 0.01
_SUITS = 4
"""Grey levels within which a ratio explains a sample."""
_CLEARLY = 0.15
"""Share of the samples that one ratio must explain more than another."""
_CHANGED, _PART = 0.15, 0.3
"""A change of exposure so large leaves no such share of the samples as it is."""


def brightness_ratio(picture: NDArray[np.uint8], background: NDArray[np.uint8]) -> float:
    """The median ratio of picture to background over a grid of pixels, in green.

    Pixels too dark to give a ratio and overexposed ones are left out; 1.0 where too few are left.
    The median holds as long as people cover less than half of what is left. Where a large part
    keeps its light, light changed on the other part only, and the ratio is 1.0.

    Args:
        picture, background: (height, width, 3) uint8.
    """
    now, usual = _sampled(picture, 1), _sampled(background, 1)
    ratio = _ratio(now, usual)
    if abs(ratio - 1) > _CHANGED and _suited(1.0, now, usual) > _PART * len(now):
        return 1.0
    return ratio


def channel_ratios(
    picture: NDArray[np.uint8], background: NDArray[np.uint8]
) -> NDArray[np.float32]:
    """(3,) the median ratio of each channel: exposure and white balance change them at once.

    Blue and red have the ratio of green, unless one of their own suits clearly more of the picture:
    a crowd in red clothes is no white balance.

    Args:
        picture, background: see `brightness_ratio`.
    """
    green = brightness_ratio(picture, background)
    ratios = [
        _own_or(green, _sampled(picture, channel), _sampled(background, channel))
        for channel in (0, 2)
    ]
    return np.array([ratios[0], green, ratios[1]], np.float32)


def _own_or(green: float, now: NDArray[np.uint8], usual: NDArray[np.uint8]) -> float:
    """The ratio of a channel's samples, or that of green."""
    own = _ratio(now, usual, green)
    if abs(own - green) < _SAME_RATIO:
        return green
    better = _suited(own, now, usual) - _suited(green, now, usual)
    return own if better > _CLEARLY * len(now) else green


def _suited(ratio: float, now: NDArray[np.uint8], usual: NDArray[np.uint8]) -> int:
    """How many samples a ratio explains."""
    return int(np.count_nonzero(np.abs(now - ratio * usual.astype(np.float32)) < _SUITS))


def scaled(picture: NDArray[Any], ratios: NDArray[np.float32]) -> NDArray[np.uint8]:
    """(height, width, 3) uint8, the picture with its channels times these."""
    factors = np.append(ratios, np.float32(1)).astype(np.float64)
    return np.asarray(cv2.multiply(picture, factors, dtype=cv2.CV_8U), np.uint8)


def _sampled(picture: NDArray[np.uint8], channel: int) -> NDArray[np.uint8]:
    """One channel at the grid of pixels."""
    rows = max(1, picture.shape[0] // _SAMPLES_PER_SIDE)
    columns = max(1, picture.shape[1] // _SAMPLES_PER_SIDE)
    return picture[rows // 2 :: rows, columns // 2 :: columns, channel].ravel()


def _ratio(now: NDArray[np.uint8], usual: NDArray[np.uint8], untold: float = 1.0) -> float:
    usable = (now < _BRIGHTEST) & (usual < _BRIGHTEST) & (usual > _DARKEST) & (now > _DARKEST)
    if np.count_nonzero(usable) < _FEWEST_SAMPLES:
        return untold
    return _median(now[usable] / usual[usable].astype(np.float32))


def _median(values: NDArray[np.floating]) -> float:
    """As `numpy.median`, without its checks, which cost several times as much as the rest."""
    middle = len(values) // 2
    ordered = np.partition(values, (middle - 1, middle))
    if len(values) % 2:
        return float(ordered[middle])
    return float((ordered[middle - 1] + ordered[middle]) / 2)
