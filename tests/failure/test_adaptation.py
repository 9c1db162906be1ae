"""The built-in detector adapted to labels: never worse on people held out, better where it can."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from made_up_parts import made_up_samples

from tracking.errors import TrainingError
from tracking.failure import (
    Curve,
    Machine,
    Machines,
    Samples,
    Trained,
    TrainingPlan,
    built_in_detector,
    train,
)
from tracking.failure.core.features import PAPER_FEATURES
from tracking.failure.training.adaptation import KEPT, mixture

ADAPT = TrainingPlan(adapt=built_in_detector, folds=3)


@pytest.fixture(scope="module")
def samples() -> Samples:
    return made_up_samples(5, people=5)


@pytest.fixture(scope="module")
def trained(samples: Samples) -> Trained:
    return train(samples, ADAPT, random=np.random.default_rng(3))


def _with_evidence(samples: Samples) -> Samples:
    """The samples of a tracker whose support alone tells which parts are lost."""
    random = np.random.default_rng(1)
    features = samples.features.copy()
    features[:, PAPER_FEATURES:] = random.uniform(0.4, 0.6, features[:, PAPER_FEATURES:].shape)
    lost = samples.columns["label"] == 0
    first = PAPER_FEATURES + 8 * samples.columns["part"].astype(int)
    features[np.arange(len(samples)), first] = np.where(lost, 0.05, 0.95)
    return Samples(samples.columns, features)


def test_no_part_is_judged_worse_than_before_on_people_held_out(trained: Trained) -> None:
    for question in trained.report.questions:
        assert question.curve.area() >= question.area_before
    assert trained.report.adapted


def test_labels_of_five_people_make_it_better_where_the_camera_differs(trained: Trained) -> None:
    unseen = made_up_samples(6, people=6)
    part, lost = unseen.columns["part"], unseen.columns["label"] == 0
    areas = [
        [
            Curve(
                np.sort(score[(part == k) & ~lost, k]), np.sort(score[(part == k) & lost, k])
            ).area()
            for k in range(3)
        ]
        for score in (
            built_in_detector(paper=True).judge(unseen.features).score,
            trained.detector.judge(unseen.features).score,
        )
    ]
    assert sum(areas[1]) > sum(areas[0])


def test_samples_without_evidence_adapt_the_detector_that_needs_none(trained: Trained) -> None:
    assert trained.detector.preparation.paper
    assert trained.report.as_json()["features"] == "paper"


def test_samples_with_evidence_adapt_the_one_that_sees_it(samples: Samples) -> None:
    made = train(_with_evidence(samples), ADAPT, random=np.random.default_rng(3))
    assert not made.detector.preparation.paper
    assert min(question.curve.area() for question in made.report.questions[:3]) > 0.95


def test_the_paper_can_be_asked_for(samples: Samples) -> None:
    plan = replace(ADAPT, paper=True)
    made = train(_with_evidence(samples), plan, random=np.random.default_rng(3))
    assert made.detector.preparation.paper


def test_a_few_samples_without_evidence_are_left_out_and_mistakes_keep_their_rows(
    samples: Samples,
) -> None:
    known = _with_evidence(samples)
    features = known.features.copy()
    features[:7, PAPER_FEATURES:] = np.nan
    some = Samples(known.columns, features)
    made = train(some, ADAPT, random=np.random.default_rng(3))
    assert not made.detector.preparation.paper
    assert made.detector.origin.counts.sum() == len(some) - 7
    for question in made.report.questions[:3]:
        for mistake in question.mistakes:
            assert some.columns["frame"][mistake.sample] == mistake.frame


def test_a_part_with_too_few_labels_stays_as_built_in(samples: Samples) -> None:
    torso_off = (samples.columns["part"] == 1) & (samples.columns["label"] == 0)
    fewer = samples[~torso_off | (np.cumsum(torso_off) <= 3)]
    made = train(fewer, ADAPT, random=np.random.default_rng(3))
    base = built_in_detector(paper=True)
    assert made.report.questions[1].candidate == KEPT
    assert made.report.questions[1] in made.report.kept
    assert made.detector.thresholds[1] == base.thresholds[1]
    assert np.array_equal(made.detector.machines.each[1].support, base.machines.each[1].support)


def test_where_no_part_has_enough_labels_it_is_told_what_is_missing(samples: Samples) -> None:
    on = samples[samples.columns["label"] == 1]
    with pytest.raises(TrainingError, match="0 samples off the part"):
        train(on, ADAPT, random=np.random.default_rng(3))


@pytest.mark.parametrize("share", [1 / 3, 1.0])
@pytest.mark.parametrize("gamma", [0.0, 0.2])
def test_a_mixture_says_what_its_machines_say_together(share: float, gamma: float) -> None:
    random = np.random.default_rng(2)
    one, other = (
        Machine(random.normal(size=(rows, 4)), random.normal(size=rows), 0.3 * rows, gamma)
        for rows in (5, 3)
    )
    asked = random.normal(size=(9, 4))
    each = Machines((one, other, mixture(one, other, share))).decide(asked)
    assert np.allclose(each[:, 2], (1 - share) * each[:, 0] + share * each[:, 1])


def test_the_same_samples_and_seed_adapt_it_alike(samples: Samples, trained: Trained) -> None:
    again = train(samples, ADAPT, random=np.random.default_rng(3))
    assert again.detector.fingerprint == trained.detector.fingerprint
