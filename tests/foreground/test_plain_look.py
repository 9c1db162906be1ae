"""Spots of who stood before a plain scene are drawn over in its other look; nothing else is."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.foreground import OtherLook, without_spots

ROWS, COLUMNS = 60, 80
STOOD = np.s_[10:50, 30:50]
SPOT, EDGE = np.s_[20:24, 38:42], np.s_[10:50, 29:30]
Picture = NDArray[np.uint8]


def look_of(scene: Picture) -> OtherLook:
    """A scene where somebody stood; at a spot and an edge nearly alike, no other look is known."""
    picture, where = scene.copy(), np.zeros((ROWS, COLUMNS), np.uint8)
    where[STOOD] = 255
    where[SPOT] = 0
    for left_over in (SPOT, EDGE):
        picture[left_over] = 100
    return OtherLook(picture, where)


def plain() -> Picture:
    return np.full((ROWS, COLUMNS, 3), 115, np.uint8)


def test_spots_and_edges_of_who_stood_before_a_plain_scene_are_drawn_over() -> None:
    whole = without_spots(look_of(plain()))
    np.testing.assert_array_equal(whole.picture, plain())
    assert whole.where[STOOD].all()
    assert whole.where[EDGE].all()


def test_a_scene_with_something_on_it_is_left_as_it_is() -> None:
    random = np.random.default_rng(1)
    look = look_of(random.integers(60, 180, (ROWS, COLUMNS, 3)).astype(np.uint8))
    whole = without_spots(look)
    np.testing.assert_array_equal(whole.picture, look.picture)
    np.testing.assert_array_equal(whole.where, look.where)


def test_another_thing_beside_who_stood_there_is_left_as_it_is() -> None:
    scene = plain()
    scene[:, 50:] = 30
    look = look_of(scene)
    assert (without_spots(look).picture[:, 50:] == 30).all()
    assert not without_spots(look).where[:, 50:].any()


@pytest.mark.parametrize("where", [0, 255])
def test_a_look_that_is_nowhere_or_everywhere_another_stays(where: int) -> None:
    look = OtherLook(plain(), np.full((ROWS, COLUMNS), where, np.uint8))
    whole = without_spots(look)
    np.testing.assert_array_equal(whole.picture, look.picture)
    np.testing.assert_array_equal(whole.where, look.where)
