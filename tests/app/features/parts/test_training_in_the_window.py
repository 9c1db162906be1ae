"""What is learnt from, counted before the training, and the operating point of its result."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.core.i18n import time_text
from app.features.parts.training_result import TrainingResult
from app.features.parts.training_set import Source, build_training_set
from app.features.parts.training_settings import TrainingSettings, counts_of, train_on
from tracking.errors import CancelledError
from tracking.failure import FEATURE_NAMES, Samples
from tracking.failure.core.samples import samples_from_rows

FPS = 20.0


def training_set(*made: Samples):
    """What a detector learns from: a session each."""
    sources = [
        Source(f"session {number}", Path(f"{number}.h5"), one, f"{number}", "lobby", FPS)
        for number, one in enumerate(made)
    ]
    return build_training_set(sources)


def samples(recording="lobby", people=4, each=24, seed=4105, wrong=0.1) -> Samples:
    """Parts that failed stand a little aside; a share is labelled the `wrong` way round."""
    random = np.random.default_rng(seed)
    rows, features = [], []
    for person in range(1, people + 1):
        for number in range(each):
            for part in range(3):
                on = number % 2
                values = random.normal(0.0, 1.0, len(FEATURE_NAMES))
                values[part * 6] += 0.0 if on else 3.0
                label = on if random.random() > wrong else 1 - on
                rows.append((recording, person, number, part, label, "somebody", "", "label"))
                features.append(values)
    return samples_from_rows(rows, np.array(features))


@pytest.fixture(scope="module")
def trained():
    settings = TrainingSettings(folds=2, search_samples=100, from_scratch=True)
    return train_on(samples(), settings, lambda *_: None)


@pytest.fixture
def result(trained):
    return TrainingResult(trained, training_set(samples()))


def test_samples_are_counted_by_part_answer_and_person():
    made = samples()
    label, part = made.columns["label"], made.columns["part"]
    torso = counts_of(made)[1]
    assert (torso.on, torso.off) == tuple(
        int(((part == 1) & (label == answer)).sum()) for answer in (1, 0)
    )
    assert (torso.people_on, torso.people_off) == (4, 4)
    assert torso.missing == ""


def test_what_is_missing_is_said_of_samples_and_of_people():
    assert "more off" in counts_of(samples(people=2, each=4))[0].missing
    assert counts_of(samples(people=1, each=40))[0].missing == "on and off: of 2 people or more"


def test_both_answers_that_are_missing_and_of_how_many_people_are_said_at_once():
    said = counts_of(samples(people=0, each=0))[0].missing
    assert said == "label 10 more on and 10 more off; on and off: of 2 people or more"


def test_a_mistake_says_of_which_recording_person_and_frame_it_is_by_its_own_clock(trained):
    slow = Source("slow", Path("slow.h5"), samples(), "", "yard", 10.0)
    result = TrainingResult(trained, build_training_set([slow]))
    result.put(0.5)
    items = result.scene().mistakes
    assert items
    for one in items:
        assert (one.source.title, one.recording) == ("slow", "yard")
        assert one.title.endswith(f" of {one.track}")
        assert one.when == time_text(one.frame / 10.0)


def test_each_sample_is_known_to_be_of_its_source():
    both = training_set(samples(people=2), samples(people=3))
    first = len(both.sources[0].samples)
    of = [both.source_of(row).title for row in (0, first - 1, first, len(both.samples) - 1)]
    assert of == ["session 0", "session 0", "session 1", "session 1"]


def test_each_sample_has_the_rectangle_that_its_own_source_says_was_judged():
    made = samples(people=2)
    boxes = np.arange(4.0 * len(made)).reshape(-1, 4)
    boxes[0] = np.nan
    one = Source("a", Path("a.h5"), made, "x", "lobby", FPS, boxes)
    other = replace(one, path=Path("b.h5"), boxes=boxes + 1000)
    table = Source("c.csv", Path("c.csv"), made, "")
    training_set, count = build_training_set([one, other, table]), len(made)
    assert training_set.box_of(0) is None
    assert training_set.box_of(1) == (4.0, 5.0, 6.0, 7.0)
    assert training_set.box_of(count + 1) == (1004.0, 1005.0, 1006.0, 1007.0)
    assert training_set.box_of(2 * count + 1) is None


def test_mistakes_of_two_sessions_of_one_recording_are_seen_where_each_was_labelled(trained):
    half = len(samples()) // 2
    parts = [samples()[:half], samples()[half:]]
    sources = [
        Source(name, Path(f"{name}.h5"), own, "x", "lobby", FPS, np.full((len(own), 4), number))
        for number, (name, own) in enumerate(zip("ab", parts, strict=True))
    ]
    result = TrainingResult(trained, build_training_set(sources))
    seen = {
        (one.mistake.sample >= half, one.source.title, one.box[0])
        for one in result.scene().mistakes
    }
    assert seen == {(False, "a", 0.0), (True, "b", 1.0)}


def test_several_lost_at_once_are_a_row_of_their_own_where_they_were_learnt(trained):
    scene = TrainingResult(trained, training_set(samples())).scene()
    learnt = len(trained.report.questions) > 3
    assert (scene.several is not None) == learnt
    told = "Several at once" if learnt else "that was not learnt"
    assert any(told in line for line in scene.lines)


def test_parameters_are_left_to_those_who_ask_for_them(result):
    scene = result.scene()
    assert not any("C 1" in line or "linear" in line for line in scene.lines)
    assert "head:" in scene.details


def test_people_of_different_recordings_with_one_name_are_different_people():
    one = Source("a", None, samples(), "first")
    other = Source("c", None, samples(seed=4107), "second")
    apart = build_training_set([one, other]).samples
    assert len(np.unique(apart.people())) == 8
    assert set(apart.columns["recording"]) == {"lobby", "lobby (c)"}


def test_people_of_two_sessions_of_one_recording_are_held_out_together():
    one = Source("a", None, samples(), "first")
    same = Source("b", None, samples(seed=4106), "first")
    assert len(np.unique(build_training_set([one, same]).samples.people())) == 1


def test_a_table_beside_its_session_names_the_same_people():
    session, table = Source("a", None, samples(), "first"), Source("a.csv", None, samples(), "")
    assert len(np.unique(build_training_set([session, table]).samples.people())) == 4


def test_training_stops_where_the_user_cancels():
    def report(done: int, total: int) -> None:
        assert 0 < done <= total
        raise CancelledError("stopped by the user")

    with pytest.raises(CancelledError):
        train_on(
            samples(), TrainingSettings(folds=2, search_samples=100, from_scratch=True), report
        )


def test_the_same_seed_trains_the_same_detector(trained):
    again = train_on(
        samples(), TrainingSettings(folds=2, search_samples=100, from_scratch=True), lambda *_: None
    )
    assert again.detector.fingerprint == trained.detector.fingerprint


def test_figures_are_the_confusion_the_training_reports(result, trained):
    for figures, question in zip(result.scene().figures, trained.report.questions, strict=False):
        (passed, alarms), (missed, found) = question.confusion.tolist()
        assert (figures.on - figures.false_alarms, figures.false_alarms) == (passed, alarms)
        assert (figures.off - figures.found, figures.found) == (missed, found)


def test_a_share_of_false_alarms_is_never_exceeded(result):
    for share in (0.0, 0.05, 0.2, 1.0):
        result.put(share)
        for figures in result.scene().figures:
            assert figures.false_alarms <= share * figures.on + 1e-9


def test_a_step_is_one_false_alarm_and_back(result):
    result.put(0.05)
    before = [one.false_alarms for one in result.scene().figures]
    result.step(1)
    assert [one.false_alarms for one in result.scene().figures] == [n + 1 for n in before]
    result.step(-1)
    assert [one.false_alarms for one in result.scene().figures] == before


def test_steps_end_where_there_is_nothing_left(result):
    result.put(0.0)
    result.step(-1)
    assert all(one.false_alarms == 0 for one in result.scene().figures)
    result.put(1.0)
    result.step(1)
    assert all(one.false_alarms == one.on for one in result.scene().figures)


def test_the_point_of_one_part_leaves_the_others_where_they_are(result):
    before = result.detector.thresholds.copy()
    result.chosen = 1
    result.put(0.3)
    moved = result.detector.thresholds != before
    assert moved.tolist() == [False, True, False]


def test_mistakes_are_those_at_the_operating_point(result):
    assert {"missed", "called"} & {
        one.said.split()[0].rstrip(",") for one in result.scene().mistakes
    }
    result.put(1.0)
    few = sum("missed" in one.said for one in result.scene().mistakes)
    result.put(0.0)
    said = [one.said for one in result.scene().mistakes]
    assert len(said) > few
    assert all("missed" in one for one in said)


def test_the_area_under_each_curve_is_told(result, trained):
    for figures, question in zip(result.scene().figures, trained.report.questions, strict=False):
        assert figures.area == question.curve.area() > 0.6
        assert f"area under the curve {figures.area:.2f}" in figures.said


def test_parts_judged_no_better_than_by_chance_are_warned_of(result):
    settings = TrainingSettings(folds=2, search_samples=100, from_scratch=True)
    guessed = samples(wrong=0.5)
    lots = TrainingResult(train_on(guessed, settings, lambda *_: None), training_set(guessed))
    assert "No better than chance: head" in lots.scene().warning
    assert "head" not in result.scene().warning
