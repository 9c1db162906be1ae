"""The colours of clothes."""

from __future__ import annotations

import numpy as np

from tracking.people.colours import clothes_colours

BOX = (20, 10, 30, 80)


def person(upper: tuple[int, int, int], lower: tuple[int, int, int]) -> np.ndarray:
    """A picture (100, 80) of one person in BOX: upper half and lower half, blue, green, red."""
    picture = np.full((100, 80, 3), 77, np.uint8)
    picture[10:50, 20:50] = upper
    picture[50:90, 20:50] = lower
    return picture


def labels() -> np.ndarray:
    marked = np.zeros((100, 80), np.uint8)
    marked[10:90, 20:50] = 1
    return marked


def test_white_over_black_is_light_over_dark() -> None:
    upper, lower = clothes_colours(person((255, 255, 255), (0, 0, 0)), labels(), [BOX])[0]
    np.testing.assert_allclose(upper, (100, 0, 0), atol=0.1)
    np.testing.assert_allclose(lower, (0, 0, 0), atol=0.1)


def test_red_and_blue_lie_apart() -> None:
    upper, lower = clothes_colours(person((0, 0, 255), (255, 0, 0)), labels(), [BOX])[0]
    np.testing.assert_allclose(upper, (53.2, 80.1, 67.2), atol=0.5)
    np.testing.assert_allclose(lower, (32.3, 79.2, -107.9), atol=0.5)


def test_only_a_persons_own_pixels_count() -> None:
    picture, marked = person((0, 0, 255), (255, 0, 0)), labels()
    picture[10:90, 35:50] = (0, 255, 0)
    marked[10:90, 35:50] = 2
    own = clothes_colours(picture, marked, [BOX, (35, 10, 15, 80)])[0, 0]
    np.testing.assert_allclose(own, (53.2, 80.1, 67.2), atol=0.5)


def test_what_does_not_show_is_not_known() -> None:
    marked = labels()
    marked[50:] = 0
    upper, lower = clothes_colours(person((9, 9, 9), (9, 9, 9)), marked, [BOX])[0]
    assert np.isfinite(upper).all()
    assert np.isnan(lower).all()


def test_nobody_has_no_clothes() -> None:
    assert clothes_colours(person((0, 0, 0), (0, 0, 0)), labels() * 0, []).shape == (0, 2, 3)
