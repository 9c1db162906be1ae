"""Lines between parts, and their inner rectangles."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tracking.people.parts import decompose, inner_rectangle, inner_rectangles
from tracking.people.parts.lines import START

Floats = NDArray[np.float64]
HEIGHT, WIDTH = 200, 60
BOX = np.array([19.5, 19.5, WIDTH, HEIGHT], float)


def dressed(neck: float, hip: float) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Mask and picture of an upright person with colours that change at these shares."""
    mask = np.zeros((240, 100), np.uint8)
    mask[20 : 20 + HEIGHT, 20 : 20 + WIDTH] = 255
    picture = np.zeros((240, 100, 3), np.uint8)
    edges = [0, 20 + round(neck * HEIGHT), 20 + round(hip * HEIGHT), 240]
    for k, colour in enumerate(((60, 140, 160), (200, 110, 120), (90, 150, 90))):
        picture[edges[k] : edges[k + 1]] = colour
    return mask, picture


@pytest.mark.parametrize(("neck", "hip"), [(0.15, 0.48), (0.13, 0.44), (0.175, 0.53)])
def test_lines_go_where_the_colours_change(neck: float, hip: float) -> None:
    lines = decompose(*dressed(neck, hip), BOX)
    assert np.allclose(lines, [20 + neck * HEIGHT, 20 + hip * HEIGHT], atol=1)


def test_a_line_that_strays_goes_back_to_its_start() -> None:
    # The colours part best half-way down a slow change that goes on to the knees.
    mask, picture = dressed(0.15, 0.48)
    shares = (np.arange(240) - 20) / HEIGHT
    picture[:] = 128
    picture[..., 0] = (60 + 140 * np.clip((shares - 0.45) / 0.35, 0, 1))[:, None]
    lines = decompose(mask, picture, BOX)
    assert lines[1] == pytest.approx(19.5 + START[1] * HEIGHT, abs=1)


def test_lines_of_somebody_in_one_colour_stay_at_their_start() -> None:
    mask, picture = dressed(0.15, 0.48)
    lines = decompose(mask, np.full_like(picture, 100), BOX)
    assert np.allclose(lines, 19.5 + np.array(START) * HEIGHT, atol=1)


@settings(max_examples=40, deadline=None)
@given(
    st.integers(0, 10_000),
    st.tuples(st.floats(-80, 200), st.floats(-150, 300), st.floats(2, 150), st.floats(2, 300)),
)
def test_lines_lie_in_order_inside_the_box_whatever_is_seen(
    seed: int, box: tuple[float, float, float, float]
) -> None:
    rng = np.random.default_rng(seed)
    mask = (rng.random((240, 100)) < 0.4).astype(np.uint8)
    picture = rng.integers(0, 256, (240, 100, 3), np.uint8)
    lines = decompose(mask, picture, np.array(box))
    assert box[1] - 1 <= lines[0] <= lines[1] <= box[1] + box[3] + 1


def test_the_inner_rectangle_is_the_mass_centre_and_the_spread() -> None:
    mask = np.zeros((50, 50), np.bool_)
    mask[10:20, 20:40] = True
    cx, cy, width, height = inner_rectangle(mask, np.array([0.0, 0, 50, 50]))
    assert (cx, cy) == (29.5, 14.5)
    assert width == pytest.approx(2 * np.std(np.arange(20)))
    assert height == pytest.approx(2 * np.std(np.arange(10)))


def test_nothing_seen_gives_no_rectangle() -> None:
    assert np.isnan(inner_rectangle(np.zeros((20, 20), np.bool_), np.array([0, 0, 20, 20]))).all()


def test_the_hip_leg_takes_the_upper_half_of_its_section() -> None:
    mask, _ = dressed(0.15, 0.48)
    lines = np.array([50.0, 120.0])
    rectangles = inner_rectangles(mask, BOX, lines)
    assert rectangles[2, 3] == pytest.approx((219.5 - 120) / 2)
    assert 120 < rectangles[2, 1] < 120 + rectangles[2, 3]
    assert np.isfinite(rectangles).all()
