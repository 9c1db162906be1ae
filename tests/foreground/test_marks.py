"""Marks of a scene are found again in another picture of it."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.foreground import Marks

ROWS, COLUMNS = 120, 160
MARKS = Marks(most=50, faintest=0.02, apart_px=10, window_px=15, levels=1)
Picture = NDArray[np.uint8]


def scene() -> Picture:
    rough = np.random.default_rng(3).uniform(0, 255, (ROWS, COLUMNS)).astype(np.float32)
    spots = cv2.GaussianBlur(rough, (0, 0), 3)
    return np.asarray((120 + 5 * (spots - spots.mean())).clip(0, 255), np.uint8)


def shifted(picture: Picture, across_px: float, down_px: float) -> Picture:
    motion = np.array([[1, 0, across_px], [0, 1, down_px]])
    size, border = (COLUMNS, ROWS), cv2.BORDER_REFLECT
    return np.asarray(cv2.warpAffine(picture, motion, size, borderMode=border), np.uint8)


def test_marks_are_so_many_at_most_and_so_far_apart() -> None:
    marks = MARKS.of(scene())
    apart = np.linalg.norm(marks[:, None] - marks[None], axis=2) + 1e3 * np.eye(len(marks))
    assert 20 < len(marks) <= MARKS.most
    assert apart.min() >= MARKS.apart_px


def test_the_strongest_marks_come_first() -> None:
    few = Marks(most=5, faintest=0.02, apart_px=10, window_px=15, levels=1)
    np.testing.assert_array_equal(few.of(scene()), MARKS.of(scene())[:5])


@pytest.mark.parametrize("shift", [(0.0, 0.0), (1.5, -2.25), (14.0, 6.0)])
def test_marks_are_followed_from_where_they_are_thought_to_be(shift: tuple[float, float]) -> None:
    before, now = scene(), shifted(scene(), *shift)
    marks = MARKS.of(before)
    near = marks + np.rint(np.array(shift, np.float32))
    there, found = MARKS.followed(before, now, marks, near)
    inner = found & np.all((marks > 20) & (marks < (COLUMNS - 35, ROWS - 35)), axis=1)
    assert inner.sum() >= 5
    np.testing.assert_allclose((there - marks)[inner], np.tile(shift, (inner.sum(), 1)), atol=0.15)


def test_marks_beyond_another_picture_are_not_found() -> None:
    marks = MARKS.of(scene())
    _, found = MARKS.followed(scene(), scene(), marks, marks + np.float32(1000))
    assert not found.any()


def test_a_plain_picture_has_no_marks_and_none_are_followed_there() -> None:
    plain = np.full((ROWS, COLUMNS), 120, np.uint8)
    none = MARKS.of(plain)
    assert none.shape == (0, 2)
    there, found = MARKS.followed(plain, scene(), none, none)
    assert (there.shape, found.shape) == ((0, 2), (0,))
