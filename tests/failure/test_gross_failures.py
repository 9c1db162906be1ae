"""Gross failures are made to learn from, and never measured on."""

from __future__ import annotations

import numpy as np
import pytest
from made_up_parts import made_up_samples, walk

from tracking.failure import Samples, part_features
from tracking.failure.training.gross import carried_away, with_gross_failures
from tracking.failure.training.questions import SEVERAL, questions_of
from tracking.failure.training.search import curve_of


@pytest.fixture(scope="module")
def samples() -> Samples:
    return made_up_samples(1, people=9)


@pytest.mark.parametrize("part", [0, 1, 2])
def test_carrying_a_part_away_is_what_the_features_of_it_elsewhere_are(part: int) -> None:
    states, _ = walk(np.random.default_rng(3), 40, loses=False)
    features = part_features(states[30:31], states[20:21])
    moved = carried_away(features, np.array([part]), np.random.default_rng(0))
    shift = (moved - features)[0, :36].reshape(2, 3, 6)
    now, before = states[30:31].copy(), states[20:21].copy()
    now[0, part, :2] += 1.5 * shift[0, part, :2]
    if not shift[1].any():  # it was away half a second ago already
        before[0, part, :2] += 1.5 * shift[0, part, :2]
    assert np.allclose(part_features(now, before), moved, equal_nan=True)


def test_made_answers_are_of_both_kinds_and_of_the_same_people(samples: Samples) -> None:
    for question in questions_of(samples):
        more = with_gross_failures(question, samples, np.random.default_rng(2))
        made = more.of(np.flatnonzero(more.made))
        assert made.yes.sum() == (~made.yes).sum() >= 40
        assert np.array_equal(made.people, samples.people()[made.rows])
        asked = more.asked()
        assert np.array_equal(asked.features, question.features, equal_nan=True)
        if question.number < SEVERAL:
            assert (samples.columns["part"][made.rows] == question.number).all()
            assert (samples.columns["label"][made.rows] == 1).all()


def test_curves_know_nothing_of_what_was_made(samples: Samples) -> None:
    question = questions_of(samples)[0]
    more = with_gross_failures(question, samples, np.random.default_rng(2))
    scores = np.where(more.made, 1e9, 0.0)
    curve = curve_of(more, scores)
    assert len(curve.on) + len(curve.off) == len(question)
    assert max(curve.on.max(), curve.off.max()) == 0.0


def test_the_same_random_numbers_make_the_same(samples: Samples) -> None:
    question = questions_of(samples)[1]
    one, other = (
        with_gross_failures(question, samples, np.random.default_rng(2)) for _ in range(2)
    )
    assert np.array_equal(one.features, other.features, equal_nan=True)
