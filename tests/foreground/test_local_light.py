"""Light that changes on a part of the scene, and people who walk in it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel
from tracking.foreground.local_light import change_of_light

Picture = NDArray[np.uint8]
SHAPE = (240, 320, 3)
PERSON = np.s_[60:180, 200:240]


def scene(light: NDArray[np.float64], person: bool = False, seed: int = 1) -> Picture:
    """A grained floor in a light of (height, width), with somebody in front of it or not."""
    random = np.random.default_rng(3)
    floor = np.repeat(random.normal(110, 10, SHAPE[:2])[..., None], 3, axis=2)
    if person:
        floor[PERSON] = np.random.default_rng(4).normal(70, 12, floor[PERSON].shape)
    noise = np.random.default_rng(seed).normal(0, 1.0, SHAPE)
    return np.clip(floor * light[..., None] + noise, 0, 255).astype(np.uint8)


def half_lit(share: float) -> NDArray[np.float64]:
    light = np.ones(SHAPE[:2])
    light[:, 160:] = share
    return light


def test_a_lamp_that_goes_out_over_half_the_scene_makes_no_foreground_but_the_person_in_it() -> (
    None
):
    background = BackgroundModel(20.0)
    background.learn([scene(np.ones(SHAPE[:2]), seed=k) for k in range(5)])
    seen = background.subtract(scene(half_lit(0.6), person=True, seed=9))
    person = np.zeros(SHAPE[:2], bool)
    person[PERSON] = True
    assert not seen.scene_changed
    assert (seen.mask[person] > 0).mean() > 0.75
    assert (seen.mask[~person] > 0).mean() < 0.03


def test_the_light_is_measured_where_it_changed() -> None:
    before, now = scene(np.ones(SHAPE[:2])), scene(half_lit(1.5), seed=2)
    mask = np.where(half_lit(1.5) > 1, 255, 0).astype(np.uint8)
    ratio = change_of_light(now, before, mask)
    assert ratio is not None
    np.testing.assert_allclose(ratio[:, :160], 1.0)
    np.testing.assert_allclose(ratio[:, 160:], 1.5, atol=0.05)


def test_a_crowd_before_the_scene_is_no_change_of_light() -> None:
    crowd = np.random.default_rng(8).normal(90, 20, SHAPE).clip(0, 255).astype(np.uint8)
    everywhere = np.full(SHAPE[:2], 255, np.uint8)
    assert change_of_light(crowd, scene(np.ones(SHAPE[:2])), everywhere) is None
