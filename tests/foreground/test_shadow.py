"""Shadows are told from people by texture and hue."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.foreground import ForegroundSettings, ShadowRemover, Subtraction

PLACE = (slice(30, 70), slice(40, 100))


def floor(grey: bool = False) -> NDArray[np.uint8]:
    random = np.random.default_rng(3)
    rough = random.integers(110, 190, (24, 32, 1)).astype(np.uint8)
    fine = cv2.resize(rough, (128, 96), interpolation=cv2.INTER_CUBIC)[..., None]
    tint = np.array((1, 1, 1) if grey else (0.85, 0.95, 1.0))
    return np.asarray((fine * tint).astype(np.uint8))


def subtraction(picture: NDArray[np.uint8], background: NDArray[np.uint8]) -> Subtraction:
    mask = np.zeros(picture.shape[:2], np.uint8)
    mask[PLACE] = 255
    return Subtraction(picture, background, mask, False)


def shadow_share(picture: NDArray[np.uint8], background: NDArray[np.uint8]) -> float:
    found = ShadowRemover().shadows(subtraction(picture, background))
    return float((found[PLACE] == 255).mean())


@pytest.mark.parametrize("grey", [False, True])
@pytest.mark.parametrize("light", [0.45, 0.6, 0.8])
def test_a_dimmed_floor_is_shadow(light: float, grey: bool) -> None:
    picture = floor(grey)
    picture[PLACE] = (picture[PLACE] * light).astype(np.uint8)
    assert shadow_share(picture, floor(grey)) > 0.9


def test_clothes_of_another_colour_are_no_shadow() -> None:
    picture = floor()
    picture[PLACE] = (120, 60, 30)
    assert shadow_share(picture, floor()) < 0.05


def test_plain_grey_clothes_on_a_grey_textured_floor_are_mostly_no_shadow() -> None:
    picture = floor(grey=True)
    picture[PLACE] = 90
    assert shadow_share(picture, floor(grey=True)) < 0.5


def test_what_is_brighter_than_the_floor_is_no_shadow() -> None:
    picture = floor()
    picture[PLACE] = np.minimum(picture[PLACE] * 1.25, 255).astype(np.uint8)
    assert shadow_share(picture, floor()) == 0


def test_what_is_darker_than_any_shadow_is_none() -> None:
    picture = floor()
    picture[PLACE] = (picture[PLACE] * 0.1).astype(np.uint8)
    assert shadow_share(picture, floor()) == 0


def test_without_foreground_there_is_no_shadow() -> None:
    empty = Subtraction(floor(), floor(), np.zeros((96, 128), np.uint8), False)
    assert not ShadowRemover().shadows(empty).any()


def test_a_score_is_the_constant_where_nothing_but_the_light_changed() -> None:
    settings = ForegroundSettings()
    even = np.full((40, 40, 3), 160, np.uint8)
    dim = np.full((40, 40, 3), 100, np.uint8)
    weight = 1 - settings.shadow_texture - settings.shadow_hue
    theta = ShadowRemover(settings).score(dim, even)
    np.testing.assert_allclose(theta, weight * settings.shadow_constant, atol=1e-6)


def test_a_speck_of_foreground_is_scored_too() -> None:
    seen = subtraction((floor() * 0.6).astype(np.uint8), floor())
    seen.mask[:] = 0
    seen.mask[11:13, 21:24] = 255
    seen.mask[95:, 126:] = 255
    shadow = ShadowRemover().shadows(seen)
    assert not shadow[seen.mask == 0].any()


@pytest.mark.parametrize("part", [np.s_[40:41, 10:60], np.s_[10:60, 41:42], np.s_[7:8, 9:10]])
def test_a_line_of_foreground_and_a_single_pixel_are_scored(part: tuple[slice, slice]) -> None:
    picture = np.full((80, 80, 3), 90, np.uint8)
    background = np.full((80, 80, 3), 140, np.uint8)
    mask = np.zeros((80, 80), np.uint8)
    mask[part] = 255
    shadow = ShadowRemover().shadows(Subtraction(picture, background, mask, False))
    assert not shadow[mask == 0].any()
    assert (shadow[part] == 255).all()
