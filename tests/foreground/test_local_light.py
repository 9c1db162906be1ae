"""Light that changes on a part of the scene, and people who walk in it."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel
from tracking.foreground.local_light import change_of_light, patches_of_light

Picture = NDArray[np.uint8]
SHAPE = (240, 320, 3)
PERSON = np.s_[60:180, 200:240]
PATCH = np.s_[40:140, 20:100]
FPS = 20.0


def scene(
    light: NDArray[np.float64],
    person: bool = False,
    seed: int = 1,
    where: tuple[slice, slice] = PERSON,
) -> Picture:
    """A grained floor in a light of (height, width) or with colours, with somebody or not."""
    random = np.random.default_rng(3)
    floor = np.repeat(random.normal(110, 10, SHAPE[:2])[..., None], 3, axis=2)
    if person:
        floor[where] = np.random.default_rng(4).normal(70, 12, floor[where].shape)
    noise = np.random.default_rng(seed).normal(0, 1.0, SHAPE)
    lit = floor * (light if light.ndim == 3 else light[..., None])
    return np.clip(lit + noise, 0, 255).astype(np.uint8)


def sunlit(blue: float = 1.2, green: float = 1.35, red: float = 1.45) -> NDArray[np.float64]:
    """Even light but for a small patch."""
    light = np.ones(SHAPE)
    light[PATCH] = (blue, green, red)
    return light


def learnt() -> BackgroundModel:
    background = BackgroundModel(FPS)
    background.learn([scene(np.ones(SHAPE[:2]), seed=k) for k in range(5)])
    return background


def watch(
    background: BackgroundModel, picture: Picture, seconds: float, people: Picture | None = None
) -> NDArray[np.bool_]:
    """The foreground after a picture has been there for some time."""
    for _ in range(round(seconds * FPS)):
        background.update(background.subtract(picture), people)
    return background.subtract(picture).mask > 0


def covering(where: tuple[slice, slice]) -> Picture:
    mask = np.zeros(SHAPE[:2], np.uint8)
    mask[where] = 255
    return mask


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


def test_a_coloured_light_that_changes_all_over_makes_no_foreground() -> None:
    mask = learnt().subtract(scene(np.broadcast_to((0.95, 0.8, 0.7), SHAPE), seed=9)).mask
    assert (mask > 0).mean() < 0.01


@pytest.mark.parametrize("light", [sunlit(), sunlit(0.6, 0.6, 0.6)], ids=["sun", "lamp out"])
def test_a_patch_of_other_light_is_soon_no_foreground_though_it_is_taken_for_a_person(
    light: NDArray[np.float64],
) -> None:
    background = learnt()
    lit, plain = scene(light, seed=9), scene(np.ones(SHAPE[:2]), seed=10)
    said_to_be_a_person = covering(PATCH)
    assert background.subtract(lit).mask[PATCH].mean() > 0.9 * 255
    assert watch(background, lit, 2.3, said_to_be_a_person)[PATCH].mean() < 0.03
    assert watch(background, plain, 2.3, said_to_be_a_person)[PATCH].mean() < 0.03


def test_somebody_who_stands_in_a_patch_is_kept_when_the_sun_comes_out() -> None:
    background = learnt()
    where = np.s_[50:130, 50:70]
    mask = watch(background, scene(sunlit(), True, 9, where), 10.0, covering(where))
    assert mask[where].mean() > 0.75
    mask[40:140, 45:75] = False
    assert mask.mean() < 0.01


def test_what_darkens_for_a_moment_only_as_shadows_of_walkers_do_is_not_learnt() -> None:
    background = learnt()
    watch(background, scene(sunlit(0.6, 0.6, 0.6), seed=9), 1.2)
    assert not background.subtract(scene(np.ones(SHAPE[:2]), seed=10)).mask.any()


def with_shadow(picture: Picture, person: slice) -> Picture:
    """Somebody in dark clothes without detail in some columns, and the shadow beside."""
    shaded = picture.copy()
    rows, beside = slice(60, 180), slice(person.stop, person.stop + 32)
    shaded[rows, person] = 45
    shaded[rows, beside] = (shaded[rows, beside] * 0.6).astype(np.uint8)
    return shaded


def crowd_walks_in(background: BackgroundModel) -> tuple[Picture, Picture]:
    """One after the other; their picture, and where they are."""
    picture, people = scene(np.ones(SHAPE[:2]), seed=9), np.zeros(SHAPE[:2], np.uint8)
    for left in (16, 96, 176, 256):
        picture = with_shadow(picture, slice(left, left + 32))
        people[60:180, left : left + 32] = 255
        watch(background, picture, 0.3, people)
    return picture, people


def test_a_crowd_that_walks_in_with_its_shadows_is_no_change_of_light() -> None:
    background = learnt()
    picture, people = crowd_walks_in(background)
    assert background.subtract(picture).mask[people > 0].mean() > 0.97 * 255


@pytest.mark.parametrize("seed", range(8))
def test_clothes_that_keep_still_are_no_patch_of_light(seed: int) -> None:
    random = np.random.default_rng(seed)
    picture = scene(np.ones(SHAPE[:2]))
    weave = np.kron(random.normal(0, 1, (60, 20)), np.ones((2, 2)))[..., None]
    picture[PERSON] = np.clip(random.uniform(30, 200, 3) + 10 * weave, 0, 255).astype(np.uint8)
    still_s = np.where(covering(PERSON) > 0, np.float32(9), np.float32(0))
    background = scene(np.ones(SHAPE[:2]), seed=2)
    assert patches_of_light(picture, background, still_s, (0.8, 1.6)) is None
