"""How far a review is, and how many errors are expected to be left."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from walks_on_a_floor import Walk, made_run, straight

from tracking.review import DecidedItems, ErrorsLeft, ReviewItem, errors_left, reviewed_share
from tracking.review.risk import HIDDEN, SHAPE, SHOWN, WEIGHT
from tracking.tracks import Labels, ReviewedRange, TrackTable

RANGES = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 110), st.integers(1, 60)), max_size=6)


@pytest.fixture(scope="module")
def table() -> TrackTable:
    walks = [Walk(straight((-3, 5), (1, 0), 100)), Walk(straight((-3, 7), (1, 0), 60), start=30)]
    return TrackTable(made_run(walks).tracks)


def item(track: int, start: int, end: int, likelihood: float = 0.5) -> ReviewItem:
    return ReviewItem("jump", (track,), start, start, end, likelihood, 10.0, "", "split")


@given(RANGES, RANGES)
def test_the_share_is_that_of_rows_in_any_range(
    table: TrackTable, marked: list[tuple[int, int, int]], looked: list[tuple[int, int, int]]
) -> None:
    reviewed = tuple(ReviewedRange(track, at, at + length) for track, at, length in marked)
    decided = [item(max(track, 1), at, at + length) for track, at, length in looked]
    columns = table.columns()
    seen = np.zeros(len(table), bool)
    for track, at, length in (*marked, *((max(track, 1), a, n) for track, a, n in looked)):
        inside = (columns["frame"] >= at) & (columns["frame"] < at + length)
        seen |= inside & ((columns["track"] == track) | (track == 0))
    share = reviewed_share(table, Labels(reviewed=reviewed), decided)
    assert share == pytest.approx(seen.mean())


def test_of_no_rows_nothing_is_reviewed() -> None:
    assert reviewed_share(TrackTable(), Labels(reviewed=(ReviewedRange(0, 0, 9),))) == 0.0


def test_before_any_decision_errors_go_with_what_is_stated() -> None:
    begun = errors_left(10.0, DecidedItems(), 10.0)
    assert begun.mean == pytest.approx(10 * (SHOWN + HIDDEN))
    assert begun.low < begun.mean < begun.high


def test_decisions_teach_how_many_there_are_and_narrow_the_range() -> None:
    stated = 10.0
    many = errors_left(5.0, DecidedItems(5.0, 10), stated)
    few = errors_left(5.0, DecidedItems(5.0, 0), stated)
    usual = errors_left(5.0, DecidedItems(5.0, round(5 * SHOWN)), stated)
    assert few.mean < usual.mean < many.mean
    # A Gamma prior, and ten errors of weight where SHOWN x 5 were expected.
    rate = (SHAPE + 10 * WEIGHT) / (SHAPE + 5 * SHOWN * WEIGHT)
    assert many.mean == pytest.approx(rate * (5 * SHOWN + 10 * HIDDEN))
    before = errors_left(5.0, DecidedItems(), stated)
    assert (usual.high - usual.low) / usual.mean < (before.high - before.low) / before.mean


def test_where_all_is_decided_and_reviewed_nothing_is_left() -> None:
    assert errors_left(0.0, DecidedItems(9.0, 5), 0.0) == ErrorsLeft(0.0, 0, 0)


def test_where_all_items_are_decided_errors_that_no_item_shows_may_be_left() -> None:
    done = errors_left(0.0, DecidedItems(10.0, 10), 10.0)
    assert done.mean > 0
    assert errors_left(0.0, DecidedItems(10.0, 10), 5.0).mean == pytest.approx(done.mean / 2)
