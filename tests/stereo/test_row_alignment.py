"""Cameras a little out of level are noticed, and the right one's rows put where they belong."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.stereo.row_alignment import Levelling

Grey = NDArray[np.uint8]
STEP, DISPARITY_PX = 2, 9.0
ROWS, COLUMNS = 240, 320


def cameras(
    lower_px: float = 0.0, turned_rad: float = 0.0, noise: float = 1.5, seed: int = 2
) -> tuple[Grey, Grey]:
    """Spots seen level by the left camera, lower and turned by the right one."""
    random = np.random.default_rng(seed)
    spots = cv2.GaussianBlur(random.uniform(0, 255, (ROWS, COLUMNS)).astype(np.float32), (0, 0), 3)
    left = 110 + 6 * (spots - spots.mean())
    middle = np.array(((COLUMNS - 1) / 2, (ROWS - 1) / 2))
    beside = np.array((DISPARITY_PX, 0))
    turn = np.array(((1, -turned_rad), (turned_rad, 1)))
    moved = np.column_stack((turn, middle - turn @ (middle + beside) + (0, lower_px)))
    right = cv2.warpAffine(left, moved, (COLUMNS, ROWS), borderMode=cv2.BORDER_REFLECT)
    both = [side + random.normal(0, noise, left.shape) for side in (left, right)]
    return both[0].clip(0, 255).astype(np.uint8), both[1].clip(0, 255).astype(np.uint8)


def learnt(left: Grey, right: Grey) -> Levelling:
    """Of cameras that range the whole scene where it is."""
    levelling = Levelling()
    levelling.learn(left, right, scene_at(DISPARITY_PX), STEP)
    return levelling


def scene_at(disparity_px: float) -> NDArray[np.float32]:
    """All of the scene as far away; NaN: nothing of it is ranged."""
    return np.full((ROWS // STEP, COLUMNS // STEP), disparity_px, np.float32)


def apart(left: Grey, right: Grey) -> float:
    """Grey levels between the cameras where both see the same, sides left out."""
    inner = np.s_[20:-20, 20:-40]
    shifted = np.roll(right, round(DISPARITY_PX), axis=1)
    return float(np.abs(left.astype(float) - shifted)[inner].mean())


@pytest.mark.parametrize("noise", [0.0, 4.0])
def test_level_cameras_are_left_as_they_are(noise: float) -> None:
    left, right = cameras(noise=noise)
    assert learnt(left, right).level(right) is right


@pytest.mark.parametrize(
    ("lower_px", "turned_rad"), [(1.0, 0.0), (-0.6, 0.0), (0.0, 0.004), (0.7, -0.005)]
)
def test_rows_of_a_camera_that_sees_lower_or_is_turned_are_put_back(
    lower_px: float, turned_rad: float
) -> None:
    left, right = cameras(lower_px, turned_rad)
    level = learnt(left, right).level(right)
    assert apart(left, level) < 0.6 * apart(left, right)
    assert learnt(left, level).off is None


def learnt_in_a_corner(lower_px: float, seed: int) -> Levelling:
    """Of cameras that see something in the upper left of a large picture alone."""
    random = np.random.default_rng(100 + seed)
    both = []
    for side, shift in zip(
        cameras(lower_px, noise=0.0, seed=seed), (0, round(DISPARITY_PX)), strict=True
    ):
        whole = np.full((2 * ROWS, 2 * COLUMNS), 110.0)
        whole[:140, : 160 - shift] = side[:140, : 160 - shift]
        noise = random.normal(0, 1.5, whole.shape)
        both.append(np.asarray((whole + noise).clip(0, 255), np.uint8))
    levelling = Levelling()
    scene = np.full((2 * ROWS // STEP, 2 * COLUMNS // STEP), DISPARITY_PX, np.float32)
    levelling.learn(both[0], both[1], scene, STEP)
    return levelling


def test_marks_in_a_corner_turn_no_level_cameras() -> None:
    assert all(learnt_in_a_corner(0.0, seed).off is None for seed in range(8))


def test_marks_in_a_corner_say_how_much_lower_a_camera_sees() -> None:
    off = learnt_in_a_corner(1.2, 0).off
    assert off is not None
    assert off[0] == pytest.approx(1.2, abs=0.5)


def test_a_camera_that_is_far_off_is_calibrated_wrong_and_left_alone() -> None:
    left, right = cameras(7.0)
    assert learnt(left, right).off is None


def test_a_plain_scene_says_nothing() -> None:
    plain = np.full((ROWS, COLUMNS), 120, np.uint8)
    assert learnt(plain, plain).off is None


def test_where_nothing_is_ranged_nothing_is_said() -> None:
    left, right = cameras(1.0)
    levelling = Levelling()
    assert not levelling.learn(left, right, scene_at(np.nan), STEP)
    assert levelling.off is None


def test_what_is_known_stays_while_a_scene_tells_nothing() -> None:
    left, right = cameras(1.0, 0.004)
    levelling = learnt(left, right)
    off = levelling.off
    assert off is not None
    plain = np.full_like(left, 120)
    assert not levelling.learn(left, right, scene_at(np.nan), STEP)
    assert not levelling.learn(plain, plain, scene_at(DISPARITY_PX), STEP)
    assert levelling.off is off


def test_what_is_known_stays_while_marks_say_nearly_the_same() -> None:
    levelling = learnt(*cameras(1.0))
    off = levelling.off
    assert levelling.learn(*cameras(1.2, noise=3.0, seed=5), scene_at(DISPARITY_PX), STEP)
    assert levelling.off is off


@pytest.mark.parametrize("lower_px", [-1.0, 2.0])
def test_a_camera_that_is_knocked_again_is_put_back_from_there(lower_px: float) -> None:
    levelling = learnt(*cameras(1.0))
    assert levelling.learn(*cameras(lower_px), scene_at(DISPARITY_PX), STEP)
    assert levelling.off is not None
    assert levelling.off[0] == pytest.approx(lower_px, abs=0.1)


def test_cameras_that_are_level_again_are_left_as_they_are() -> None:
    levelling = learnt(*cameras(1.0, 0.004))
    assert levelling.learn(*cameras(), scene_at(DISPARITY_PX), STEP)
    assert levelling.off is None


def test_marks_in_a_corner_leave_the_known_turn_as_it_is() -> None:
    levelling = learnt(*cameras(0.0, 0.006))
    known = levelling.off
    assert known is not None
    left, right = cameras(1.0, 0.006)
    scene = scene_at(np.nan)
    scene[: ROWS // 4, : COLUMNS // 4] = DISPARITY_PX
    assert levelling.learn(left, right, scene, STEP)
    assert levelling.off is not None
    np.testing.assert_allclose(levelling.off[1:], known[1:])
    assert levelling.off[0] == pytest.approx(1.0, abs=0.2)


def cameras_over_a_floor(lower_px: float) -> tuple[Grey, Grey, NDArray[np.float32]]:
    """Cameras that see a floor, ranged row by row, of which the right one sees lower."""
    left, _ = cameras(noise=0.0)
    rows, columns = np.indices(left.shape, np.float32)
    nearer_px = 2 + 16 * rows / ROWS
    right = cv2.remap(left, columns + nearer_px, rows - lower_px, cv2.INTER_LINEAR)
    return left, np.asarray(right, np.uint8), nearer_px[::STEP, ::STEP]


@pytest.mark.parametrize("lower_px", [0.0, 1.0, -1.5])
def test_a_floor_that_comes_nearer_row_by_row_is_no_camera_out_of_level(lower_px: float) -> None:
    left, right, scene = cameras_over_a_floor(lower_px)
    levelling = Levelling()
    assert levelling.learn(left, right, scene, STEP)
    if lower_px == 0.0:
        assert levelling.off is None
    else:
        assert levelling.off is not None
        np.testing.assert_allclose(levelling.off, (lower_px, 0, 0), atol=0.1)
