"""A camera that was pushed is noticed; people who pass and light that changes are not."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.foreground import CameraWatch

SIZE = (640, 480)
STILL = np.eye(2, 3)


def _floor(seed: int = 1) -> NDArray[np.uint8]:
    random = np.random.default_rng(seed)
    grey = cv2.GaussianBlur(random.normal(140.0, 120.0, SIZE[::-1]), (0, 0), 3.0)
    return np.asarray(grey.clip(0, 255), np.uint8)


FLOOR = _floor()


def _seen(motion: NDArray[np.float64]) -> NDArray[np.uint8]:
    return np.asarray(cv2.warpAffine(FLOOR, motion, SIZE, borderMode=cv2.BORDER_REFLECT), np.uint8)


def _turned(degrees: float, up_px: float = 0.0) -> NDArray[np.float64]:
    motion = cv2.getRotationMatrix2D((319.5, 239.5), degrees, 1.0)
    motion[1, 2] += up_px
    return motion


def _watched(pictures: Sequence[NDArray[np.uint8]], fps: float = 1.0) -> CameraWatch:
    watch = CameraWatch(fps)
    for number, picture in enumerate(pictures):
        watch.look(number + 40, picture)
    return watch


@pytest.mark.parametrize(
    "motion",
    [_turned(0.0, 9.0), _turned(1.0), _turned(1.0, 14.0), _turned(-2.5, 3.0)],
    ids=["up", "twisted", "up and twisted", "twisted far"],
)
def test_a_camera_that_was_knocked_is_told_with_its_frame(motion: NDArray[np.float64]) -> None:
    watch = _watched([_seen(STILL)] * 4 + [_seen(motion)] * 4)
    assert watch.moved_at == 44
    (line,) = watch.notes("flow")
    assert line.startswith("the camera moved between frames 43 and 44: flow needs a fixed one")
    assert line.endswith("--frames 40:44")


def test_a_camera_that_turns_slowly_is_noticed() -> None:
    turning = [_seen(_turned(0.0, 0.3 * number)) for number in range(20)]
    moved_at = _watched(turning).moved_at
    assert moved_at is not None
    assert 44 < moved_at < 55


def test_pictures_are_compared_about_once_a_second() -> None:
    pictures = [_seen(STILL)] * 12 + [_seen(_turned(1.0))] * 20
    watch = _watched(pictures, fps=10.0)
    assert (watch.still_at, watch.moved_at) == (40 + 9, 40 + 19)


def test_a_camera_that_stands_still_in_changing_light_is_not_moved() -> None:
    pictures = [(FLOOR * (1.0 - 0.03 * number)).astype(np.uint8) for number in range(8)]
    watch = _watched(pictures)
    assert watch.moved_at is None
    assert watch.notes("flow") == ()


def test_something_that_crosses_half_the_picture_is_no_moved_camera() -> None:
    other = _floor(seed=5)
    pictures = []
    for number in range(8):
        part = np.s_[:, 40 * number : 40 * number + 250]
        picture = FLOOR.copy()
        picture[part] = np.roll(other, 40 * number, axis=1)[part]
        pictures.append(picture)
    assert _watched(pictures).moved_at is None


def test_a_picture_without_corners_says_nothing() -> None:
    assert _watched([np.full((480, 640, 3), 90, np.uint8)] * 4).moved_at is None
