"""The colour of shade, learnt from shadows that are certain."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.foreground import ShadeColour, Subtraction

LEFT = np.array([0.7, 0.6, 0.5])
"""Share of blue, green and red light that the shade leaves."""


def scene(seed: int = 0) -> Subtraction:
    """Background, and the picture with shade to the left, half-shade, and a coat to the right."""
    background = np.random.default_rng(seed).integers(90, 220, (60, 90, 3)).astype(np.float64)
    picture = background.copy()
    picture[:, :30] *= LEFT
    picture[:, 30:60] *= (1 + LEFT) / 2
    picture[:, 60:] *= 1.1 - LEFT
    mask = np.full((60, 90), 255, np.uint8)
    return Subtraction(picture.astype(np.uint8), background.astype(np.uint8), mask, False)


def everywhere() -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    return np.nonzero(np.ones((60, 90), np.bool_))


def taught(seen: Subtraction) -> ShadeColour:
    shade = ShadeColour()
    certain = np.zeros((60, 90), np.uint8)
    certain[:, :30] = 255
    shade.follow(seen, certain)
    return shade


def test_shade_and_half_shade_are_known_again_and_a_coat_is_neither() -> None:
    seen = scene()
    alike = taught(seen).alike(seen, *everywhere()).reshape(60, 90)
    assert alike[:, :60].mean() > 0.95
    assert alike[:, 60:].mean() < 0.05


def test_nothing_is_like_shade_before_any_was_seen() -> None:
    seen = scene()
    assert not ShadeColour().alike(seen, *everywhere()).any()


def test_a_few_pixels_of_shadow_teach_nothing() -> None:
    seen, shade = scene(), ShadeColour()
    few = np.zeros((60, 90), np.uint8)
    few[:8, :8] = 255
    shade.follow(seen, few)
    assert not shade.alike(seen, *everywhere()).any()
