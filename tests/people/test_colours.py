"""Colour histograms of regions."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.people import PeopleSettings
from tracking.people.colours import colour_histograms

SETTINGS = PeopleSettings()
BOX = (10, 10, 20, 60)


def clothes(upper: tuple[int, int, int], lower: tuple[int, int, int]) -> np.ndarray:
    picture = np.zeros((90, 50, 3), np.uint8)
    picture[:] = (0, 255, 255)
    picture[10:40, 10:30] = upper
    picture[40:70, 10:30] = lower
    return picture


def labels() -> np.ndarray:
    region = np.zeros((90, 50), np.uint8)
    region[10:70, 10:30] = 1
    return region


def test_shirt_and_trousers_are_told_apart() -> None:
    upper, lower, _ = colour_histograms(
        clothes((255, 0, 0), (0, 0, 255)), labels(), [BOX], SETTINGS
    )
    assert upper[0].argmax() == 120 * SETTINGS.hue_bins // 180
    assert lower[0].argmax() == 0
    assert upper[0].max() > 0.99
    assert lower[0].max() > 0.99


def test_hues_count_by_how_strong_they_are_or_each_pixel_alike() -> None:
    picture = clothes((178, 178, 255), (178, 178, 255))  # pale red
    picture[16:40:12, 10:30] = picture[40:70:12, 10:30] = (255, 255, 0)  # a few lines of cyan
    cyan = 90 * SETTINGS.hue_bins // 180
    counted, weighed = (
        colour_histograms(picture, labels(), [BOX], PeopleSettings(hue_by_saturation=by))[0][0]
        for by in (False, True)
    )
    rows = picture[19:40, 20, 0] == 255  # of the upper body, whose topmost pixels are left out
    np.testing.assert_allclose(counted[[0, cyan]], [1 - rows.mean(), rows.mean()], atol=0.01)
    assert weighed[cyan] > 2 * counted[cyan]
    np.testing.assert_allclose(weighed.sum(), 1.0, rtol=1e-6)


def test_only_the_regions_own_pixels_count() -> None:
    region = labels()
    region[:, 20:] = 0
    picture = clothes((255, 0, 0), (255, 0, 0))
    picture[:, 20:] = (0, 255, 0)
    upper, lower, middle = colour_histograms(picture, region, [BOX], SETTINGS)
    assert min(upper[0].max(), lower[0].max(), middle[0].max()) > 0.99


def test_a_region_without_pixels_has_even_histograms() -> None:
    upper, lower, middle = colour_histograms(
        clothes((9, 9, 9), (9, 9, 9)), np.zeros((90, 50), np.uint8), [(0, 0, 0, 0)], SETTINGS
    )
    for histogram in (upper, lower, middle):
        np.testing.assert_allclose(histogram, 1 / histogram.shape[1])


@settings(max_examples=30, deadline=None)
@given(seed=st.integers(0, 1000), hue_bins=st.integers(4, 64), saturation_bins=st.integers(1, 16))
def test_histograms_sum_to_one(seed: int, hue_bins: int, saturation_bins: int) -> None:
    random = np.random.default_rng(seed)
    picture = random.integers(0, 256, (90, 50, 3))
    chosen = PeopleSettings(hue_bins=hue_bins, saturation_bins=saturation_bins)
    for histogram in colour_histograms(picture.astype(np.uint8), labels(), [BOX], chosen):
        np.testing.assert_allclose(histogram.sum(axis=1), 1, rtol=1e-4)
