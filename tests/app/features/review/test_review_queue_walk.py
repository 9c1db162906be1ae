import pytest
from two_people import table as two_people

from app.core.colours.track_colours import TrackColours
from app.core.scenes import MarkKind
from app.features.review.presenter import (
    ReviewQueue,
    is_fixable,
    kind_title,
    plan_review_verdict,
    with_fixed_verdict,
)
from app.features.review.scene import Order
from tracking.editing import apply_change, plan_mark_reviewed, plan_swap
from tracking.review import ReviewFinding, ReviewItem
from tracking.review.reason_phrases import KINDS, sentence
from tracking.tracks import Labels
from tracking.translation import tr

FPS = 10.0


def _review_item(kind, tracks, frame, worth, fix="swap"):
    text = f"{kind} of {tracks}"
    return ReviewItem(kind, tracks, frame, frame - 5, frame + 5, 0.5, worth, text, fix)


CROSSING = _review_item("crossing", (4, 7), 50, 30.0)
JUMP = _review_item("jump", (4,), 20, 20.0, "split")
MARGIN = _review_item("margin", (7,), 80, 10.0, "look")


@pytest.fixture
def queue():
    queue = ReviewQueue(FPS, TrackColours().of)
    queue.take(ReviewFinding((CROSSING, JUMP, MARGIN)), Labels())
    return queue


def _listed(queue):
    return [item.key for item in queue.items]


def _walked(queue, *steps):
    return [queue.walk(step).key for step in steps]


def test_the_most_worth_looking_at_stands_first_and_time_can_be_asked_for(queue):
    assert _listed(queue) == [CROSSING.key, JUMP.key, MARGIN.key]
    queue.sort(Order.TIME)
    assert _listed(queue) == [JUMP.key, CROSSING.key, MARGIN.key]


def test_the_walk_begins_at_the_first_and_goes_around(queue):
    assert _walked(queue, 1, 1, 1, 1) == [CROSSING.key, JUMP.key, MARGIN.key, CROSSING.key]
    assert queue.walk(-1) == MARGIN


def test_the_walk_back_begins_at_the_last(queue):
    assert queue.walk(-1) == MARGIN


def test_one_whose_decision_was_undone_is_returned_to_though_another_kind_is_listed(queue):
    queue.narrow("jump")
    assert queue.return_to(CROSSING.key) == CROSSING
    assert CROSSING.key in _listed(queue)


def test_returning_does_not_take_another_one_of_the_same_two_far_away(queue):
    far = ("crossing", (4, 7), CROSSING.frame + int(FPS) + 1)
    near = ("crossing", (4, 7), CROSSING.frame + int(FPS))
    assert queue.return_to(far) is None
    assert queue.return_to(near) == CROSSING


def test_after_a_decision_the_next_one_is_what_took_its_place(queue):
    queue.walk(1)
    change = plan_review_verdict(CROSSING, "right", Labels())
    labels = apply_change(two_people(), Labels(), change)
    queue.take_labels(labels)
    assert queue.current is None
    assert _listed(queue) == [JUMP.key, MARGIN.key]
    assert queue.walk(1) == JUMP


def test_the_one_looked_at_stays_so_when_all_are_found_anew(queue):
    queue.walk(1)
    queue.take(ReviewFinding((MARGIN, _review_item("jump", (7,), 33, 99.0), CROSSING)), Labels())
    assert queue.current == CROSSING
    assert queue.place == 1


def test_one_kind_alone_can_be_listed_and_all_come_back_when_it_is_done(queue):
    queue.narrow("jump")
    assert _listed(queue) == [JUMP.key]
    assert [(one.kind, one.count) for one in queue.kinds()] == [
        ("margin", 1),
        ("jump", 1),
        ("crossing", 1),
    ]
    labels = apply_change(two_people(), Labels(), plan_review_verdict(JUMP, "dismissed", Labels()))
    queue.take_labels(labels)
    assert queue.kind == ""
    assert _listed(queue) == [CROSSING.key, MARGIN.key]


def test_what_was_reviewed_is_not_listed(queue):
    labels = apply_change(two_people(), Labels(), plan_mark_reviewed(Labels(), 7, 70, 90))
    queue.take_labels(labels)
    assert MARGIN.key not in _listed(queue)
    assert len(queue.open) == 2


def test_rows_say_who_and_when_with_their_names(queue):
    queue.take_names({7: "red coat"})
    item = queue.items[0]
    assert [person.label for person in item.people] == ["4", "7 red coat"]
    assert item.when == "00:05.00"
    assert item.why == CROSSING.text


def test_everybody_a_review_item_is_about_gets_a_mark_on_their_lane(queue):
    marks = {(mark.track, mark.frame) for mark in queue.marks()}
    assert marks == {(4, 50), (7, 50), (4, 20), (7, 80)}
    assert {mark.kind for mark in queue.marks()} == {MarkKind.REVIEW_ITEM}


def test_a_fix_and_its_verdict_are_one_edit():
    table, labels = two_people(), Labels()
    swap = plan_swap(table, 4, 7, 50)
    change = with_fixed_verdict(swap, CROSSING, labels)
    after = apply_change(table, labels, change)
    assert after.verdicts[CROSSING.key].decision == "fixed"
    before = apply_change(table, after, change.inverse)
    assert before == labels


def test_only_what_has_an_edit_can_be_fixed():
    assert [is_fixable(one) for one in (CROSSING, JUMP, MARGIN)] == [True, True, False]


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_has_words_of_its_own(kind):
    assert kind_title(kind) != kind.capitalize()


@pytest.mark.usefixtures("pseudo")
def test_reasons_and_verdicts_are_shown_in_the_users_language_and_kept_in_english():
    said = sentence("crossing", 4, 7, 0.3, 41.0)
    item = ReviewItem("crossing", (4, 7), 50, 45, 55, 0.5, 30.0, said, "swap", (said,))
    shown = "⟦4 and 7 passed within ⟦0.3 m⟧ at 00:41.00⟧"
    queue = ReviewQueue(FPS, TrackColours().of)
    queue.take(ReviewFinding((item,)), Labels())
    assert (queue.items[0].why, queue.items[0].others) == (shown, (shown,))
    assert queue.marks()[0].text == f"⟦Paths cross⟧: {shown}"
    text = plan_review_verdict(item, "dismissed", Labels()).text
    assert text == "Dismiss: Paths cross 4, 7 in frame 50"
    assert tr(text) == "⟦Dismiss⟧: ⟦⟦Paths cross⟧ 4, 7 in frame 50⟧"
