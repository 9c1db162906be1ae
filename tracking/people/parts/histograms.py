"""Colour histograms of thousands of rectangles at once."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.people.parts.equalisation import (
    BINS,
    CHANNELS,
    LEVELS,
    bhattacharyya,
    equalisation,
    equalised,
)

Floats = NDArray[np.float32]
Bytes = NDArray[np.uint8]

_FIELDS = 4
"""Counters of 16 bits in a word of 64: the sums of four bins are made as one."""
_WORDS = BINS // _FIELDS
_MOST_PIXELS = 2**16 - 1


def ycbcr(picture: Bytes) -> Bytes:
    """(height, width, 3) a picture in blue, green, red as Y, Cr, Cb, in OpenCV's order."""
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2YCrCb), np.uint8)


def level_histograms(picture: Bytes, rectangles: NDArray[np.floating]) -> Floats:
    """(n, 3, 256) unequalised histograms; H and Q of [ZhaoLee2009] eq. 1.

    For the few rectangles of a frame's people, one after the other: to gather the pixels of all
    at once takes twice as long.

    Args:
        picture: (height, width, 3) of `ycbcr`.
        rectangles: (n, 4) cx, cy, width, height in px.

    Returns:
        Each channel sums to 1, or to 0 where the rectangle shows no pixel.
    """
    found = np.zeros((len(rectangles), CHANNELS, LEVELS), np.float32)
    for row, (left, top, right, bottom) in enumerate(pixel_bounds(rectangles, picture.shape)):
        pixels = picture[top:bottom, left:right].reshape(-1, CHANNELS)
        if len(pixels):
            levels = pixels + np.arange(CHANNELS) * LEVELS
            counted = np.bincount(levels.ravel(), minlength=CHANNELS * LEVELS)
            found[row] = counted.reshape(CHANNELS, LEVELS) / len(pixels)
    return found


def candidate_histograms(
    picture: Bytes,
    rectangles: NDArray[np.floating],
    owner: NDArray[np.integer],
    mapping: NDArray[np.uint8],
) -> Floats:
    """(n, 24) equalised histograms M(H') of many rectangles, each channel summing to 1.

    All rectangles of one owner share its mapping and one table of sums over the part of the
    picture in which they lie.

    Args:
        picture: (height, width, 3) of `ycbcr`.
        rectangles: (n, 4) cx, cy, width, height in px.
        owner: (n,) which row of `mapping` counts.
        mapping: (k, 3, 256) of `equalisation`.

    Returns:
        Rows are 0 where the rectangle shows no pixel.
    """
    found = np.zeros((len(rectangles), CHANNELS * BINS), np.float32)
    bounds = pixel_bounds(rectangles, picture.shape)
    order = np.argsort(owner, kind="stable")
    starts = np.searchsorted(owner[order], np.arange(len(mapping) + 1))
    for k in range(len(mapping)):
        rows = order[starts[k] : starts[k + 1]]
        if len(rows):
            found[rows] = _counted(picture, bounds[rows], mapping[k])
    return found


def similarities(
    picture: Bytes,
    rectangles: NDArray[np.floating],
    owner: NDArray[np.integer],
    models: Floats,
) -> Floats:
    """(n,) how alike the rectangles' colours and their owners' models are, 0 to 1.

    Args:
        picture, rectangles, owner: of `candidate_histograms`.
        models: (k, 3, 256) of `level_histograms`, as updated.
    """
    mapping = equalisation(models)
    reference = equalised(models, mapping)
    candidates = candidate_histograms(picture, rectangles, owner, mapping)
    return bhattacharyya(candidates, reference[owner])


def pixel_bounds(rectangles: NDArray[np.floating], shape: tuple[int, ...]) -> NDArray[np.intp]:
    """(n, 4) left, top, right, bottom (half-open) of the pixels whose centres lie inside.

    Args:
        rectangles: (n, 4) cx, cy, width, height in px; NaN: no pixel.
        shape: of the picture, outside of which there is none.
    """
    middle, half = rectangles[:, :2], np.abs(rectangles[:, 2:]) / 2
    size = np.array(shape[1::-1])
    low = np.clip(np.ceil(np.nan_to_num(middle - half)), 0, size)
    high = np.clip(np.floor(np.nan_to_num(middle + half, nan=-1.0)) + 1, low, size)
    return np.concatenate((low, high), axis=1).astype(np.intp)


def _counted(picture: Bytes, bounds: NDArray[np.intp], mapping: Bytes) -> Floats:
    """(m, 24) histograms of one owner's rectangles."""
    left, top = bounds[:, :2].min(axis=0)
    right, bottom = bounds[:, 2:].max(axis=0)
    step = _step(bounds)
    crop = picture[top:bottom:step, left:right:step]
    inside = -(-(bounds - np.array((left, top, left, top))) // step)
    sums = _sums(crop, mapping)
    flat = _corners(inside, crop.shape[1] + 1)
    low_low, low_high, high_low, high_high = (sums[:, corner] for corner in flat)
    packed = high_high - low_high - high_low + low_low
    counts = np.ascontiguousarray(packed.T).view(np.uint16).astype(np.float32)
    area = (inside[:, 2] - inside[:, 0]) * (inside[:, 3] - inside[:, 1])
    return np.asarray(counts / np.maximum(area, 1)[:, None].astype(np.float32), np.float32)


def _step(bounds: NDArray[np.intp]) -> int:
    """Of large rectangles only every second, third, ... row and column is looked at."""
    largest = int(((bounds[:, 2] - bounds[:, 0]) * (bounds[:, 3] - bounds[:, 1])).max())
    return max(1, int(np.ceil(np.sqrt(largest / (_MOST_PIXELS / 2)))))


def _sums(crop: Bytes, mapping: Bytes) -> NDArray[np.uint64]:
    """(6, (rows + 1) * (columns + 1)) integral images, four bins a word.

    Words may run over: the sums of any rectangle that fits into 16 bits come out right all the
    same, because differences are taken modulo the same power of two.
    """
    rows, columns = crop.shape[:2]
    words = _words(mapping)
    sums = np.zeros((CHANNELS * _WORDS, rows + 1, columns + 1), np.uint64)
    for channel in range(CHANNELS):
        levels = crop[..., channel]
        for word in range(_WORDS):
            inner = sums[channel * _WORDS + word, 1:, 1:]
            np.cumsum(words[channel, word][levels], axis=1, out=inner)
            np.cumsum(inner, axis=0, out=inner)
    return sums.reshape(CHANNELS * _WORDS, -1)


def _words(mapping: Bytes) -> NDArray[np.uint64]:
    """(3, 2, 256) what a pixel of a level adds to each word."""
    bins = mapping.astype(np.uint64)
    shift = (bins % np.uint64(_FIELDS)) * np.uint64(16)
    one = np.left_shift(np.uint64(1), shift)
    word = np.arange(_WORDS, dtype=np.uint64)[None, :, None]
    return np.where(bins[:, None] // np.uint64(_FIELDS) == word, one[:, None], np.uint64(0))


def _corners(bounds: NDArray[np.intp], columns: int) -> tuple[NDArray[np.intp], ...]:
    """Flat places of (top, left), (top, right), (bottom, left) and (bottom, right)."""
    left, top, right, bottom = bounds.T
    return (
        top * columns + left,
        top * columns + right,
        bottom * columns + left,
        bottom * columns + right,
    )
