"""Overlays are made when they are asked for, and counted without being made."""

import numpy as np
import pytest

from tracking.people import Overlays


def _overlays(seed: int, shrink: int) -> Overlays:
    random = np.random.default_rng(seed)
    foreground = (random.random((46, 62)) < 0.5).astype(np.uint8) * np.uint8(255)
    shadow = random.choice(np.array((0, 1, 255), np.uint8), (46, 62)) & foreground
    disparity = random.uniform(2, 40, (23, 31)).astype(np.float32)
    disparity[random.random(disparity.shape) < 0.4] = np.nan
    return Overlays(foreground, disparity, shadow, (62 * shrink, 46 * shrink), shrink)


@pytest.mark.parametrize("shrink", [1, 2])
def test_pictures_are_of_the_recorded_size_in_its_pixels(shrink: int) -> None:
    made = _overlays(0, shrink)
    assert made.disparity is not None
    assert made.foreground.shape == made.disparity.shape == (46 * shrink, 62 * shrink)
    assert set(np.unique(made.foreground)) == {0, 127, 255}
    assert np.nanmax(made.disparity) == pytest.approx(40 * shrink, rel=0.1)


@pytest.mark.parametrize("shrink", [1, 2])
@pytest.mark.parametrize("step", [1, 3, 8])
def test_what_is_ranged_is_counted_as_in_the_pictures(shrink: int, step: int) -> None:
    made = _overlays(1, shrink)
    assert made.disparity is not None
    moving = made.foreground[::step, ::step] == 255
    known = np.isfinite(made.disparity[::step, ::step])
    assert made.ranged(step) == (np.count_nonzero(moving), np.count_nonzero(moving & known))


def test_without_stereo_nothing_is_ranged() -> None:
    assert Overlays(np.full((8, 8), 255, np.uint8), None).ranged(2) == (0, 0)
