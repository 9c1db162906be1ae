"""Which picture of the right camera belongs to which of the left."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.recording.images import ImageSource, frame_numbers
from tracking.recording.pictures import PictureSource
from tracking.translation import Message, count_msg, msg

_SAME_CLOCK_SHARE = 0.9


@dataclass(frozen=True, slots=True, eq=False)
class Pairing:
    """The two cameras side by side.

    Attributes:
        right: (n,) number of the right camera's picture for each left picture; never decreasing.
        notes: what was odd, in words.
    """

    right: NDArray[np.int64]
    notes: tuple[Message, ...]


def pair_frames(left: PictureSource, right: PictureSource) -> Pairing:
    """Pair the pictures of two sources.

    Cameras are paired by number: picture n with picture n, and the recording is as long as the
    shorter one. Where a camera lost pictures, and times (videos) or numbers in file names (images)
    show which, picture n keeps the picture taken at the same instant; where there is none, the
    one before it.
    """
    keys = _common_keys(left, right)
    if keys is not None and not _alike(*keys) and not all(map(_is_gapless, keys)):
        paired = _by_key(*keys)
        if paired is not None:
            return paired
    count = min(left.frame_count, right.frame_count)
    notes: tuple[Message, ...] = ()
    if left.frame_count != right.frame_count:
        notes = (
            msg(
                "the cameras differ in length: {name} has {frame_count} frames, "
                "{right_name} {right_frame_count}; the recording ends with the shorter one",
                name=left.name,
                frame_count=left.frame_count,
                right_name=right.name,
                right_frame_count=right.frame_count,
            ),
        )
    return Pairing(np.arange(count), notes)


def _common_keys(
    left: PictureSource, right: PictureSource
) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
    """When each picture was taken, in frames, on a clock the cameras share; None without one."""
    if left.stamps_ns is not None and right.stamps_ns is not None and left.fps:
        first = min(left.stamps_ns[0], right.stamps_ns[0])
        rate = left.fps / 1e9
        return (left.stamps_ns - first) * rate, (right.stamps_ns - first) * rate
    if isinstance(left, ImageSource) and isinstance(right, ImageSource):
        numbers = frame_numbers(left.files), frame_numbers(right.files)
        if numbers[0] is None or numbers[1] is None:
            return None
        return np.array(numbers[0], float), np.array(numbers[1], float)
    if left.times_s is None or right.times_s is None or not left.fps or not right.fps:
        return None
    if abs(left.fps - right.fps) > 0.01 * left.fps:
        return None
    return left.times_s * left.fps, right.times_s * left.fps


def _alike(left: NDArray[np.float64], right: NDArray[np.float64]) -> bool:
    count = min(len(left), len(right))
    return bool((np.abs(left[:count] - right[:count]) < 0.5).all())


def _is_gapless(keys: NDArray[np.float64]) -> bool:
    return bool((np.diff(keys) < 1.5).all())


def _by_key(left: NDArray[np.float64], right: NDArray[np.float64]) -> Pairing | None:
    """Pair by the shared clock; None where too few pictures have a partner on it."""
    left = left[left <= right[-1] + 0.5]
    if not left.size or (np.diff(left) < 0).any() or (np.diff(right) < 0).any():
        return None
    nearest = np.searchsorted(right, left)
    before = np.maximum(nearest - 1, 0)
    nearest = np.minimum(nearest, len(right) - 1)
    nearest = np.where(left - right[before] < np.abs(right[nearest] - left), before, nearest)
    met = np.abs(right[nearest] - left) < 0.5
    if met.mean() < _SAME_CLOCK_SHARE:
        return None
    alone = int((~met).sum())
    filled = np.maximum.accumulate(np.where(met, nearest, 0))
    note = msg(
        "the cameras lost different frames; they are paired by when they were taken, "
        "and in {frames} the right image is the one before",
        frames=count_msg(alone, "{n} frame", "{n} frames"),
    )
    return Pairing(filled.astype(np.int64), (note,))
