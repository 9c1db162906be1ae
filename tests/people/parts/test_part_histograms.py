"""Histograms of parts: equalised, counted by sums, compared."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tracking.people.parts import (
    bhattacharyya,
    candidate_histograms,
    equalisation,
    equalised,
    even_division,
    level_histograms,
    similarities,
)

SIZE = (40, 60)


def picture(seed: int, size: tuple[int, int] = SIZE) -> NDArray[np.uint8]:
    return np.random.default_rng(seed).integers(0, 256, (*size, 3), np.uint8)


def models(rng: np.random.Generator, count: int) -> NDArray[np.float32]:
    return rng.dirichlet(np.full(256, 0.1), (count, 3)).astype(np.float32)


rectangles = st.tuples(
    st.floats(-20, 80), st.floats(-20, 60), st.floats(0.5, 50), st.floats(0.5, 50)
)


@settings(max_examples=40, deadline=None)
@given(st.lists(rectangles, min_size=1, max_size=12), st.integers(0, 1000))
def test_sums_over_a_table_count_what_pixels_show(
    drawn: list[tuple[float, float, float, float]], seed: int
) -> None:
    rng = np.random.default_rng(seed)
    shown, asked = picture(seed), np.array(drawn)
    owner = rng.integers(0, 3, len(asked))
    mapping = equalisation(models(rng, 3))
    counted = equalised(level_histograms(shown, asked), mapping[owner])
    assert np.allclose(candidate_histograms(shown, asked, owner, mapping), counted, atol=1e-6)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10_000))
def test_the_mapping_keeps_the_order_of_levels_and_evens_the_reference_out(seed: int) -> None:
    reference = models(np.random.default_rng(seed), 2)
    mapping = equalisation(reference)
    assert (np.diff(mapping.astype(int), axis=-1) >= 0).all()
    # A bin holds its eighth but for one level at either side that cannot be divided.
    largest = np.repeat(reference.max(axis=-1), 8, axis=-1).reshape(2, 24)
    assert (np.abs(equalised(reference, mapping) - 1 / 8) <= largest + 1e-5).all()


def test_an_empty_reference_divides_the_levels_evenly() -> None:
    assert (equalisation(np.zeros((1, 3, 256), np.float32)) == even_division(1)).all()


def test_equalisation_tells_dull_colours_apart_that_even_bins_hold_for_one() -> None:
    dark, darker = picture(0) % 16, picture(1) % 16 + 14
    where = np.array([[30.0, 20.0, 30.0, 20.0]])
    model, other = level_histograms(dark, where), level_histograms(darker, where)
    alike = {
        name: float(bhattacharyya(equalised(model, by), equalised(other, by))[0])
        for name, by in (("equalised", equalisation(model)), ("even", even_division(1)))
    }
    assert alike["even"] > 0.8
    assert alike["equalised"] < 0.5


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 1000))
def test_a_part_is_wholly_like_itself_and_likeness_lies_between_0_and_1(seed: int) -> None:
    rng = np.random.default_rng(seed)
    shown = picture(seed)
    parts = np.column_stack((rng.uniform(10, 30, (4, 2)), rng.uniform(4, 20, (4, 2))))
    alike = similarities(shown, parts, np.arange(4), level_histograms(shown, parts))
    assert np.allclose(alike, 1, atol=1e-6)
    assert (alike <= 1).all()
    others = np.roll(np.arange(4), 1)
    away = similarities(shown, parts, others, level_histograms(shown, parts))
    assert ((away >= 0) & (away <= 1)).all()


def test_what_lies_outside_the_picture_or_nowhere_is_like_nothing() -> None:
    shown = picture(3)
    asked = np.array([[-50.0, 10, 8, 8], [np.nan] * 4, [30.0, 20, 8, 8]])
    model = level_histograms(shown, asked[2:])
    alike = similarities(shown, asked, np.zeros(3, int), model)
    assert alike[:2].tolist() == [0, 0]
    assert alike[2] == np.float32(1) or np.isclose(alike[2], 1)


def test_rectangles_with_more_pixels_than_a_counter_holds_are_thinned_out() -> None:
    plain = np.zeros((600, 700, 3), np.uint8)
    plain[:, 350:] = 200
    asked = np.array([[349.5, 299.5, 700.0, 600.0]])
    found = candidate_histograms(plain, asked, np.zeros(1, int), even_division(1))
    assert np.allclose(found.reshape(3, 8)[:, [0, 6]], 0.5, atol=0.01)
