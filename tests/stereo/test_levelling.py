"""Eyes a little out of level are noticed, and the right one's rows put where they belong."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.stereo.levelling import Levelling

Grey = NDArray[np.uint8]
STEP, DISPARITY_PX = 2, 9.0
ROWS, COLUMNS = 240, 320


def eyes(lower_px: float = 0.0, turned_rad: float = 0.0, noise: float = 1.5) -> tuple[Grey, Grey]:
    """Spots seen level by the left eye, and by the right one lower and turned about its middle."""
    random = np.random.default_rng(2)
    spots = cv2.GaussianBlur(random.uniform(0, 255, (ROWS, COLUMNS)).astype(np.float32), (0, 0), 3)
    left = 110 + 6 * (spots - spots.mean())
    middle = np.array(((COLUMNS - 1) / 2, (ROWS - 1) / 2))
    beside = np.array((DISPARITY_PX, 0))
    turn = np.array(((1, -turned_rad), (turned_rad, 1)))
    moved = np.column_stack((turn, middle - turn @ (middle + beside) + (0, lower_px)))
    right = cv2.warpAffine(left, moved, (COLUMNS, ROWS), borderMode=cv2.BORDER_REFLECT)
    both = [eye + random.normal(0, noise, left.shape) for eye in (left, right)]
    return both[0].clip(0, 255).astype(np.uint8), both[1].clip(0, 255).astype(np.uint8)


def learnt(left: Grey, right: Grey) -> Levelling:
    """Of eyes that range the whole scene where it is."""
    levelling = Levelling()
    scene = np.full((ROWS // STEP, COLUMNS // STEP), DISPARITY_PX, np.float32)
    levelling.learn(left, right, scene, STEP)
    return levelling


def apart(left: Grey, right: Grey) -> float:
    """Grey levels between the eyes where both see the same, sides left out."""
    inner = np.s_[20:-20, 20:-40]
    shifted = np.roll(right, round(DISPARITY_PX), axis=1)
    return float(np.abs(left.astype(float) - shifted)[inner].mean())


@pytest.mark.parametrize("noise", [0.0, 4.0])
def test_level_eyes_are_left_as_they_are(noise: float) -> None:
    left, right = eyes(noise=noise)
    assert learnt(left, right).level(right) is right


@pytest.mark.parametrize(
    ("lower_px", "turned_rad"), [(1.0, 0.0), (-0.6, 0.0), (0.0, 0.004), (0.7, -0.005)]
)
def test_rows_of_an_eye_that_sees_lower_or_is_turned_are_put_back(
    lower_px: float, turned_rad: float
) -> None:
    left, right = eyes(lower_px, turned_rad)
    level = learnt(left, right).level(right)
    assert apart(left, level) < 0.6 * apart(left, right)
    assert learnt(left, level).off is None


def test_an_eye_that_is_far_off_is_calibrated_wrong_and_left_alone() -> None:
    left, right = eyes(7.0)
    assert learnt(left, right).off is None


def test_a_plain_scene_says_nothing() -> None:
    plain = np.full((ROWS, COLUMNS), 120, np.uint8)
    assert learnt(plain, plain).off is None


def test_where_nothing_is_ranged_nothing_is_said() -> None:
    left, right = eyes(1.0)
    levelling = Levelling()
    levelling.learn(left, right, np.full((ROWS // STEP, COLUMNS // STEP), np.nan, np.float32), STEP)
    assert levelling.off is None
