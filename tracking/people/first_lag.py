"""By how much a camera of a recording is late, told before anything is tracked."""

from __future__ import annotations

from collections.abc import Generator

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Picture
from tracking.geometry import Rectification
from tracking.people.motion_agreement import (
    MOST_HELD,
    MotionAgreement,
    Stretch,
    beside_px,
    late_by,
    mean_of_four,
    thinned,
    thinning_px,
)
from tracking.recording import Recording, StereoFrame

Map = NDArray[np.float32]
"""(2, rows, columns): across and down, where a pixel comes from."""

_ELSEWHERE = 6
"""So many other stretches of a recording are looked at where the first one tells nothing."""
_A_GLANCE = 8
"""Frames after which a stretch is left in which hardly anything moves."""
_NOWHERE_PX = -1e4
"""Of pixels behind the camera: far outside, so that they are black."""


def first_lag(recording: Recording, start: int = 0) -> int | None:
    """Frames by which the right camera is late; negative: the left one. None: nothing tells.

    Args:
        recording, start: see `lag_looks`.

    Raises:
        RecordingError: a frame cannot be read.
    """
    looks = lag_looks(recording, start)
    try:
        wanted = next(looks)
        while True:
            wanted = looks.send(recording.read(wanted))
    except StopIteration as told:
        lag: int | None = told.value
        return lag


def lag_looks(recording: Recording, start: int = 0) -> Generator[int, StereoFrame, int | None]:
    """The same as `first_lag`, for who reads the frames: asks for one by number after the other.

    Looked at is a stretch of a second or two from a frame on, and where it tells nothing, others
    that are spread over the recording, each of them and all together. Where the recording tells a
    lag, that one is it unless a stretch tells another, or it leaves no two pictures of an instant.

    Args:
        recording: of two cameras; rectified where it can be. start: the frame that matters most.
    """
    told_lag = recording.right_lag
    movement = _movement(recording)
    maps = thinned_maps(recording.rectification)
    stretches: list[Stretch] = []
    frames = movement.span + 1 + MOST_HELD
    last = max(0, recording.frame_count - frames)
    spread = np.linspace(0, last, _ELSEWHERE + 2)[1:-1].astype(int).tolist()
    for first in (min(start, last), *spread):
        movement.begin()
        for number in range(first, min(first + frames, recording.frame_count)):
            frame = yield number
            movement.add(thinned_images(frame, maps))
            glanced = number == first + _A_GLANCE
            if len(movement) == movement.span or (glanced and movement.is_still()):
                break
        stretch = movement.stretch()
        if stretch is not None:
            stretches.append(stretch)
            for told in ([stretch], stretches):
                lag = late_by(told, movement.most_lag)
                if lag is not None:
                    return lag
    return told_lag if abs(told_lag or 0) < recording.frame_count else None


def _movement(recording: Recording) -> MotionAgreement:
    """Looks for the lag that the recording tells, too, unless it is too short for that."""
    movement = MotionAgreement(recording.fps, recording.right_lag or 0)
    fits = movement.span < recording.frame_count
    return movement if fits else MotionAgreement(recording.fps)


def thinned_maps(rectification: Rectification | None) -> tuple[Map, Map] | None:
    """Where the pixels that are compared come from in both cameras; None: from where they are.

    As `thinned` takes the mean of four, there are four for each. All pixels
    would take seconds.
    """
    if rectification is None or rectification.identity:
        return None
    width, height = rectification.size
    step = thinning_px(width)
    across, down = (
        (np.arange(side // step)[:, None] * step + (0, beside_px(step))).ravel().clip(0, side - 1)
        for side in (width, height)
    )
    u, v = np.meshgrid(across, down)
    pixels = np.column_stack((u.ravel(), v.ravel()))
    left, right = (
        np.nan_to_num(recorded, nan=_NOWHERE_PX).astype(np.float32).T.reshape(2, *u.shape)
        for recorded in (
            rectification.recorded_from_rectified(pixels),
            rectification.right_recorded_from_rectified(pixels),
        )
    )
    return left, right


def thinned_images(frame: StereoFrame, maps: tuple[Map, Map] | None) -> tuple[Picture, Picture]:
    """Both cameras as they are compared."""
    assert frame.right is not None
    if maps is None:
        return thinned(frame.left), thinned(frame.right)
    left, right = (
        mean_of_four(
            np.asarray(cv2.remap(cv2.extractChannel(image, 1), x, y, cv2.INTER_LINEAR), np.uint8), 2
        )
        for image, (x, y) in zip((frame.left, frame.right), maps, strict=True)
    )
    return left, right
