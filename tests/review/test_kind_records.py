"""Likelihoods of the items left follow what came of the decided ones of their kind."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.review import ReviewItem, records_of, with_learned_likelihoods

SHARES = st.floats(0.01, 0.99)


def item(kind: str, likelihood: float, frame: int = 0) -> ReviewItem:
    return ReviewItem(kind, (1,), frame, frame, frame + 5, likelihood, 10.0, "", "look")


def learned(likelihood: float, *outcomes: tuple[str, float, bool]) -> float:
    return with_learned_likelihoods([item("lost", likelihood)], records_of(outcomes))[0].likelihood


def test_records_count_by_kind() -> None:
    records = records_of([("lost", 0.5, True), ("lost", 0.3, False), ("jump", 0.1, False)])
    assert (records["lost"].decided, records["lost"].errors) == (2, 1)
    assert records["lost"].stated == pytest.approx(0.8)
    assert records["jump"].errors == 0


def test_a_kind_that_nobody_decided_stays_the_very_same() -> None:
    one = item("jump", 0.4)
    assert with_learned_likelihoods([one], records_of([("lost", 0.5, True)]))[0] is one


def test_the_posterior_mean_is_that_of_a_beta_prior_about_what_was_stated() -> None:
    # Beta(4 x 0.5, 4 x 0.5) and three errors of four: 5 of 8.
    outcomes = [("lost", 0.5, True)] * 3 + [("lost", 0.5, False)]
    assert learned(0.5, *outcomes) == pytest.approx(5 / 8)


def test_as_many_errors_as_stated_change_nothing() -> None:
    outcomes = [("lost", 0.25, True)] + [("lost", 0.25, False)] * 3
    assert learned(0.7, *outcomes) == pytest.approx(0.7)


@given(SHARES, SHARES, st.integers(1, 30))
def test_errors_raise_what_is_left_and_false_alarms_lower_it_the_more_the_more_there_are(
    left: float, stated: float, count: int
) -> None:
    right, wrong = ("lost", stated, False), ("lost", stated, True)
    assert learned(left, *[right] * count) <= left + 1e-9 <= learned(left, *[wrong] * count) + 2e-9
    assert learned(left, *[right] * (count + 1)) <= learned(left, *[right] * count) + 1e-12
    assert 0.0 < learned(left, *[right] * count) < 1.0


@given(SHARES, SHARES)
def test_the_order_within_a_kind_stays(one: float, other: float) -> None:
    outcomes = [("lost", 0.5, False)] * 5
    low, high = sorted((one, other))
    assert learned(low, *outcomes) <= learned(high, *outcomes)
