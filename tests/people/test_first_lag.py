"""By how much a camera is late is told from some stretches of the footage."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, Rectification, StereoCalibration
from tracking.people import lag_looks
from tracking.people.first_lag import thinned_images, thinned_maps
from tracking.people.motion_agreement import MotionAgreement, thinned
from tracking.recording import StereoFrame

COUNT, ROWS, AROUND = 300, 120, 60


class Footage:
    """Rows in which by chance much or little moves, seen by two cameras of which one is late."""

    fps, rectification = 20.0, None
    right_lag: int | None = None

    def __init__(self, late: int, still_until: int = 0, count: int = COUNT) -> None:
        self.frame_count = count
        random = np.random.default_rng(4)
        self._noise = random.integers(0, 255, (COUNT + 2 * AROUND, ROWS, 160), np.uint8)
        self._moving = random.integers(0, 100, (COUNT + 2 * AROUND, ROWS, 1))
        self._late, self._still_until = late, still_until

    def frame(self, number: int) -> StereoFrame:
        return StereoFrame(number, 0.0, self._seen(number), self._seen(number - self._late))

    def _seen(self, number: int) -> NDArray[np.uint8]:
        if number < self._still_until:
            return np.zeros((ROWS, 160, 3), np.uint8)
        moves = np.arange(160) < self._moving[number + AROUND]
        return np.repeat(np.where(moves, self._noise[number + AROUND], 0)[..., None], 3, axis=2)


def found(footage: Footage, start: int = 0) -> tuple[int | None, list[int]]:
    """The lag, and the frames that were looked at for it."""
    looks, read = lag_looks(footage, start), []  # type: ignore[arg-type] # as a recording
    try:
        read.append(next(looks))
        while True:
            read.append(looks.send(footage.frame(read[-1])))
    except StopIteration as told:
        return told.value, read


@pytest.mark.parametrize("late", [-15, -3, 0, 5, 15])
def test_a_lag_is_found_in_the_first_stretch(late: int) -> None:
    assert found(Footage(late), 60) == (late, list(range(60, 92)))


def test_where_nothing_moves_another_stretch_is_looked_at_soon() -> None:
    lag, read = found(Footage(4, still_until=100))
    assert lag == 4
    assert read[:9] == list(range(9))
    assert read[-32:] == list(range(114, 146))


def test_footage_in_which_nothing_moves_tells_nothing() -> None:
    lag, read = found(Footage(4, still_until=COUNT + 20))
    assert lag is None
    assert len(read) == 7 * 9


def test_a_stretch_at_the_end_begins_earlier() -> None:
    lag, read = found(Footage(-6), COUNT - 2)
    assert lag == -6
    assert COUNT - 4 < read[-1] < COUNT


@pytest.mark.parametrize("late", [-50, 0, 4, 30])
@pytest.mark.parametrize("told", [-50, -2, 0, 30])
def test_a_lag_that_is_told_is_held_against_the_footage(late: int, told: int) -> None:
    footage = Footage(late)
    footage.right_lag = told
    lag, read = found(footage, 60)
    assert lag == (late if abs(late) <= max(abs(told), 15) else told)
    assert read[:9] == list(range(60, 69))


@pytest.mark.parametrize("late", [-9, 0, 4])
@pytest.mark.parametrize("told", [-60, -30, 30, 60])
@pytest.mark.parametrize("count", [36, 48])
def test_a_lag_that_is_told_is_held_against_short_footage_too(
    late: int, told: int, count: int
) -> None:
    footage = Footage(late, count=count)
    footage.right_lag = told
    lag, read = found(footage)
    assert lag == late
    assert max(read) < count


@pytest.mark.parametrize(("told", "lag"), [(60, None), (-48, None), (47, 47), (-5, -5)])
def test_a_lag_that_leaves_no_two_pictures_of_an_instant_is_not_believed(
    told: int, lag: int | None
) -> None:
    footage = Footage(0, still_until=COUNT, count=48)
    footage.right_lag = told
    assert found(footage)[0] == lag


@pytest.mark.parametrize(("still_until", "lag"), [(100, 4), (COUNT + AROUND, -2)])
def test_a_lag_that_is_told_stands_only_where_nothing_moves(still_until: int, lag: int) -> None:
    footage = Footage(4, still_until)
    footage.right_lag = -2
    assert found(footage)[0] == lag


@pytest.mark.parametrize(("fps", "most_lag"), [(20.0, 15), (60.0, 30), (10_000.0, 60)])
def test_a_stretch_is_of_few_frames_however_many_there_are_a_second(
    fps: float, most_lag: int
) -> None:
    movement = MotionAgreement(fps)
    assert movement.most_lag == most_lag
    assert movement.span <= 156


def test_pixels_are_compared_where_they_are_after_rectification() -> None:
    size, matrix = (320, 240), np.array([[300.0, 0, 160], [0, 300, 120], [0, 0, 1]])
    camera = Camera(matrix, np.array([-0.1, 0, 0, 0, 0]), *size)
    tilt = np.asarray(cv2.Rodrigues(np.array([0.03, 0, 0.02]))[0], float)
    calibration = StereoCalibration(camera, camera, tilt, np.array([-0.1, 0, 0]))
    rectification = Rectification(calibration, Ground(2.0, 20.0))
    smooth = cv2.GaussianBlur(np.random.default_rng(1).uniform(0, 255, (240, 320, 3)), (0, 0), 3)
    left, right = smooth.astype(np.uint8), smooth[::-1].astype(np.uint8)
    images = thinned_images(StereoFrame(0, 0.0, left, right), thinned_maps(rectification))
    for image, whole in zip(images, rectification.rectify(left, right), strict=True):
        assert image.shape == thinned(whole).shape
        assert np.abs(image.astype(int) - thinned(whole)).max() <= 5
