"""The queue: decided review items leave it, in whatever order it is walked."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.review import ReviewItem, filter_undecided, rank
from tracking.tracks import (
    CORRECTED_COLUMNS,
    Labels,
    ReviewedRange,
    TrackTable,
    Verdict,
    empty,
)

FPS = 20.0


def item(
    kind: str = "turn", tracks: tuple[int, ...] = (1, 2), frame: int = 100, **more: object
) -> ReviewItem:
    values = {"likelihood": 0.5, "cost": 10.0, "text": "why", "fix": "swap", **more}
    return ReviewItem(kind, tracks, frame, frame - 5, frame + 5, **values)


def labels(*verdicts: Verdict, reviewed: tuple[ReviewedRange, ...] = ()) -> Labels:
    return Labels(verdicts={one.key: one for one in verdicts}, reviewed=reviewed)


@pytest.mark.parametrize("decision", ["right", "fixed", "dismissed"])
def test_a_decided_review_item_leaves_the_queue(decision: str) -> None:
    left = filter_undecided([item()], labels(Verdict("turn", (1, 2), 100, decision)), FPS)
    assert left == ()


@pytest.mark.parametrize(("frame", "stays"), [(110, False), (120, False), (121, True), (60, True)])
def test_a_verdict_stays_with_what_is_found_again_within_a_second(frame: int, stays: bool) -> None:
    decided = labels(Verdict("turn", (1, 2), 100, "right"))
    assert bool(filter_undecided([item(frame=frame)], decided, FPS)) == stays


def test_a_verdict_says_nothing_of_other_kinds_and_tracks() -> None:
    others = (item(kind="lost"), item(tracks=(1, 3)))
    assert filter_undecided(others, labels(Verdict("turn", (1, 2), 100, "right")), FPS) == others


def test_all_tracks_must_have_been_reviewed_at_that_frame() -> None:
    one = labels(reviewed=(ReviewedRange(1, 0, 200),))
    both = labels(reviewed=(ReviewedRange(1, 0, 200), ReviewedRange(2, 90, 101)))
    everybody = labels(reviewed=(ReviewedRange(0, 100, 101),))
    assert len(filter_undecided([item()], one, FPS)) == 1
    assert filter_undecided([item()], both, FPS) == ()
    assert filter_undecided([item()], everybody, FPS) == ()


def test_a_track_that_was_lost_before_counts_as_reviewed_up_to_its_last_row() -> None:
    columns = empty(CORRECTED_COLUMNS)
    frame = np.array([*range(80, 95), *range(100, 120)], np.int32)
    rows = {name: np.zeros(len(frame), column.dtype) for name, column in columns.items()}
    track = np.where(frame < 95, 1, 2).astype(np.int32)
    table = TrackTable({**rows, "frame": frame, "track": track})
    lost = [item("lost")]
    both = labels(reviewed=(ReviewedRange(1, 80, 95), ReviewedRange(2, 100, 120)))
    early = labels(reviewed=(ReviewedRange(1, 80, 90), ReviewedRange(2, 100, 120)))
    assert filter_undecided(lost, both, FPS, table) == ()
    assert len(filter_undecided(lost, early, FPS, table)) == 1


def test_without_labels_everything_is_open() -> None:
    assert filter_undecided([item()], None, FPS) == (item(),)


def test_the_order_is_by_worth_by_likelihood_or_by_time() -> None:
    cheap = item(frame=1, likelihood=0.9, cost=1.0)
    dear = item(frame=3, likelihood=0.2, cost=100.0)
    middling = item(frame=2, likelihood=0.5, cost=10.0)
    items = [cheap, middling, dear]
    assert rank(items, "worth") == (dear, middling, cheap)
    assert rank(items, "likelihood") == (cheap, middling, dear)
    assert rank(reversed(items), "time") == (cheap, middling, dear)


def stretch(start: int, end: int, likelihood: float) -> ReviewItem:
    return ReviewItem("turn", (1, 2), start, start, end, likelihood, 1.0, "why", "swap")


def test_most_is_found_for_the_time_watched_by_default() -> None:
    long, short = stretch(0, 100, 0.8), stretch(200, 210, 0.4)
    assert rank([long, short]) == (short, long)


def test_what_is_watched_already_comes_free() -> None:
    likely, beside = stretch(0, 10, 0.9), stretch(2, 11, 0.1)
    elsewhere = stretch(50, 60, 0.8)
    assert rank([elsewhere, beside, likely]) == (likely, beside, elsewhere)


spans = st.tuples(st.integers(0, 60), st.integers(1, 25), st.floats(0.01, 1.0))


@given(st.lists(spans, max_size=12))
def test_each_next_one_yields_as_much_as_any_that_is_left(spans: list) -> None:
    order = rank([stretch(start, start + n, likely) for start, n, likely in spans])
    assert len(order) == len(spans)
    watched: set[int] = set()

    def gain(one: ReviewItem) -> float:
        return one.likelihood / max(len(set(range(one.start, one.end)) - watched), 1e-3)

    for number, one in enumerate(order):
        assert gain(one) >= max(map(gain, order[number:])) - 1e-12
        watched |= set(range(one.start, one.end))
