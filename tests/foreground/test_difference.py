"""The largest difference over the channels, of pictures whole or split."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.foreground.difference import (
    ChannelDifference,
    channels_of,
    largest_difference,
    split_into,
)


def pictures(seed: int) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    one, other = np.random.default_rng(seed).integers(0, 256, (2, 20, 30, 3), np.uint8)
    return one, other


def test_split_pictures_differ_as_whole_ones_do_time_after_time() -> None:
    compare = ChannelDifference((20, 30))
    for seed in range(3):
        one, other = pictures(seed)
        split = compare.largest(channels_of(one), channels_of(other))
        np.testing.assert_array_equal(split, largest_difference(one, other))


def test_a_picture_is_split_over_the_channels_of_the_one_before() -> None:
    before, now = pictures(0)
    channels = channels_of(before)
    written = split_into(channels, now)
    for channel, over, seen in zip(written, channels, now.transpose(2, 0, 1), strict=True):
        assert np.shares_memory(channel, over)
        np.testing.assert_array_equal(channel, seen)
