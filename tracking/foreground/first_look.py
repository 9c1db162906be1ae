"""The commonest look of a fixed scene, from a few pictures of it."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground.difference import largest_difference
from tracking.foreground.one_light import in_one_light

_SAME_WITHIN = 20
_MOST_PICTURES = 25


def commonest_picture(
    pictures: Sequence[NDArray[np.uint8]],
) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Per pixel, the one of the pictures' values that most others are close to.

    Unlike a median it needs no majority: people may cover a pixel in most pictures as long as
    they look different and the background looks the same. Light that changes between the
    pictures is taken out before.

    Args:
        pictures: at least one (height, width, 3) uint8; more than 25 are thinned out evenly.

    Returns:
        picture: (height, width, 3) uint8.
        deviation: (height, width) float32, mean difference of the values close to it.
    """
    chosen = [pictures[i] for i in _spread(len(pictures))]
    smooth = in_one_light([np.asarray(cv2.blur(picture, (3, 3)), np.uint8) for picture in chosen])
    height, width = smooth[0].shape[:2]
    best_cost = np.full((height, width), np.inf, np.float32)
    best = smooth[0].copy()
    for picture in smooth:
        cost = _strangeness(picture, smooth)
        better = cost < best_cost
        np.copyto(best, picture, where=better[..., None])
        np.copyto(best_cost, cost, where=better)
    return best, _deviation(best, smooth)


def _spread(count: int) -> NDArray[np.intp]:
    """Indices of at most 25 pictures, spread evenly."""
    return np.unique(np.linspace(0, count - 1, min(count, _MOST_PICTURES)).astype(np.intp))


def _strangeness(
    picture: NDArray[np.uint8], others: Sequence[NDArray[np.uint8]]
) -> NDArray[np.float32]:
    """(height, width) how far the picture is from the others, each bounded."""
    total = np.zeros(picture.shape[:2], np.float32)
    for other in others:
        cv2.accumulate(np.minimum(largest_difference(picture, other), _SAME_WITHIN), total)
    return total


def _deviation(
    picture: NDArray[np.uint8], others: Sequence[NDArray[np.uint8]]
) -> NDArray[np.float32]:
    """(height, width) mean distance of the others that are close."""
    total = np.zeros(picture.shape[:2], np.float32)
    count = np.zeros(picture.shape[:2], np.float32)
    for other in others:
        distance = largest_difference(picture, other)
        close = distance < _SAME_WITHIN
        total += distance * close
        count += close
    return np.asarray(total / np.maximum(count, 1), np.float32)
