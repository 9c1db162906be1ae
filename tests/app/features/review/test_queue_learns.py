"""The queue's likelihoods, its order and its words follow what was decided in this session."""

import pytest
from two_people import table as two_people

from app.core.colours.track_colours import TrackColours
from app.features.review.presenter import ReviewQueue, plan_review_verdict
from tracking.editing import apply_change
from tracking.review import ReviewItem
from tracking.tracks import Labels


def _item(kind, frame, likelihood, cost=10.0):
    return ReviewItem(kind, (4,), frame, frame - 5, frame + 5, likelihood, cost, kind, "look")


LOST = tuple(_item("lost", 100 * number, 0.5) for number in range(1, 6))
JUMP = _item("jump", 700, 0.45)


@pytest.fixture
def queue():
    queue = ReviewQueue(10.0, TrackColours().of)
    queue.take((*LOST, JUMP), Labels())
    return queue


def _decided(items, decision):
    labels = Labels()
    for one in items:
        labels = apply_change(two_people(), labels, plan_review_verdict(one, decision, labels))
    return labels


def _likelihoods(queue):
    return {one.frame: one.likelihood for one in queue.open}


def test_false_alarms_of_a_kind_sink_the_rest_of_it_below_the_others(queue):
    assert queue.items[0].key[0] == "lost"
    queue.take_labels(_decided(LOST[:3], "right"))
    left = _likelihoods(queue)
    assert left[400] == pytest.approx(2 / 7)  # Beta(2, 2) and none of three
    assert left[700] == JUMP.likelihood
    assert queue.items[0].key == JUMP.key


def test_it_says_how_many_were_errors_here(queue):
    assert queue.learned_text() == ""
    labels = _decided(LOST[:2], "fixed")
    labels = apply_change(two_people(), labels, plan_review_verdict(LOST[2], "right", labels))
    queue.take_labels(labels)
    queue.choose(LOST[3].key)
    assert queue.learned_text() == "Lost, then found: 2 of 3 were errors here"
    assert queue.learned_texts() == ("Lost, then found: 2 of 3 were errors here",)


def test_what_was_dismissed_says_nothing(queue):
    queue.take_labels(_decided(LOST[:3], "dismissed"))
    assert set(_likelihoods(queue).values()) == {0.5, 0.45}


def test_what_was_corrected_by_hand_was_an_error_and_undo_takes_that_back(queue):
    queue.take_corrected(frozenset({LOST[0].key}), Labels())
    assert _likelihoods(queue)[500] == pytest.approx(3 / 5)
    queue.take_corrected(frozenset(), Labels())
    assert _likelihoods(queue)[500] == 0.5


def test_undoing_a_decision_takes_back_what_was_learnt(queue):
    queue.take_labels(_decided(LOST[:3], "right"))
    queue.take_labels(Labels())
    assert set(_likelihoods(queue).values()) == {0.5, 0.45}


def test_what_was_stated_is_not_learnt_twice_where_all_is_found_anew(queue):
    labels = _decided(LOST[:3], "right")
    queue.take_labels(labels)
    once = _likelihoods(queue)
    queue.take((*LOST, JUMP), labels)
    assert _likelihoods(queue) == once


def test_another_run_s_tracks_are_other_people(queue):
    queue.take_labels(_decided(LOST[:3], "right"))
    queue.forget()
    assert queue.records == {}
    assert queue.open == ()


def test_figures_are_of_what_was_stated_and_of_what_came_of_it(queue):
    assert queue.figures.stated == pytest.approx(5 * 0.5 + 0.45)
    queue.take_labels(_decided(LOST[:2], "fixed"))
    labels = _decided(LOST[:2], "fixed")
    queue.take(LOST[2:], labels)  # put right: not found any more
    figures = queue.figures
    assert (figures.outcome.errors, figures.outcome.stated) == (2, pytest.approx(1.0))
    assert figures.stated == pytest.approx(5 * 0.5)
    assert figures.stated_left == pytest.approx(3 * 0.5)
    assert (figures.found, figures.decided) == (3, ())
