"""By how much an eye of a recording is late, told before anything is tracked."""

from __future__ import annotations

from collections.abc import Generator

import cv2
import numpy as np

from tracking.people.eye_movement import EyeMovement, Picture, Stretch, late_by, thinned
from tracking.recording import Recording, StereoFrame

_ELSEWHERE = 4
"""So many other stretches of a recording are looked at where the first one tells nothing."""


def first_lag(recording: Recording, start: int = 0) -> int | None:
    """Frames by which the right eye is late; negative: the left one. None: nothing tells.

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
    that are spread over the recording, each of them and all together.

    Args:
        recording: of two eyes; rectified where it can be. start: the frame that matters most.
    """
    movement = EyeMovement(recording.fps)
    stretches: list[Stretch] = []
    last = max(0, recording.frame_count - movement.span - 1)
    spread = np.linspace(0, last, _ELSEWHERE + 2)[1:-1].astype(int).tolist()
    for first in (min(start, last), *spread):
        movement.begin()
        for number in range(first, min(first + movement.span + 1, recording.frame_count)):
            frame = yield number
            movement.add(_eyes(recording, frame))
        stretch = movement.stretch()
        if stretch is not None:
            stretches.append(stretch)
            for told in ([stretch], stretches):
                lag = late_by(told, movement.most_lag)
                if lag is not None:
                    return lag
    return None


def _eyes(recording: Recording, frame: StereoFrame) -> tuple[Picture, Picture]:
    """Both eyes as they are compared; one channel of three is rectified."""
    assert frame.right is not None
    left, right = (
        np.asarray(cv2.extractChannel(e, 1), np.uint8) for e in (frame.left, frame.right)
    )
    if recording.rectification is not None:
        left, right = recording.rectification.rectify(left, right)
    return thinned(left), thinned(right)
