"""The background learnt from pictures between which the light changed."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel
from tracking.foreground.background_modes import in_one_light

Picture = NDArray[np.uint8]
SHAPE = (240, 320, 3)
LEFT, RIGHT = np.s_[60:180, 20:140], np.s_[60:180, 180:300]


def scene(share: float, lit: slice, crowd: tuple[slice, slice], seed: int) -> Picture:
    """A grained floor of which some columns have a share of the light, and a crowd on it."""
    floor = np.repeat(np.random.default_rng(3).normal(120, 10, SHAPE[:2])[..., None], 3, axis=2)
    random = np.random.default_rng(seed)
    floor[crowd] = random.normal(random.uniform(20, 200), 15, floor[crowd].shape)
    floor[:, lit] *= share
    return np.clip(floor + random.normal(0, 1, SHAPE), 0, 255).astype(np.uint8)


def before_and_after(share: float, lit: slice) -> list[Picture]:
    """Light that changes half-way; who hides the left at first goes to the right then."""
    before = [scene(1.0, lit, LEFT, k) for k in range(6)]
    return before + [scene(share, lit, RIGHT, 6 + k) for k in range(6)]


@pytest.mark.parametrize("share", [0.8, 1.25])
@pytest.mark.parametrize(
    "lit", [slice(0, 320), slice(100, 320)], ids=["all over", "on a part of the scene"]
)
def test_a_scene_learnt_before_and_after_the_light_changed_holds_nobody_when_it_is_empty(
    share: float, lit: slice
) -> None:
    background = BackgroundModel(20.0)
    background.learn(before_and_after(share, lit))
    for light in (1.0, share):
        empty = scene(light, lit, np.s_[0:0, 0:0], 99)
        assert (background.subtract(empty).mask > 0).mean() < 0.01


def test_pictures_in_one_light_stay_as_they_are() -> None:
    pictures = [scene(1.0, slice(0, 320), LEFT, k) for k in range(6)]
    for one, other in zip(in_one_light(pictures), pictures, strict=True):
        np.testing.assert_array_equal(one, other)
