"""Training: folds by person, operating points that hold, the same detector every time."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_up_parts import made_up_samples, walk

from tracking.errors import CancelledError, TrainingError
from tracking.failure import (
    FALSE_ALARMS,
    Samples,
    Trained,
    TrainingPlan,
    part_features,
    train,
)
from tracking.failure.training import Candidate, page_of
from tracking.failure.training.folds import folds_of, thinned
from tracking.failure.training.questions import Question, one_or_several, questions_of
from tracking.failure.training.search import Tried, best_of

QUICK = TrainingPlan(grid=(Candidate(1.0, 0.3), Candidate(10.0, 1.0)), folds=3, searched=300)


@pytest.fixture(scope="module")
def samples() -> Samples:
    return made_up_samples(1, people=9)


@pytest.fixture(scope="module")
def trained(samples: Samples) -> Trained:
    return train(samples, QUICK, random=np.random.default_rng(7))


def test_false_alarms_of_people_held_out_are_as_few_as_asked(trained: Trained) -> None:
    assert (trained.detector.rates()[:, 0] <= FALSE_ALARMS).all()


def test_people_it_never_saw_are_judged_better_than_by_chance(trained: Trained) -> None:
    unseen = made_up_samples(2, people=6)
    part, lost = unseen.columns["part"], unseen.columns["label"] == 0
    failed = trained.detector.judge(unseen.features).failed[np.arange(len(part)), part]
    assert failed[~lost].mean() < 0.1
    assert failed[lost].mean() > 0.2


def test_the_same_samples_and_seed_give_the_same_detector(
    samples: Samples, trained: Trained
) -> None:
    again = train(samples, QUICK, random=np.random.default_rng(7)).detector
    assert again.fingerprint == trained.detector.fingerprint
    assert again.origin.samples == trained.detector.origin.samples


def test_the_operating_point_moves_on_the_curve(trained: Trained) -> None:
    strict = trained.detector.with_operating_point(0.0)
    lax = trained.detector.with_operating_point((0.5, 0.5, 0.02))
    assert strict.rates()[:, 0].tolist() == [0, 0, 0]
    assert (lax.rates()[:2, 0] > 0.4).all()
    assert lax.thresholds[2] == trained.detector.thresholds[2]
    assert len({strict.fingerprint, lax.fingerprint, trained.detector.fingerprint}) == 3


def test_a_state_with_a_gap_is_not_judged(trained: Trained, samples: Samples) -> None:
    features = samples.features[:2].copy()
    features[1, 3] = np.nan
    said = trained.detector.judge(features)
    assert np.isnan(said.score[1]).all()
    assert not said.failed[1].any()
    assert not said.several[1]
    assert np.isfinite(said.score[0]).all()


def test_several_parts_are_lost_only_where_any_is(trained: Trained, samples: Samples) -> None:
    said = trained.detector.judge(samples.features)
    assert not said.several[~said.failed.any(axis=1)].any()
    assert said.several.any()


def test_the_report_counts_what_the_curves_say(trained: Trained, samples: Samples) -> None:
    off_and_on = samples.counts()
    for question, counts in zip(trained.report.questions, off_and_on, strict=False):
        assert question.confusion.sum(axis=1).tolist() == counts[::-1].tolist()
        assert question.confusion[0, 1] / counts[1] == pytest.approx(question.false_alarms)
        assert question.confusion[1, 1] / counts[0] == pytest.approx(question.found)
    assert json.loads(json.dumps(trained.report.as_json(), allow_nan=False))["folds"] == 3


def test_mistakes_are_wrong_worst_first_and_not_all_of_one_person(
    trained: Trained, samples: Samples
) -> None:
    mistakes = trained.report.questions[0].mistakes
    assert mistakes
    for mistake in mistakes:
        assert samples.columns["frame"][mistake.sample] == mistake.frame
        assert bool(samples.columns["label"][mistake.sample] == 1) is mistake.failed
        assert (mistake.score > 0) is mistake.failed
    scores = [abs(mistake.score) for mistake in mistakes]
    assert scores == sorted(scores, reverse=True)
    tracks = [mistake.track for mistake in mistakes]
    assert max(map(tracks.count, tracks)) <= 3


def test_the_page_names_every_question_and_shows_pictures(trained: Trained) -> None:
    shown = trained.report.questions[0].mistakes[0].sample
    page = page_of(trained.report, {shown: b"picture"})
    assert all(f"<h2>{question.name}</h2>" in page for question in trained.report.questions)
    assert page.count("curve c0") == len(trained.report.questions)
    assert page.count("data:image") == 1


def test_progress_reaches_its_end(samples: Samples) -> None:
    told: list[tuple[int, int]] = []
    plan = replace(QUICK, grid=QUICK.grid[:1])
    train(samples, plan, random=np.random.default_rng(7), progress=lambda *step: told.append(step))
    assert [done for done, _ in told] == list(range(1, told[-1][1] + 1))


def test_training_stops_when_asked(samples: Samples) -> None:
    def stop(*_: int) -> None:
        raise CancelledError("stopped by the user")

    with pytest.raises(CancelledError):
        train(samples, QUICK, random=np.random.default_rng(7), progress=stop)


def of_one(samples: Samples) -> np.ndarray:
    """Those of the person whose head was lost most often."""
    lost_head = (samples.columns["label"] == 0) & (samples.columns["part"] == 0)
    most = np.bincount(samples.columns["track"][lost_head]).argmax()
    return samples.columns["track"] == most


@pytest.mark.parametrize(
    ("kept", "why"),
    [
        (lambda s: s.columns["part"] != 1, "torso: 0 samples off the part"),
        (lambda s: (s.columns["label"] == 1) | of_one(s), "of 1 person"),
        (lambda s: s.columns["label"] == 1, "head: 0 samples off the part"),
        (lambda s: s.columns["label"] == 0, "head: 0 samples on the part"),
    ],
)
def test_too_few_samples_are_told_in_one_line(samples: Samples, kept, why: str) -> None:
    with pytest.raises(TrainingError, match=why) as told:
        train(samples[kept(samples)], QUICK, random=np.random.default_rng(7))
    assert "\n" not in str(told.value)


def test_all_that_is_short_is_told_at_once(samples: Samples) -> None:
    columns = samples.columns
    kept = (columns["part"] == 2) | ((columns["part"] == 0) & (columns["label"] == 1))
    with pytest.raises(TrainingError) as told:
        train(samples[kept], QUICK, random=np.random.default_rng(7))
    assert "head: 0 samples off the part, of 0 people; torso: 0 samples off" in str(told.value)
    assert "and 0 samples on the part" in str(told.value)
    assert "hip-leg" not in str(told.value)
    assert "adjust=false" in str(told.value)


def test_one_sample_is_told_as_one_and_lost_parts_are_not_missed_where_there_are_enough(
    samples: Samples,
) -> None:
    part, label = samples.columns["part"], samples.columns["label"]
    kept = (part != 0) | (label == 0)
    kept[np.flatnonzero(~kept)[0]] = True
    with pytest.raises(TrainingError, match="head: 1 sample on the part, of 1 person") as told:
        train(samples[kept], QUICK, random=np.random.default_rng(7))
    assert "adjust=false" not in str(told.value)


def test_without_instants_of_several_two_failed_parts_are_several(samples: Samples) -> None:
    instants = np.column_stack((samples.people(), samples.columns["frame"]))
    which = np.unique(instants, axis=0, return_inverse=True)[1].reshape(-1)
    lost = np.bincount(which, samples.columns["label"] == 0)
    made = train(samples[lost[which] < 2], QUICK, random=np.random.default_rng(7)).detector
    said = made.judge(samples.features)
    assert len(made.machines.each) == 3
    assert (said.several == (said.failed.sum(axis=1) > 1)).all()


def test_one_or_several_is_known_only_where_enough_was_said(samples: Samples) -> None:
    rows = one_or_several(samples, samples.people())
    columns = samples.columns
    for row, several in zip(rows.rows.tolist(), rows.yes.tolist(), strict=True):
        same = (columns["track"] == columns["track"][row]) & (
            columns["frame"] == columns["frame"][row]
        )
        assert ((columns["label"][same] == 0).sum() > 1) == several
    half = samples[columns["part"] != 2]
    alone = one_or_several(half, half.people())
    assert alone.yes.all()


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32), st.integers(4, 30), st.integers(2, 6))
def test_nobody_is_learnt_from_and_held_out_at_once(seed: int, people: int, most: int) -> None:
    random = np.random.default_rng(seed)
    who = np.concatenate([np.arange(people), random.integers(0, people, 6 * people)])
    yes = random.random(len(who)) < 0.3
    yes[:2], yes[2:4] = True, False
    question = Question(0, np.arange(len(who)), np.zeros((len(who), 36)), yes, who, who < 0)
    folds = folds_of([question], most, random)
    assert folds.min() == 0
    assert folds.max() < most
    for fold in range(int(folds.max()) + 1):
        rest = yes[folds[who] != fold]
        assert rest.any()
        assert not rest.all()


def test_samples_of_one_person_alone_make_no_folds() -> None:
    who = np.array([0] * 50 + [1] * 50)
    question = Question(0, np.arange(100), np.zeros((100, 36)), who == 0, who, who < 0)
    with pytest.raises(TrainingError, match="label more people"):
        folds_of([question], 5, np.random.default_rng(0))


@given(st.integers(0, 2**32), st.integers(1, 60))
def test_thinning_keeps_both_answers_and_everybody_it_can(seed: int, most: int) -> None:
    random = np.random.default_rng(seed)
    yes, who = random.random(80) < 0.2, random.integers(0, 5, 80)
    question = Question(1, np.arange(80), np.zeros((80, 36)), yes, who, who < 0)
    few = thinned(question, most, random)
    assert len(few) == most
    assert few.yes.sum() == min(yes.sum(), max(most // 2, most - (~yes).sum()))
    assert np.array_equal(few.yes, yes[few.rows])


def test_questions_come_by_part(samples: Samples) -> None:
    names = [question.name for question in questions_of(samples)]
    assert names == ["head", "torso", "hip-leg", "several"]


@pytest.mark.parametrize("part", [0, 1, 2])
def test_a_part_at_the_other_end_of_the_picture_has_failed(trained: Trained, part: int) -> None:
    states, _ = walk(np.random.default_rng(3), 40, loses=False)
    now, before = states[30:31].copy(), states[20:21]
    now[0, part, :2] += (900.0, -50.0)
    said = trained.detector.judge(part_features(now, before))
    assert said.failed[0].any()


def test_of_candidates_that_chance_cannot_tell_apart_the_smoothest_is_taken() -> None:
    smooth, wiggly = Candidate(1.0, 0.1), Candidate(100.0, 3.0)
    for better, taken in ((0.52, smooth), (0.9, wiggly)):
        tried = [
            Tried(question, by_size, candidate, worth, 0.05)
            for by_size in (False, True)
            for question in range(3)
            for candidate, worth in ((smooth, 0.5), (wiggly, better))
        ]
        assert best_of(tried, 3).candidates == (taken,) * 3


def test_mistakes_of_one_person_lie_apart_in_time_whatever_the_frame_rate(samples: Samples) -> None:
    slow = samples.with_columns(time_s=samples.columns["frame"] / 2.0)
    shown = []
    for each in (samples, slow):
        report = train(each, QUICK, random=np.random.default_rng(7)).report
        shown.append(list(report.questions[0].mistakes))
    times_s = samples.times_s()
    for one in shown[0]:
        for other in shown[0]:
            same = one is not other and one.track == other.track
            assert not same or abs(times_s[one.sample] - times_s[other.sample]) >= 0.75
    assert len(shown[1]) >= len(shown[0])
