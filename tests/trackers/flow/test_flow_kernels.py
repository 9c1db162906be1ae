"""Kernels are as large as a body whose middle is at the pixel."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from flow_scenes import view_of
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.geometry import Camera, Ground, View
from tracking.trackers.flow import kernel_sizes, kernel_table


@pytest.mark.parametrize("distortion", [0.0, -0.2])
def test_the_table_says_of_every_pixel_what_projecting_there_says(distortion: float) -> None:
    view = view_of(2.2, 20.0, distortion)
    table = kernel_table(view)
    random = np.random.default_rng(5101)
    pixels = np.column_stack((random.integers(20, 620, 300), random.integers(200, 470, 300)))
    wanted = kernel_sizes(view, pixels.astype(float))
    np.testing.assert_allclose(table.at(pixels), wanted, atol=0.1, rtol=0.002)


def test_a_kernel_is_as_wide_and_high_as_an_upright_card_round_the_point() -> None:
    view = view_of(2.2, 20.0)
    middle = view.pixel_from_world(np.array([[0.0, 5.0, 0.8]]))
    low, high = -0.025, 1.625
    corners = view.pixel_from_world(
        np.array([[x, 5.0, z] for x in (-0.2, 0.2) for z in (low, high)])
    )
    size = kernel_sizes(view, middle)[0]
    np.testing.assert_allclose(size, corners.max(axis=0) - corners.min(axis=0), rtol=1e-6)


def test_straight_down_a_kernel_is_as_broad_as_a_body_both_ways() -> None:
    view = view_of(3.6, 90.0)
    size = kernel_sizes(view, np.array([[319.5, 239.5]]))[0]
    assert size[0] >= 500.0 * 0.4 / (3.6 - 0.8) - 0.5
    assert size[1] >= 500.0 * 0.4 / (3.6 - 0.8) - 0.5


def test_above_the_horizon_there_is_no_kernel() -> None:
    table = kernel_table(view_of(1.9, 11.0))
    assert np.isnan(table.hx[:100]).all()
    assert np.isfinite(table.hy[200:]).all()


@settings(max_examples=30, deadline=None)
@given(st.floats(160, 460), st.floats(1, 60))
def test_people_low_in_the_picture_are_larger(row: float, further: float) -> None:
    sizes = kernel_sizes(view_of(2.2, 20.0), np.array([[320.0, row], [320.0, row + further]]))
    assert (sizes[1] > sizes[0]).all()


def test_a_point_outside_the_picture_has_no_kernel() -> None:
    table = kernel_table(view_of())
    assert np.isnan(table.at(np.array([[-3.0, 300.0], [700.0, 300.0], [np.nan, 1.0]]))).all()


def test_the_table_of_a_large_picture_takes_little_more_memory_than_it_holds() -> None:
    matrix = np.array([[1700.0, 0.0, 959.5], [0.0, 1700.0, 539.5], [0.0, 0.0, 1.0]])
    view = View(Camera(matrix, np.zeros(4), 1920, 1080), Ground(7.8, 20.0))
    tracemalloc.start()
    try:
        table = kernel_table(view)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 8 * (table.hx.nbytes + table.hy.nbytes)
