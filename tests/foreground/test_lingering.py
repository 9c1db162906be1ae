"""The background where people linger: learnt and kept without them, over a whole recording."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel, Subtraction, background
from tracking.foreground.background_modes import primary_mode
from tracking.foreground.difference import largest_difference
from tracking.foreground.gain import channel_ratios

FPS = 10.0
HEIGHT, WIDTH = 96, 160
COUNT, EVERY_S, MOMENT_S = 15, 2.0, 0.4
LINGERING = 9
"""Of 15 looks at the scene somebody in dark clothes stands in so many, on end."""
STOOL = np.s_[60:84, 120:136]
TORSO = np.s_[34:66, 66:82]

Picture = NDArray[np.uint8]


def floor() -> Picture:
    rough = np.random.default_rng(3).integers(100, 170, (12, 20, 3)).astype(np.uint8)
    return np.asarray(cv2.resize(rough, (WIDTH, HEIGHT), interpolation=cv2.INTER_CUBIC), np.uint8)


def at(time_s: float, lingers: bool, stool: bool = False) -> Picture:
    """The scene, with somebody who sways about one place and moves the legs, and a stool."""
    picture = floor()
    if stool:
        picture[STOOL] = (60, 90, 30)
    if lingers:
        sway, step = 4 * np.sin(1.9 * time_s), 7 * np.sin(2.6 * time_s)
        for centre, axes in (
            ((74 + sway, 50), (13, 22)),
            ((69 + sway + step, 80), (4, 14)),
            ((79 + sway - step, 80), (4, 14)),
        ):
            middle = tuple(round(float(each)) for each in centre)
            cv2.ellipse(picture, (middle, (2 * axes[0], 2 * axes[1]), 0), (35, 30, 30), -1)
    return picture


def looks(
    times_s: NDArray[np.float64], stool_from_s: float = np.inf, lingering: int = LINGERING
) -> list[Picture]:
    first = 4 * EVERY_S
    last = first + lingering * EVERY_S
    return [at(t, first <= t < last, t >= stool_from_s) for t in times_s]


TIMES_S = EVERY_S * np.arange(COUNT)


@pytest.mark.parametrize("lingering", [LINGERING, 11])
def test_who_lingers_for_most_of_the_time_is_not_learnt_as_background(lingering: int) -> None:
    """Without what tells motion near by, 5 % of the scene are a torso after 11 of 15 looks."""
    first, then = (looks(times, lingering=lingering) for times in (TIMES_S, TIMES_S + MOMENT_S))
    learnt, _ = primary_mode(first, then)
    unaware, _ = primary_mode(first)
    assert (largest_difference(learnt, floor()) > 12).mean() < 0.001
    if lingering > LINGERING:
        assert (largest_difference(unaware, floor()) > 12).mean() > 0.04


def test_a_picture_of_nobody_at_the_ends_outweighs_one_that_stays_for_a_while() -> None:
    """Even where nothing is known of what moves."""
    somebody = floor()
    somebody[TORSO] = 30
    pictures = [floor()] * 3 + [somebody] * 7 + [floor()] * 3
    learnt, _ = primary_mode(pictures)
    assert (largest_difference(learnt, floor()) > 12).mean() < 0.001


def learnt(stool_from_s: float = np.inf) -> BackgroundModel:
    model = BackgroundModel(FPS)
    pictures, later = (looks(times, stool_from_s) for times in (TIMES_S, TIMES_S + MOMENT_S))
    model.learn(pictures, later, list(TIMES_S))
    return model


def follow(model: BackgroundModel, picture: Picture, from_s: float, seconds: float) -> Picture:
    """The mask at the end."""
    for k in range(round(seconds * FPS)):
        seen = model.subtract(picture, from_s + k / FPS)
        model.update(seen)
    return seen.mask


def test_who_stands_still_for_a_while_and_is_not_followed_does_not_melt() -> None:
    model = learnt()
    mask = follow(model, at(9.0, lingers=True), 9.0, 8.0)
    assert (mask[TORSO] > 0).mean() > 0.98


def test_what_was_put_there_and_stays_is_background_soon() -> None:
    model = learnt(stool_from_s=18.0)
    before = follow(model, at(18.0, lingers=False, stool=True), 18.0, 2.0)
    after = follow(model, at(20.0, lingers=False, stool=True), 20.0, 4.0)
    assert (before[STOOL] > 0).mean() > 0.9
    assert (after[STOOL] > 0).mean() < 0.02


def test_what_no_other_time_shows_is_background_at_last() -> None:
    model = learnt()
    mask = follow(model, at(6.0, lingers=False, stool=True), 6.0, 34.0)
    assert (mask[STOOL] > 0).mean() < 0.02


def tinted(picture: Picture, gains: tuple[float, float, float]) -> Picture:
    return np.clip(picture * np.array(gains), 0, 255).astype(np.uint8)


@pytest.mark.parametrize("gains", [(1.25, 1.0, 0.7), (0.8, 0.95, 1.3)])
def test_a_white_balance_that_settles_is_no_foreground(gains: tuple[float, float, float]) -> None:
    model = learnt()
    seen = model.subtract(tinted(floor(), gains), 0.0)
    assert not seen.mask.any()
    assert not seen.scene_changed
    somebody = model.subtract(tinted(at(6.0, lingers=True), gains), 0.1)
    assert (somebody.mask[TORSO] > 0).mean() > 0.9


def test_without_ratios_by_channel_it_is_another_scene_in_which_nobody_is_seen(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(background, "channel_ratios", lambda *_: np.ones(3, np.float32))
    seen = learnt().subtract(tinted(at(6.0, lingers=True), (1.25, 1.0, 0.7)), 0.0)
    assert seen.scene_changed
    assert not seen.mask[TORSO].any()


def test_people_in_red_clothes_are_no_white_balance() -> None:
    crowd = floor()
    crowd[:, : int(0.45 * WIDTH), 2] += 60
    assert np.allclose(channel_ratios(crowd, floor()), 1.0, atol=0.02)


def _after_the_light_has_changed(kind: str) -> tuple[Subtraction, Picture]:
    """What is foreground in the end, and what the floor looks like then."""
    change_s = 20.0

    def lit(picture: Picture, time_s: float) -> Picture:
        if time_s < change_s:
            return picture
        light = picture.astype(np.float32)
        light = 0.3 * light + 150 if kind == "haze" else 255 - 0.8 * light
        return np.asarray(light, np.uint8)

    model = BackgroundModel(FPS)
    pictures, later = (
        [lit(look, t) for look, t in zip(looks(times, lingering=4), times, strict=True)]
        for times in (TIMES_S, TIMES_S + MOMENT_S)
    )
    model.learn(pictures, later, list(TIMES_S))
    for k in range(round(8.0 * FPS)):
        time_s = change_s - 2.0 + k / FPS
        seen = model.subtract(lit(at(time_s, lingers=True), time_s), time_s)
        model.update(seen)
    return seen, lit(floor(), change_s)


@pytest.mark.parametrize("kind", ["haze", "tone"])
def test_after_the_light_has_changed_for_good_nobody_who_is_there_is_learnt(kind: str) -> None:
    seen, empty = _after_the_light_has_changed(kind)
    assert not seen.scene_changed
    assert (seen.mask[TORSO] > 0).mean() > 0.9
    assert (largest_difference(seen.background, empty) > 16).mean() < 0.02


@pytest.mark.parametrize("kind", ["haze", "tone"])
def test_without_learning_anew_nobody_is_seen_any_more(
    monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    monkeypatch.setattr(BackgroundModel, "_begin_anew", lambda *_: None)
    seen, _ = _after_the_light_has_changed(kind)
    assert seen.scene_changed
    assert not seen.mask[TORSO].any()


def test_what_was_overexposed_when_learnt_is_nobody_in_less_light() -> None:
    bright = floor().astype(np.float32)
    bright[:, 110:] = 400.0
    model = BackgroundModel(FPS)
    model.learn([np.asarray(np.clip(bright, 0, 255), np.uint8)] * COUNT)
    dim = np.asarray(np.clip(0.6 * bright, 0, 255), np.uint8)
    assert not model.subtract(dim).mask.any()
    dim[40:80, 120:140] = 30
    mask = model.subtract(dim).mask
    assert (mask[41:79, 121:139] > 0).all()
    assert (mask > 0).mean() < 0.06
