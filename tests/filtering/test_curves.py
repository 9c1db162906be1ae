from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tracking.filtering import (
    Chains,
    robust_levels,
    robust_paths,
    slopes,
    smooth_levels,
    smooth_paths,
    trust,
)


def chain(frames: int, track: int = 1) -> Chains:
    return Chains(np.arange(frames), np.full(frames, track))


def line(frames: int) -> np.ndarray:
    return np.array([1.0, 5.0]) + np.arange(frames)[:, None] * (0.05, -0.02)


@given(st.integers(1, 40), st.integers(0, 39), st.integers(0, 39), st.floats(0.5, 20.0))
@example(frames=17, start=0, length=15, memory=0.5)
def test_a_straight_path_stays_and_its_gaps_are_filled(
    frames: int, start: int, length: int, memory: float
):
    weight = np.ones(frames)
    weight[1 + start : min(1 + start + length, frames - 1)] = 0.0
    values = np.where(weight[:, None] > 0, line(frames), 77.0)
    found = smooth_paths(values, weight, chain(frames), memory)
    assert found == pytest.approx(line(frames), abs=1e-6)


def test_a_gap_in_a_turn_is_crossed_without_a_corner():
    angle = np.linspace(0.0, 2.0, 81)
    bow = np.stack((np.cos(angle), np.sin(angle)), axis=1) * 2.0
    weight = np.ones(81)
    weight[35:50] = 0.0
    found = smooth_paths(bow * weight[:, None], weight, chain(81), 2.0)
    straight = np.linspace(bow[34], bow[50], 17)[1:-1]
    off, off_straight = (np.hypot(*(way - bow[35:50]).T).max() for way in (found[35:50], straight))
    assert off < 0.2 * off_straight


def test_rows_before_the_first_measured_one_pull_at_nobody():
    weight = np.ones(20)
    weight[[0, 1, 2, 15, 16, 17, 18, 19]] = 0.0
    values = np.arange(20.0)[:, None] * np.ones(2)
    values[weight == 0] = 500.0
    chains = Chains(np.tile(np.arange(10), 2), np.repeat((1, 2), 10))
    expected = np.arange(20.0)[:, None] * np.ones(2)
    assert smooth_paths(values, weight, chains, 2.0) == pytest.approx(expected, abs=1e-3)


def test_missing_rows_count_as_time():
    frames = np.array([0, 1, 2, 3, 10, 11, 12])
    chains = Chains(frames, np.ones(7, int))
    values = line(13)[frames]
    assert smooth_paths(values, np.ones(7), chains, 4.0) == pytest.approx(values, abs=1e-9)
    assert slopes(values, chains) == pytest.approx(np.tile((0.05, -0.02), (7, 1)))


def test_tracks_do_not_pull_at_each_other():
    random = np.random.default_rng(1)
    values, weight = random.normal(size=(30, 2)), random.uniform(0.1, 1.0, 30)
    both = Chains(np.tile(np.arange(15), 2), np.repeat((1, 2), 15))
    together = smooth_paths(values, weight, both, 3.0)
    levels = smooth_levels(values[:, 0], weight, both, 3.0)
    for rows in (slice(0, 15), slice(15, 30)):
        alone = smooth_paths(values[rows], weight[rows], chain(15), 3.0)
        assert together[rows] == pytest.approx(alone)
        level = smooth_levels(values[rows, 0], weight[rows], chain(15), 3.0)
        assert levels[rows] == pytest.approx(level)


def test_a_level_is_led_across_a_gap():
    values = np.array([1.0, 1.0, 9.0, 9.0, 9.0, 3.0, 3.0])
    weight = np.array([1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0])
    found = smooth_levels(values, weight, chain(7), 0.01)
    assert found == pytest.approx([1.0, 1.0, 1.5, 2.0, 2.5, 3.0, 3.0], abs=1e-2)


def test_outliers_leave_levels_and_paths_where_they_were():
    values = np.full(41, 0.25)
    values[18:22] = 0.9
    found = robust_levels(values, np.ones(41), chain(41), 9.0, 0.1)
    assert found == pytest.approx(np.full(41, 0.25), abs=0.02)
    places = line(41)
    places[20] += 1.0
    found = robust_paths(places, np.ones(41), chain(41), 3.0, np.full(41, 0.1))
    assert found == pytest.approx(line(41), abs=0.01)


def test_trust_falls_from_one_with_the_miss():
    shares = trust(np.array([0.0, 0.1, -0.1, 1.0]), 0.1)
    assert shares.tolist() == pytest.approx([1.0, 0.25, 0.25, 1 / 101**2])


def test_a_single_row_has_no_slope():
    assert np.isnan(slopes(line(1), chain(1))).all()
