"""The rule by which a rectangle lies on a body part."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.tracks.boxes import corners_of_boxes
from tracking.tracks.on_part import corners_of, covered_share, foreign_share, lies_on

PART = np.array([35.0, 40, 65, 90])
numbers = st.floats(-50, 50)


@given(numbers, numbers)
def test_a_rectangle_as_large_as_its_part_is_right_until_half_of_it_is_off(
    dx: float, dy: float
) -> None:
    moved = PART + np.array([dx, dy, dx, dy])
    inside = max(1 - abs(dx) / 30, 0) * max(1 - abs(dy) / 50, 0)
    assert foreign_share(moved, PART) == pytest.approx(1 - inside, abs=1e-9)
    if abs(inside - 0.5) > 1e-6:
        assert lies_on(moved, PART) == (inside > 0.5)


def test_a_dot_and_no_rectangle_at_all_are_wrong() -> None:
    assert not lies_on(np.array([50.0, 60, 51, 61]), PART)
    assert not lies_on(np.full(4, np.nan), PART)
    assert not lies_on(np.array([0.0, 0, 200, 200]), PART)


def test_the_share_that_is_covered_is_of_the_part_and_not_of_the_rectangle() -> None:
    corner = np.array([35.0, 40, 50, 50])
    assert foreign_share(corner, PART) == 0
    assert covered_share(corner, PART) == pytest.approx(15 * 10 / (30 * 50))


def test_middles_and_boxes_are_the_same_corners() -> None:
    assert corners_of(np.array([50.0, 65, 30, 50])).tolist() == PART.tolist()
    assert corners_of_boxes(np.array([35.0, 40, 30, 50])).tolist() == PART.tolist()
