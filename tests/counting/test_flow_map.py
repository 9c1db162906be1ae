"""The flow map: density and direction in cells of the floor."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from walks import crowd, together, walk

from tracking.counting import flow_map
from tracking.errors import CountingError


def test_the_density_is_the_mean_of_people_a_square_metre() -> None:
    """Somebody stands in one cell in half of all frames."""
    found = flow_map(walk([(0.25, 0.25)] * 10), 10.0, (0, 20))
    assert found.density.tolist() == [[0.5 / 0.25]]
    assert (found.left, found.bottom) == (0.0, 0.0)


def test_the_velocity_is_that_of_who_was_there() -> None:
    right = walk([(0.1 * k, 0.2) for k in range(10)])
    found = flow_map(right, 10.0, (0, 10))
    assert found.velocity[0, 0] == pytest.approx((1.0, 0.0))


def test_to_and_fro_take_each_other_out() -> None:
    right = walk([(0.05 + 0.1 * k, 0.2) for k in range(20)])
    left = walk([(1.95 - 0.1 * k, 0.2) for k in range(20)], track=2)
    found = flow_map(together(right, left), 10.0, (0, 20), cell_m=2.0)
    assert found.velocity[0, 0] == pytest.approx((0.0, 0.0), abs=1e-9)


def test_where_nobody_was_there_is_no_direction() -> None:
    apart = together(walk([(0.1, 0.1)] * 2), walk([(1.6, 0.1)] * 2, track=2))
    found = flow_map(apart, 10.0, (0, 2))
    assert np.isnan(found.velocity[0, 1]).all()
    assert found.density[0].tolist() == [4.0, 0.0, 0.0, 4.0]


@given(st.integers(0, 20), st.sampled_from([0.2, 0.5, 1.3]))
def test_all_cells_together_hold_everybody(seed: int, cell_m: float) -> None:
    columns = crowd(seed)
    found = flow_map(columns, 10.0, (0, 130), cell_m)
    held = found.density.sum() * found.cell_m**2 * found.frames
    assert held == pytest.approx(len(columns["frame"]))
    middles = found.centres.reshape(-1, 2)
    assert middles.min() > min(columns["x"].min(), columns["y"].min()) - cell_m


def test_only_the_frames_and_the_floor_that_are_asked_for_count() -> None:
    columns = crowd(4)
    found = flow_map(columns, 10.0, (20, 40), bounds=(-1.0, -1.0, 1.0, 1.0))
    inside = (
        (columns["frame"] >= 20)
        & (columns["frame"] < 40)
        & (np.abs(columns["x"]) < 1)
        & (np.abs(columns["y"]) < 1)
    )
    assert found.density.sum() * 0.25 * 20 == pytest.approx(np.count_nonzero(inside))


def test_people_far_away_make_cells_larger_not_more() -> None:
    far = together(walk([(0.0, 0.0)] * 2), walk([(1e6, 1e6)] * 2, track=2))
    found = flow_map(far, 10.0, (0, 2))
    assert max(found.density.shape) <= 401


def test_nobody_is_nowhere() -> None:
    found = flow_map(walk([]), 10.0, (0, 10))
    assert (found.density.size, found.most) == (0, 0.0)


@pytest.mark.parametrize("cell_m", [0.0, -1.0, float("nan")])
def test_a_cell_needs_a_size(cell_m: float) -> None:
    with pytest.raises(CountingError, match="it needs a size"):
        flow_map(walk([(0, 0)]), 10.0, (0, 1), cell_m)
