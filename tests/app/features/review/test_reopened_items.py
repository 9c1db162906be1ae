"""Decided review items that an edit opened again are counted."""

from dataclasses import replace

from two_people import table as two_people

from app.features.review.presenter import ReviewQueue, plan_review_verdict
from app.features.review.reopened_items import count_reopened
from tracking.editing import apply_change
from tracking.review import ReviewFinding, ReviewItem
from tracking.tracks import Labels

LOST = ReviewItem("lost", (4, 7), 100, 95, 105, 0.5, 10.0, "lost", "look")
JUMP = ReviewItem("jump", (5,), 300, 295, 305, 0.5, 10.0, "jump", "look")
SWAPPED = replace(LOST, tracks=(4, 9), frame=104)


def test_an_item_that_goes_by_other_ids_after_an_edit_is_open_again():
    queue = ReviewQueue(10.0, lambda _: (0, 0, 0))
    decided = plan_review_verdict(LOST, "dismissed", Labels())
    labels = apply_change(two_people(), Labels(), decided)
    queue.take(ReviewFinding((LOST, JUMP)), labels)
    assert [one.key for one in queue.open] == [JUMP.key]
    queue.take(ReviewFinding((SWAPPED, JUMP)), labels)
    assert queue.reopened == 1
    queue.take(ReviewFinding((SWAPPED, JUMP)), labels)
    assert queue.reopened == 0


def test_new_items_elsewhere_and_decided_ones_that_are_gone_are_none():
    assert count_reopened(((LOST,), ()), ((), (JUMP,)), 10.0) == 0
    assert count_reopened(((LOST,), (JUMP,)), ((LOST,), (JUMP, SWAPPED)), 10.0) == 0
    assert count_reopened(((LOST,), (SWAPPED,)), ((), (SWAPPED,)), 10.0) == 0
