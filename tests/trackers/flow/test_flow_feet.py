"""Feet seen in the foreground below points: where they are, and what they say."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trackers.flow.flow_scenes import FPS
from tests.trackers.flow.tracklet_runs import VIEW, Walker, run_with
from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.foot_fit import estimate_scale, feet_cost, feet_misfit, ratios
from tracking.trackers.flow.foot_lines import foot_lines
from tracking.trackers.flow.relabel_run import relabel_run

FLOOR = Floor(VIEW)
ROWS, COLUMNS = 240, 320
COLUMN, TOP, FEET = 160, 60, 150


def mask_of(*stretches: tuple[int, int]) -> np.ndarray[tuple[int, ...], np.dtype[np.uint8]]:
    """A body as wide as nine pixels, in these lines."""
    mask = np.zeros((ROWS, COLUMNS), np.uint8)
    for top, bottom in stretches:
        mask[top:bottom, COLUMN - 4 : COLUMN + 5] = 2
    return mask


def foot_of(mask: np.ndarray[tuple[int, ...], np.dtype[np.uint8]], column: int = COLUMN) -> float:
    points = np.array([[2.0 * column + 0.5, 2.0 * TOP + 20.0]])
    return float(foot_lines(points, FLOOR.slopes(points), mask, FLOOR)[0])


def test_the_foreground_below_a_point_ends_on_the_last_line_of_the_body() -> None:
    assert foot_of(mask_of((TOP, FEET))) == 2 * (FEET - 1) + 1.5


def test_a_body_goes_on_over_a_few_lines_that_look_like_the_background() -> None:
    assert foot_of(mask_of((TOP, 100), (103, FEET))) == 2 * (FEET - 1) + 1.5
    assert foot_of(mask_of((TOP, 100), (110, FEET))) == 2 * 99 + 1.5


def test_a_foot_beside_the_point_is_the_bodys_and_one_far_off_is_not() -> None:
    assert foot_of(mask_of((TOP, FEET)), COLUMN + 7) == 2 * (FEET - 1) + 1.5
    assert foot_of(mask_of((TOP, FEET)), COLUMN + 40) < 2 * TOP + 22


def test_feet_below_the_picture_and_points_in_the_sky_have_no_line() -> None:
    assert np.isnan(foot_of(mask_of((TOP, ROWS))))
    point = np.array([[2.0 * COLUMN, 2.0 * TOP]])
    unknown = np.full((1, 2), np.nan)
    assert np.isnan(foot_lines(point, unknown, mask_of((TOP, FEET)), FLOOR)).all()


def test_feet_tell_the_distance_though_half_of_them_are_hidden_by_somebody_nearer() -> None:
    own = np.random.default_rng(5101).normal(0.15, 0.01, 40)
    hidden = np.linspace(-0.5, -0.1, 40)
    ((log_scale, weight),) = estimate_scale(np.concatenate((own, hidden)))
    assert log_scale == pytest.approx(0.15, abs=0.02)
    assert weight > 0


def test_feet_that_nobody_saw_say_nothing() -> None:
    unseen = np.full(50, np.nan)
    assert estimate_scale(unseen) == []
    assert (feet_misfit(unseen) == 0).all()
    assert (feet_cost(np.full((50, 3), np.nan)) == 0).all()


def test_ones_own_feet_suit_best_hidden_ones_less_and_feet_nowhere_least() -> None:
    own, hidden, nowhere = feet_misfit(ratios(np.array([7.0, 5.0, 10.0]), np.full(3, 7.0)))
    assert own == 0 < hidden < nowhere


def test_a_point_is_thought_as_high_as_its_feet_say() -> None:
    away = np.linspace(4.0, 9.0, 6)
    cost = feet_cost(ratios(np.full((10, 1), 7.0), np.tile(away, (10, 1))))
    assert away[cost.argmin()] == 7.0


@pytest.mark.parametrize("feet", [True, False])
def test_a_slow_walker_nobody_held_is_where_the_feet_are_and_else_not_there(feet: bool) -> None:
    slow, held = Walker((-0.7, 9.0), (0.0, -0.75)), Walker((0.9, 3.5), (0.0, 1.2))
    run = run_with((slow, held), ((1, 1, range(5, 75)),), feet=feet)
    found = relabel_run(run, VIEW, FPS).tracks
    own = found["x"] < 0
    true = np.hypot(*slow.at(found["frame"][own]).T)
    off = np.abs(np.log(np.hypot(found["x"][own], found["y"][own]) / true))
    assert (off < 0.06).mean() > 0.5 if feet else not (off < 0.06).any()
