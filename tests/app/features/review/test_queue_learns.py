"""The queue's likelihoods, its order and its words follow what was decided in this session."""

import numpy as np
import pytest
from two_people import table as two_people

from app.core.colours.track_colours import TrackColours
from app.features.review.presenter import ReviewQueue, plan_review_verdict, settles
from app.features.review.progress_words import learned_text
from app.features.review.review_meter import MeterWords
from tracking.editing import Change, History, State, apply_change
from tracking.review import DecidedItems, ReviewFinding, ReviewItem
from tracking.tracks import Labels


def _item(kind, frame, likelihood, cost=10.0):
    return ReviewItem(kind, (4,), frame, frame - 5, frame + 5, likelihood, cost, kind, "look")


LOST = tuple(_item("lost", 100 * number, 0.5) for number in range(1, 6))
JUMP = _item("jump", 700, 0.45)


@pytest.fixture
def queue():
    queue = ReviewQueue(10.0, TrackColours().of)
    queue.take(ReviewFinding((*LOST, JUMP)), Labels())
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


def test_undoing_a_decision_takes_back_what_was_learnt(queue):
    queue.take_labels(_decided(LOST[:3], "right"))
    queue.take_labels(Labels())
    assert set(_likelihoods(queue).values()) == {0.5, 0.45}


def test_what_was_stated_is_not_learnt_twice_where_all_is_found_anew(queue):
    labels = _decided(LOST[:3], "right")
    queue.take_labels(labels)
    once = _likelihoods(queue)
    queue.take(ReviewFinding((*LOST, JUMP)), labels)
    assert _likelihoods(queue) == once


def test_another_run_s_tracks_are_other_people(queue):
    queue.take_labels(_decided(LOST[:3], "right"))
    queue.forget()
    assert queue.records == {}
    assert queue.open == ()


def _figures(queue):
    state = queue.state
    return state.records, state.outcome, state.decided, state.items, state.errors


def test_opened_again_a_session_has_the_same_list_and_the_same_figures():
    sitting, reopened = (ReviewQueue(10.0, TrackColours().of) for _ in range(2))
    begun = (*LOST, JUMP)
    sitting.take(ReviewFinding(begun, begun), Labels())
    labels = _decided(LOST[:2], "fixed")
    labels = apply_change(two_people(), labels, plan_review_verdict(LOST[2], "right", labels))
    sitting.take_labels(labels)
    left = (*LOST[2:], JUMP)  # put right: not found any more
    sitting.take(ReviewFinding(left, begun), labels)
    reopened.take(ReviewFinding(left, begun), labels)
    assert _figures(sitting) == _figures(reopened)
    assert [row.key for row in sitting.items] == [row.key for row in reopened.items]
    assert (sitting.state.decided, sitting.state.items) == (3, 6)
    assert (sitting.state.outcome.errors, sitting.state.outcome.stated) == (2, 1.5)


def _edit(kind, tracks, frame):
    rows = {"frame": np.full(len(tracks), frame, np.int32), "track": np.array(tracks, np.int32)}
    return Change(kind, kind, frame, State(rows=rows), State(rows=rows))


@pytest.mark.parametrize(
    ("kind", "tracks", "frame", "settled"),
    [
        ("swap", (4, 7), 100, True),
        ("swap", (4, 7), 114, True),  # less than a second after what is shown
        ("swap", (4, 7), 115, False),
        ("swap", (4, 9), 100, False),  # with somebody else
        ("split", (4,), 100, False),  # a first step at most
        ("rename", (4, 7), 100, False),
    ],
)
def test_an_edit_by_hand_settles_an_item_that_asks_for_it(kind, tracks, frame, settled):
    item = ReviewItem("turn", (4, 7), 100, 95, 105, 0.5, 9.0, "turn", "swap")
    assert settles(_edit(kind, tracks, frame), item, 10.0) == settled
    unsure = ReviewItem("turn", (4, 7), 100, 95, 105, 0.5, 9.0, "turn", "look")
    also = settled or kind == "split"
    assert settles(_edit(kind, tracks, frame), unsure, 10.0) == also


@pytest.mark.parametrize(
    ("minutes", "said"), [(0.0, "0 s"), (10 / 60, "10 s"), (0.001, "1 s"), (1.25, "1.2 min")]
)
def test_what_was_watched_is_told_in_seconds_below_a_minute(minutes, said):
    labels, history = _decided(LOST[:1], "right"), History()
    meter = MeterWords(Labels(), history)
    assert meter.text(Labels(), history, minutes) == ""
    assert meter.text(labels, history, minutes).startswith(f"Since it was opened: {said} watched")


def test_why_more_or_fewer_errors_are_expected_is_told():
    more, usual, fewer = (DecidedItems(*one) for one in ((0.2, 2), (2.0, 2), (5.0, 0)))
    assert learned_text(more).startswith("More decided items were errors than stated")
    assert learned_text(usual) == ""
    assert learned_text(fewer).startswith("Fewer decided items")
