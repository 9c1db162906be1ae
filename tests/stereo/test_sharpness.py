"""A camera that is a little out of focus is noticed, and the other one smoothed as much."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.stereo.sharpness import EvenSharpness

Grey = NDArray[np.uint8]
SHIFT_PX = 8


def scene(noise: float, seed: int, spread_px: float = 0.0, gain: float = 1.0) -> Grey:
    """Tiles and spots as a lens out of focus by `spread_px` shows them to a noisy sensor."""
    spots = np.random.default_rng(1).uniform(60, 180, (48, 64)).astype(np.float32)
    light = cv2.resize(spots, (320, 240), interpolation=cv2.INTER_NEAREST)
    if spread_px:
        light = cv2.GaussianBlur(light, (0, 0), spread_px)
    grain = np.random.default_rng(seed).normal(0, noise, light.shape)
    seen = np.roll(light, -SHIFT_PX * seed, axis=1) * gain + grain
    return np.asarray(seen.clip(0, 255), np.uint8)


@pytest.mark.parametrize(("noise", "gain"), [(0.0, 1.0), (3.0, 1.15), (1.0, 0.85)])
def test_cameras_that_are_equally_sharp_are_left_as_they_are(noise: float, gain: float) -> None:
    left, right = scene(noise, 0), scene(noise, 1, gain=gain)
    cameras = EvenSharpness()
    cameras.learn(left, right)
    same = cameras.even(left, right)
    assert same[0] is left
    assert same[1] is right


@pytest.mark.parametrize("noise", [0.0, 3.0])
@pytest.mark.parametrize("spread_px", [0.8, 1.3])
@pytest.mark.parametrize("blurred", [0, 1])
def test_the_sharper_camera_is_smoothed_as_much_as_the_other_is_out_of_focus(
    blurred: int, spread_px: float, noise: float
) -> None:
    left, right = (scene(noise, side, spread_px if side == blurred else 0.0) for side in (0, 1))
    cameras = EvenSharpness()
    cameras.learn(left, right)
    assert cameras.spread_px[blurred] == 0.0
    assert cameras.spread_px[1 - blurred] == pytest.approx(spread_px, abs=0.2)


def test_a_camera_that_comes_into_focus_again_is_no_longer_evened() -> None:
    cameras = EvenSharpness()
    cameras.learn(scene(1.0, 0), scene(1.0, 1, 1.2))
    cameras.learn(scene(1.0, 0), scene(1.0, 1))
    assert cameras.spread_px == (0.0, 0.0)


def test_a_camera_that_seems_nearly_as_sharp_once_is_evened_still() -> None:
    cameras = EvenSharpness()
    cameras.learn(scene(1.0, 0), scene(1.0, 1, 1.2))
    cameras.learn(scene(1.0, 0), scene(1.0, 1, 0.55))
    assert cameras.spread_px[0] > 0
    fresh = EvenSharpness()
    fresh.learn(scene(1.0, 0), scene(1.0, 1, 0.55))
    assert fresh.spread_px == (0.0, 0.0)


def plain(light: float, seed: int) -> Grey:
    """A wall without anything on it, in some light."""
    grain = np.random.default_rng(seed).normal(light, 1.0, (240, 320))
    return np.asarray(grain.clip(0, 255), np.uint8)


def test_noise_says_nothing_of_how_sharp_cameras_are() -> None:
    cameras = EvenSharpness()
    cameras.learn(plain(110, 0), plain(118.3, 1))
    assert cameras.spread_px == (0.0, 0.0)


def test_what_is_known_stays_while_there_is_nothing_to_see() -> None:
    cameras = EvenSharpness()
    cameras.learn(scene(1.0, 0), scene(1.0, 1, 1.2))
    known = cameras.spread_px
    cameras.learn(plain(110, 0), plain(110, 1))
    assert cameras.spread_px == known != (0.0, 0.0)
