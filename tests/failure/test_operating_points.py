"""Operating points: never more false alarms than allowed, and movable."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.failure import Curve

SCORES = st.lists(st.integers(-9, 9).map(float), max_size=40).map(lambda s: np.array(sorted(s)))


@given(SCORES.filter(len), SCORES, st.floats(0, 1))
def test_false_alarms_stay_within_what_is_allowed(on, off, allowed: float) -> None:
    curve = Curve(on, off)
    threshold = curve.threshold_for(allowed)
    assert curve.false_alarms(threshold) <= allowed + 1e-9


@given(SCORES.filter(len), SCORES, st.floats(0, 1))
def test_a_lower_threshold_would_raise_more(on, off, allowed: float) -> None:
    curve = Curve(on, off)
    lower = [score for score in on if score < curve.threshold_for(allowed)]
    if lower:
        assert curve.false_alarms(np.nextafter(lower[-1], -math.inf)) > allowed - 1e-9


@given(SCORES.filter(len), SCORES.filter(len))
def test_the_curve_goes_from_nothing_to_everything(on, off) -> None:
    points = Curve(on, off).points()
    assert points[0, 1:].tolist() == [0, 0]
    assert points[-1, 1:].tolist() == [1, 1]
    assert (np.diff(points[:, 1:], axis=0) >= 0).all()
    for threshold, alarms, found in points.tolist():
        assert Curve(on, off).false_alarms(threshold) == pytest.approx(alarms)
        assert Curve(on, off).found(threshold) == pytest.approx(found)


def test_the_area_tells_a_clean_machine_from_a_blind_one() -> None:
    low, high = np.linspace(0, 1, 50), np.linspace(2, 3, 50)
    assert Curve(low, high).area() == 1.0
    assert Curve(high, low).area() == pytest.approx(0.0, abs=0.01)
    assert Curve(low, low).area() == pytest.approx(0.5, abs=0.02)


def test_without_samples_there_is_no_rate() -> None:
    curve = Curve(np.zeros(0), np.zeros(0))
    assert math.isnan(curve.found(0))
    assert curve.threshold_for(0.02) == 0.0


def test_a_machine_that_draws_lots_is_called_no_better_than_chance() -> None:
    random = np.random.default_rng(4109)
    lots = Curve(np.sort(random.normal(0, 1, 300)), np.sort(random.normal(0, 1, 300)))
    better = Curve(np.sort(random.normal(0, 1, 300)), np.sort(random.normal(1, 1, 300)))
    assert lots.by_chance
    assert not better.by_chance
    assert not Curve(np.zeros(0), np.zeros(3)).by_chance
