"""Colour histograms of people."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Rows
from tracking.people.settings import PeopleSettings
from tracking.people.silhouettes import AnyLabels

Histogram = NDArray[np.float32]

_BANDS = (0.15, 0.5, 0.85)
"""Where the upper body begins, the lower one, and what is below it: shares of a box's height."""
_MIDDLE_ACROSS = 0.6
"""Share of a box's width that is looked at."""
_GRID = (16, 12)
"""Points looked at down and across each half of a body: means change little with more."""
_DOWN, _ACROSS = ((np.arange(points) + 0.5) / points for points in _GRID)
_SHARE_DOWN = np.array([low + (high - low) * _DOWN for low, high in pairwise(_BANDS)])[..., None]
_SHARE_ACROSS = 0.5 + (_ACROSS - 0.5) * _MIDDLE_ACROSS
"""Where these points lie, as shares of a box's height and width."""


def colour_histograms(
    picture: NDArray[np.uint8],
    labels: AnyLabels,
    boxes: Sequence[tuple[int, int, int, int]],
    settings: PeopleSettings,
    step: int = 1,
) -> tuple[Histogram, Histogram, Histogram]:
    """Hue of the upper body and of the lower body, and hue with saturation of the middle.

    [Kawashita2012] takes hue histograms from two rectangles placed from the region's centre,
    [Kawashita2014] hue and saturation from the region's middle, its edge being unreliable. Only the
    region's own pixels count. Unlike there, each weighs as much in the hue as it is colourful,
    since grey has none; `hue_by_saturation` off, they are counted.

    Args:
        picture: (height, width, 3) uint8, blue, green, red.
        labels: (rows, columns) uint8, k + 1 for the pixels of region k.
        boxes: left, top, width, height of each region in the pixels of the labels.
        step: pixels of the picture from one of the labels to the next.

    Returns:
        (k, hue_bins), (k, hue_bins) and (k, hue_bins * saturation_bins), each row summing to 1.
    """
    count, bins = len(boxes), settings.hue_bins
    region, v, u, below = _inner_pixels(labels, boxes)
    hue, saturation = _hue_saturation(_shown(picture, v, u, step))
    hue_bin = hue.astype(np.intp) * bins // 180
    level = saturation.astype(np.intp) * settings.saturation_bins // 256
    both = hue_bin * settings.saturation_bins + level
    # The upper bodies' histograms, then the lower ones'.
    half = region + count * below
    weight = saturation.astype(np.float64) + 1 if settings.hue_by_saturation else None
    halves = _histograms(half, hue_bin, weight, (2 * count, bins))
    middle = _histograms(region, both, None, (count, bins * settings.saturation_bins))
    return halves[:count], halves[count:], middle


def clothes_colours(
    picture: NDArray[np.uint8],
    labels: AnyLabels,
    boxes: Sequence[tuple[int, int, int, int]],
    step: int = 1,
) -> NDArray[np.float32]:
    """(k, 2, 3) CIELAB of the mean colour of each region's upper and lower body.

    Unlike the papers' histograms of hue it tells black from white clothes. As many points are
    looked at in small as in large regions, those of a grid that lie on the region.

    Args:
        picture, labels, boxes, step: as for the histograms.

    Returns:
        lightness (0 to 100), a and b; NaN where the body shows no pixel.
    """
    count = len(boxes)
    v, u = _grids(boxes)
    shown = labels.ravel().take(v * labels.shape[1] + u)
    own = shown == np.arange(1, count + 1, dtype=labels.dtype).reshape(count, 1, 1, 1)
    points = _GRID[0] * _GRID[1]
    pixels = _shown(picture, v, u, step).reshape(count, 2, points, 3).astype(np.float32)
    counted = own.reshape(count, 2, 1, points).astype(np.float32)
    number = counted.sum(axis=(2, 3), dtype=np.float64)
    mean = (counted @ pixels)[:, :, 0] / np.maximum(number, 1)[..., None]
    clothes = _lab(mean.reshape(2 * count, 3)).reshape(count, 2, 3)
    clothes[number == 0] = np.nan
    return clothes


def _grids(
    boxes: Sequence[tuple[int, int, int, int]],
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Rows (k, 2, down, 1) and columns (k, 1, 1, across) of the points of both bodies' halves.

    The points lie inside their boxes, and so in the picture.
    """
    left, top, width, height = np.array(boxes, np.float32).reshape(-1, 4, 1, 1, 1).swapaxes(0, 1)
    v = (top + height * _SHARE_DOWN).astype(np.intp)
    u = (left + width * _SHARE_ACROSS).astype(np.intp)
    return v, u


def _shown(picture: NDArray[np.uint8], v: Rows, u: Rows, step: int) -> NDArray[np.uint8]:
    """(..., 3) the picture's colours at rows and columns of the labels.

    Taken by number in a row of pixels: several times as fast as by row and column.
    """
    place = (v * picture.shape[1] + u) * step
    return np.asarray(picture.reshape(-1, 3).take(place, axis=0), np.uint8)


def _lab(colour: NDArray[np.float64]) -> NDArray[np.float32]:
    """(n, 3) CIELAB of (n, 3) blue, green, red, 0 to 255."""
    if len(colour) == 0:
        return np.zeros((0, 3), np.float32)
    scaled = (colour / 255.0).astype(np.float32)[None]
    return np.asarray(cv2.cvtColor(scaled, cv2.COLOR_BGR2Lab)[0], np.float32)


def _inner_pixels(
    labels: AnyLabels, boxes: Sequence[tuple[int, int, int, int]]
) -> tuple[Rows, Rows, Rows, NDArray[np.bool_]]:
    """The bodies' pixels off their sides: region, row, column, and whether it is the lower body."""
    place = np.flatnonzero(labels != 0)
    region = labels.ravel().take(place).astype(np.intp) - 1
    v, u = np.divmod(place, labels.shape[1])
    left, top, width, height = np.array(boxes, np.intp).reshape(-1, 4).T
    edge = (width * (1 - _MIDDLE_ACROSS) / 2).astype(np.intp)
    across = u - (left + edge).take(region)
    share = (v - top.take(region) + 0.5) / np.maximum(height, 1).take(region)
    share = share.astype(np.float32)
    own = (share >= _BANDS[0]) & (share < _BANDS[2])
    own &= (across >= 0) & (across < (width - 2 * edge).take(region))
    kept = np.flatnonzero(own)
    return region.take(kept), v.take(kept), u.take(kept), share.take(kept) >= _BANDS[1]


def _hue_saturation(colours: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Hue, 0 to 179, and saturation of (n, 3) blue, green, red."""
    if len(colours) == 0:
        return colours[:, 0], colours[:, 1]
    hsv = np.asarray(cv2.cvtColor(colours[None], cv2.COLOR_BGR2HSV)[0], np.uint8)
    return hsv[:, 0], hsv[:, 1]


def _histograms(
    region: Rows, bins: Rows, weight: NDArray[np.float64] | None, shape: tuple[int, int]
) -> Histogram:
    """(regions, bins) of pixels, rows summing to 1; even where a region has none."""
    counted = np.bincount(region * shape[1] + bins, weight, shape[0] * shape[1]).reshape(shape)
    total = counted.sum(axis=1, keepdims=True)
    even = np.full(shape, 1 / shape[1])
    np.divide(counted, total, out=even, where=total > 0)
    return even.astype(np.float32)
