"""What others would do for a frame, timed on the same frames as the pipeline, on one thread.

Neither follows anybody: both stop where people would have to be told apart, so a ratio of one
would be more than fair to them. They search the very disparities that people can have in the
scene, which whoever writes such a thing would have to find out first.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Collection

import cv2
import numpy as np

from tracking.recording import Recording, StereoFrame
from tracking.stereo.settings import StereoSettings
from tracking.stereo.sight_lines import SightLines

Work = Callable[[StereoFrame], object]


def primitives(recording: Recording) -> Work:
    """The least that has to be called: one background subtraction and one block matching.

    The background is subtracted in the left eye only, in colour (MOG2); the matching is OpenCV's
    quickest, StereoBM, on whole grey pictures.
    """
    least, count = _search(recording)
    background = cv2.createBackgroundSubtractorMOG2()
    matcher = cv2.StereoBM.create(count, 9)
    matcher.setMinDisparity(least)

    def work(frame: StereoFrame) -> object:
        background.apply(frame.left)
        return matcher.compute(*_grey(recording, frame))

    return work


def obvious(recording: Recording) -> Work:
    """What comes to mind first: MOG2 and StereoSGBM on whole pictures, regions of what is both.

    SGBM has the parameters of OpenCV's own example. MOG2 finds shadows too, so it can leave them
    out; specks are opened away and the remaining regions counted.
    """
    least, count = _search(recording)
    background = cv2.createBackgroundSubtractorMOG2(detectShadows=True)
    matcher = cv2.StereoSGBM.create(
        least, count, 5, P1=8 * 25, P2=32 * 25, disp12MaxDiff=1, uniquenessRatio=10,
        speckleWindowSize=100, speckleRange=32,
    )  # fmt: skip
    kernel = np.ones((3, 3), np.uint8)

    def work(frame: StereoFrame) -> object:
        people = np.asarray(background.apply(frame.left)) == 255
        disparity = matcher.compute(*_grey(recording, frame))
        seen = (people & (disparity >= 16 * least)).astype(np.uint8)
        return cv2.connectedComponentsWithStats(cv2.morphologyEx(seen, cv2.MORPH_OPEN, kernel))

    return work


def frame_ms(recording: Recording, work: Work, frames: Collection[int]) -> float:
    """Milliseconds of processor time a frame, decoding included; only `frames` count."""
    counted = frozenset(frames)
    spent_s = 0.0
    before = time.process_time()
    for frame in recording.frames():
        work(frame)
        now = time.process_time()
        spent_s += now - before if frame.number in counted else 0.0
        before = now
    return 1000.0 * spent_s / len(counted)


def _grey(recording: Recording, frame: StereoFrame) -> tuple[np.ndarray, np.ndarray]:
    assert recording.rectification is not None
    assert frame.right is not None
    left, right = recording.rectification.rectify(frame.left, frame.right)
    return (
        np.asarray(cv2.cvtColor(left, cv2.COLOR_BGR2GRAY)),
        np.asarray(cv2.cvtColor(right, cv2.COLOR_BGR2GRAY)),
    )


def _search(recording: Recording) -> tuple[int, int]:
    """The least disparity of the floor, and how many there are up to the tallest person's head."""
    assert recording.rectification is not None
    lines, settings = SightLines(recording.rectification), StereoSettings()
    near, far = settings.nearest_m, settings.farthest_m
    least = int(lines.disparity_at_height(0.0, near, far).min())
    most = int(np.ceil(lines.disparity_at_height(settings.tallest_m, near, far).max()))
    return least, -(-(most - least + 1) // 16) * 16
