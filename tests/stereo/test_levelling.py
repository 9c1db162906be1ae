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


def eyes(
    lower_px: float = 0.0, turned_rad: float = 0.0, noise: float = 1.5, seed: int = 2
) -> tuple[Grey, Grey]:
    """Spots seen level by the left eye, and by the right one lower and turned about its middle."""
    random = np.random.default_rng(seed)
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


def learnt_in_a_corner(lower_px: float, seed: int) -> Levelling:
    """Of eyes that see something in the upper left of a large picture alone."""
    random = np.random.default_rng(100 + seed)
    both = []
    for eye, shift in zip(
        eyes(lower_px, noise=0.0, seed=seed), (0, round(DISPARITY_PX)), strict=True
    ):
        whole = np.full((2 * ROWS, 2 * COLUMNS), 110.0)
        whole[:140, : 160 - shift] = eye[:140, : 160 - shift]
        noise = random.normal(0, 1.5, whole.shape)
        both.append(np.asarray((whole + noise).clip(0, 255), np.uint8))
    levelling = Levelling()
    scene = np.full((2 * ROWS // STEP, 2 * COLUMNS // STEP), DISPARITY_PX, np.float32)
    levelling.learn(both[0], both[1], scene, STEP)
    return levelling


def test_marks_in_a_corner_turn_no_level_eyes() -> None:
    assert all(learnt_in_a_corner(0.0, seed).off is None for seed in range(8))


def test_marks_in_a_corner_say_how_much_lower_an_eye_sees() -> None:
    off = learnt_in_a_corner(1.2, 0).off
    assert off is not None
    assert off[0] == pytest.approx(1.2, abs=0.5)


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
