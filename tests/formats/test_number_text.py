"""Columns of numbers as text, against Python's own words for them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_array_equal

from tracking.formats.number_text import (
    chosen,
    constant,
    lines_of,
    numbers,
    short_decimals,
    whole_numbers,
)

LEAST = 2.0**-7
"""Smaller numbers are written by Python itself."""


def as_text(values: list[float]) -> list[str]:
    return lines_of([numbers(np.array(values), b"-1")]).decode().splitlines()


def said_by_python(value: float) -> str:
    if math.isnan(value):
        return "-1"
    text = repr(value).removesuffix(".0")
    return "0" if text == "-0" else text


sizes = st.one_of(
    st.floats(-1e8, 1e8, exclude_min=True, exclude_max=True),
    st.floats(-3.0, 3.0),
    st.integers(-(10**9), 10**9).map(lambda whole: whole / 1000),
    st.integers(-(10**9), 10**9).map(lambda whole: whole / 2**20),
    st.integers(0, 10**7).map(lambda whole: math.nextafter(float(whole), math.inf)),
    st.floats(width=32, min_value=0, max_value=1),
    st.just(math.nan),
)


@settings(max_examples=120)
@given(st.lists(sizes, min_size=1, max_size=60))
@example([0.14, 0.1 + 0.2, 2.0**-7, math.nextafter(2.0**-7, 0), 99999999.99999999, -0.0])
@example([0.5, 1e-300, math.nan, -5e-324, 25634340.998429999, 4194304.000000001, 0.999999999999999])
def test_numbers_are_written_as_python_writes_them(values: list[float]) -> None:
    assert as_text(values) == [said_by_python(value) for value in values]


@pytest.mark.parametrize("seed", [11, 12])
def test_a_hundred_thousand_numbers_are_read_back_exactly(seed: int) -> None:
    random = np.random.default_rng(seed)
    magnitude = 2.0 ** random.uniform(-10, 26, 50_000)
    values = random.choice([-1.0, 1.0], 50_000) * magnitude
    assert_array_equal(np.array(as_text(values.tolist()), float), values)


def test_numbers_of_no_size_tracks_have_are_python_s() -> None:
    values = [1e8, -3.5e300, 1e-9, 5e-324, 0.001]
    assert as_text(values) == ["100000000", "-3.5e+300", "1e-09", "5e-324", "0.001"]


@given(st.lists(st.integers(-(10**12) + 1, 10**12 - 1), min_size=1, max_size=30))
@example([0, 9, 10, 9999, 10_000, 10_001, 99_999_999, 100_000_000])
def test_whole_numbers_are_written_without_leading_noughts(values: list[int]) -> None:
    text = lines_of([whole_numbers(np.array(values))]).decode().splitlines()
    assert text == [str(value) for value in values]


def test_columns_are_divided_and_lines_end() -> None:
    blocks = [
        whole_numbers(np.array([1, -20])),
        chosen([b"a", b"a longer word"], np.array([1, 0])),
        numbers(np.array([np.nan, -2.5]), b""),
        constant(b"-10", 2),
    ]
    assert lines_of(blocks, b" ") == b"1 a longer word  -10\n-20 a -2.5 -10\n"


def test_no_rows_are_no_lines() -> None:
    nothing = np.zeros(0)
    assert lines_of([whole_numbers(nothing), numbers(nothing, b"-1")]) == b""


@given(st.lists(st.floats(width=32, allow_nan=True, allow_infinity=False), min_size=1))
@example([0.9, 1.0, 0.1, 16777216.0, 1e-20, 0.3333333432674408])
def test_numbers_of_32_bits_are_the_same_again_and_short_where_they_can_be(
    values: list[float],
) -> None:
    narrow = np.array(values, np.float32)
    short = short_decimals(narrow)
    assert_array_equal(short.astype(np.float32), narrow)
    assert short_decimals(np.array([0.9, 0.123456], np.float32)).tolist() == [0.9, 0.123456]
