"""Clouds and light differ from the background and have no outline; people have one."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.people.ghosts import without_ghosts

SIZE = 240, 320
FULL = 60
THRESHOLD = 18

Picture = NDArray[np.uint8]


def _wall() -> Picture:
    rough = np.random.default_rng(8).integers(120, 150, (*SIZE, 3)).astype(np.uint8)
    return np.asarray(cv2.blur(rough, (3, 3)), np.uint8)


def _shown(amount: NDArray[np.float32]) -> tuple[Picture, NDArray[np.uint8]]:
    """The wall darker by an amount (height, width) in grey levels, and the foreground in it."""
    wall = _wall()
    picture = np.clip(wall - amount[..., None], 0, 255).astype(np.uint8)
    return picture, (amount > THRESHOLD).view(np.uint8)


def _blob(middle: tuple[int, int], blur_px: int) -> NDArray[np.float32]:
    amount = np.zeros(SIZE, np.float32)
    cv2.ellipse(amount, middle, (40, 68), 0, 0, 360, FULL, -1)
    return np.asarray(cv2.blur(amount, (blur_px, blur_px)), np.float32)


def _kept(picture: Picture, regions: NDArray[np.uint8], *, floor_known: bool = False) -> int:
    return int(without_ghosts(regions, picture, _wall(), floor_known=floor_known).max())


@pytest.mark.parametrize(("blur_px", "people"), [(3, 1), (7, 1), (51, 0), (71, 0)])
def test_what_fades_into_the_background_is_nobody(blur_px: int, people: int) -> None:
    assert _kept(*_shown(_blob((160, 120), blur_px))) == people


def test_where_no_outline_is_asked_for_it_is_somebody() -> None:
    assert _kept(*_shown(_blob((160, 120), 51)), floor_known=True) == 1


def test_a_cloud_that_ends_at_a_roof_is_nobody() -> None:
    cloud = _blob((160, 120), 61)
    cloud[140:] = 0
    assert _kept(*_shown(cloud)) == 0


def test_somebody_between_others_who_touch_is_somebody() -> None:
    amount = np.zeros(SIZE, np.float32)
    amount[30:100, 40:100] = FULL
    picture, foreground = _shown(np.asarray(cv2.blur(amount, (3, 3)), np.float32))
    regions = foreground.copy()
    regions[:, 60:] *= 2
    regions[:, 80:] //= 2
    regions[:, 80:] *= 3
    assert np.unique(regions).tolist() == [0, 1, 2, 3]
    assert _kept(picture, regions) == 3
