"""How far two pictures are apart, pixel by pixel."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Channels = list[NDArray[np.uint8]]
"""The channels of a picture, (height, width) each: compared many times as fast as interleaved."""


def largest_difference(one: NDArray[np.uint8], other: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """(height, width) uint8, the largest difference over the three channels.

    Args:
        one, other: (height, width, 3) uint8.
    """
    blue, green, red = cv2.split(cv2.absdiff(one, other))
    return np.asarray(cv2.max(cv2.max(blue, green), red), np.uint8)


def channels_of(picture: NDArray[np.uint8]) -> Channels:
    """The three channels of a picture (height, width, 3)."""
    height, width = picture.shape[:2]
    return split_into([np.empty((height, width), np.uint8) for _ in range(3)], picture)


def split_into(channels: Channels, picture: NDArray[np.uint8]) -> Channels:
    """Write a picture's channels over those of another of its size."""
    return [np.asarray(channel, np.uint8) for channel in cv2.split(picture, channels)]


class ChannelDifference:
    """`largest_difference` of pictures of one size that are split into channels already.

    Its memory is its own: to ask for some anew for every frame takes as long as the work.
    """

    def __init__(self, shape: tuple[int, ...]) -> None:
        """`shape`: height and width."""
        self._largest: NDArray[np.uint8] = np.empty(shape[:2], np.uint8)
        self._each = np.empty_like(self._largest)

    def largest(self, one: Channels, other: Channels) -> NDArray[np.uint8]:
        """(height, width) uint8 over the three channels, written over at the next call."""
        largest, each = self._largest, self._each
        cv2.absdiff(one[0], other[0], largest)
        for channel, beside in zip(one[1:], other[1:], strict=True):
            cv2.max(largest, cv2.absdiff(channel, beside, each), largest)
        return largest
