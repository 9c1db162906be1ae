"""The background: learnt, followed and subtracted."""

from __future__ import annotations

import cv2
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel, ForegroundSettings
from tracking.foreground.gain import brightness_ratio

FPS = 20.0
PERSON = (slice(20, 60), slice(40, 60))

Picture = NDArray[np.uint8]


def textured(seed: int = 1, low: int = 60, high: int = 180) -> Picture:
    random = np.random.default_rng(seed)
    rough = random.integers(low, high, (12, 16, 3)).astype(np.uint8)
    return np.asarray(cv2.resize(rough, (128, 96), interpolation=cv2.INTER_CUBIC), np.uint8)


def with_person(picture: Picture, where: tuple[slice, slice] = PERSON) -> Picture:
    changed = picture.copy()
    changed[where] = (200, 30, 40)
    return changed


def dimmed(picture: Picture, factor: float) -> Picture:
    return np.asarray(cv2.convertScaleAbs(picture, alpha=factor), np.uint8)


def watch(model: BackgroundModel, picture: Picture, seconds: float, people: Picture | None) -> None:
    for _ in range(round(seconds * FPS)):
        model.update(model.subtract(picture), people)


def test_an_empty_scene_has_no_foreground() -> None:
    model = BackgroundModel(FPS)
    watch(model, textured(), 1.0, None)
    assert not model.subtract(textured()).mask.any()


def test_what_was_not_there_before_is_foreground() -> None:
    model = BackgroundModel(FPS)
    watch(model, textured(), 1.0, None)
    mask = model.subtract(with_person(textured())).mask
    assert (mask[PERSON] > 0).mean() > 0.9
    mask[PERSON] = 0
    assert (mask > 0).mean() < 0.02


def test_a_person_who_stands_still_does_not_melt_within_a_minute() -> None:
    model = BackgroundModel(FPS)
    scene = textured()
    watch(model, scene, 1.0, None)
    standing = np.zeros(scene.shape[:2], np.uint8)
    standing[PERSON] = 255
    watch(model, with_person(scene), 60.0, standing)
    assert (model.subtract(with_person(scene)).mask[PERSON] > 0).mean() > 0.9


def test_a_ghost_is_gone_after_a_few_seconds() -> None:
    model = BackgroundModel(FPS)
    model.learn([with_person(textured())])
    assert model.subtract(textured()).mask.any()
    watch(model, textured(), 4.0, None)
    assert not model.subtract(textured()).mask.any()


def test_a_change_of_exposure_is_no_foreground() -> None:
    model = BackgroundModel(FPS)
    watch(model, textured(), 1.0, None)
    darker = dimmed(textured(), 0.8)
    assert (model.subtract(darker).mask > 0).mean() < 0.01


def test_exposure_that_comes_and_goes_leaves_the_background_as_it_was() -> None:
    model = BackgroundModel(FPS)
    model.learn([textured()])
    for factor in (1.7, 1.5, 1.3, 1.15, 1.05, 1.0):
        watch(model, dimmed(textured(), factor), 0.2, None)
    assert not model.subtract(textured()).mask.any()


def test_a_strange_first_frame_is_forgotten_at_once() -> None:
    model = BackgroundModel(FPS)
    strange = np.full((96, 128, 3), 255, np.uint8)
    strange[:, :12] = 0
    watch(model, strange, 1 / FPS, None)
    watch(model, textured(), 1.0, None)
    assert not model.subtract(textured()).mask.any()


def test_overexposed_pictures_say_that_the_scene_changed_instead_of_showing_people() -> None:
    model = BackgroundModel(FPS)
    model.learn([textured()])
    seen = model.subtract(dimmed(textured(), 2.4))
    assert seen.scene_changed
    assert not seen.mask.any()


def test_whoever_stands_there_while_most_of_the_light_goes_out_is_not_learnt() -> None:
    model = BackgroundModel(FPS)
    model.learn([textured(low=100, high=220)])
    dark = dimmed(textured(low=100, high=220), 0.4)
    watch(model, with_person(dark), 4.0, None)
    assert (model.subtract(with_person(dark)).mask[PERSON] > 0).mean() > 0.9
    seen = model.subtract(dark)
    assert not seen.scene_changed
    assert (seen.mask > 0).mean() < 0.01


def test_the_background_is_learnt_although_people_stand_everywhere_at_times() -> None:
    pictures = []
    for i in range(12):
        left = 8 + 9 * i
        pictures.append(with_person(textured(), (slice(10, 80), slice(left, left + 30))))
    model = BackgroundModel(FPS)
    model.learn(pictures)
    assert not model.subtract(textured()).mask.any()


def test_where_somebody_stood_for_most_of_the_time_the_scene_is_put_back() -> None:
    scene = textured()
    stood = np.zeros(scene.shape[:2], np.uint8)
    stood[PERSON] = 255
    model = BackgroundModel(FPS)
    other = model.learn_both_modes([with_person(scene)] * 9 + [scene] * 6)
    assert (model.subtract(scene).mask[PERSON] > 0).mean() > 0.9
    model.restore_secondary(other, stood)
    assert not model.subtract(scene).mask.any()
    assert (model.subtract(with_person(scene)).mask[PERSON] > 0).mean() > 0.9


def test_where_the_scene_was_seen_most_and_nobody_stood_nothing_is_put_back() -> None:
    scene = textured()
    plain, asked = BackgroundModel(FPS), BackgroundModel(FPS)
    plain.learn([scene] * 9 + [with_person(scene)] * 6)
    other = asked.learn_both_modes([scene] * 9 + [with_person(scene)] * 6)
    assert other.where[PERSON].all()
    asked.restore_secondary(other, np.zeros(scene.shape[:2], np.uint8))
    np.testing.assert_array_equal(asked.background, plain.background)
    np.testing.assert_array_equal(asked.limit, plain.limit)
    assert not asked.subtract(scene).mask.any()


def test_what_stood_where_the_scene_was_put_back_is_absorbed_no_sooner_than_anything() -> None:
    scene, everywhere = textured(), np.full((96, 128), 255, np.uint8)
    plain, mended = (BackgroundModel(FPS, ForegroundSettings(absorb_s=2.0)) for _ in range(2))
    plain.learn([scene])
    other = mended.learn_both_modes([with_person(scene)] * 9 + [scene] * 6)
    mended.restore_secondary(other, everywhere)
    for _ in range(round(4 * FPS)):
        seen = [model.subtract(with_person(scene)) for model in (plain, mended)]
        assert seen[0].mask[PERSON].any() == seen[1].mask[PERSON].any()
        for model, picture in zip((plain, mended), seen, strict=True):
            model.update(picture)


def test_what_passes_by_is_no_other_look_of_the_scene() -> None:
    places = [(slice(10, 80), slice(8 + 20 * i, 22 + 20 * i)) for i in range(5)]
    pictures = [with_person(textured(), place) for place in places]
    assert not BackgroundModel(FPS).learn_both_modes(pictures + [textured()] * 4).where.any()


@settings(max_examples=30, deadline=None)
@given(factor=st.floats(0.6, 1.4), seed=st.integers(0, 50))
def test_the_brightness_ratio_is_the_factor_of_light(factor: float, seed: int) -> None:
    picture = textured(seed, 60, 160)
    assert abs(brightness_ratio(dimmed(picture, factor), picture) - factor) < 0.02


def test_a_picture_too_dark_to_compare_keeps_its_brightness() -> None:
    dark = np.full((96, 128, 3), 3, np.uint8)
    assert brightness_ratio(dark, textured()) == 1.0
