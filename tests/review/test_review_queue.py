"""The queue: decided suspicions leave it, in whatever order it is walked."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.review import Suspicion, open_suspicions, ranked
from tracking.tracks import (
    CORRECTED_COLUMNS,
    Labels,
    ReviewedRange,
    TrackTable,
    Verdict,
    empty,
)

FPS = 20.0


def suspicion(
    kind: str = "turn", tracks: tuple[int, ...] = (1, 2), frame: int = 100, **more: object
) -> Suspicion:
    values = {"likelihood": 0.5, "cost": 10.0, "text": "why", "fix": "swap", **more}
    return Suspicion(kind, tracks, frame, frame - 5, frame + 5, **values)


def labels(*verdicts: Verdict, reviewed: tuple[ReviewedRange, ...] = ()) -> Labels:
    return Labels(verdicts={one.key: one for one in verdicts}, reviewed=reviewed)


@pytest.mark.parametrize("decision", ["right", "fixed", "dismissed"])
def test_a_decided_suspicion_leaves_the_queue(decision: str) -> None:
    left = open_suspicions([suspicion()], labels(Verdict("turn", (1, 2), 100, decision)), FPS)
    assert left == ()


@pytest.mark.parametrize(("frame", "stays"), [(110, False), (120, False), (121, True), (60, True)])
def test_a_verdict_stays_with_what_is_found_again_within_a_second(frame: int, stays: bool) -> None:
    decided = labels(Verdict("turn", (1, 2), 100, "right"))
    assert bool(open_suspicions([suspicion(frame=frame)], decided, FPS)) == stays


def test_a_verdict_says_nothing_of_other_kinds_and_tracks() -> None:
    others = (suspicion(kind="lost"), suspicion(tracks=(1, 3)))
    assert open_suspicions(others, labels(Verdict("turn", (1, 2), 100, "right")), FPS) == others


def test_all_tracks_must_have_been_reviewed_at_that_frame() -> None:
    one = labels(reviewed=(ReviewedRange(1, 0, 200),))
    both = labels(reviewed=(ReviewedRange(1, 0, 200), ReviewedRange(2, 90, 101)))
    everybody = labels(reviewed=(ReviewedRange(0, 100, 101),))
    assert len(open_suspicions([suspicion()], one, FPS)) == 1
    assert open_suspicions([suspicion()], both, FPS) == ()
    assert open_suspicions([suspicion()], everybody, FPS) == ()


def test_a_track_that_was_lost_before_counts_as_reviewed_up_to_its_last_row() -> None:
    columns = empty(CORRECTED_COLUMNS)
    frame = np.array([*range(80, 95), *range(100, 120)], np.int32)
    rows = {name: np.zeros(len(frame), column.dtype) for name, column in columns.items()}
    track = np.where(frame < 95, 1, 2).astype(np.int32)
    table = TrackTable({**rows, "frame": frame, "track": track})
    lost = [suspicion("lost")]
    both = labels(reviewed=(ReviewedRange(1, 80, 95), ReviewedRange(2, 100, 120)))
    early = labels(reviewed=(ReviewedRange(1, 80, 90), ReviewedRange(2, 100, 120)))
    assert open_suspicions(lost, both, FPS, table) == ()
    assert len(open_suspicions(lost, early, FPS, table)) == 1


def test_without_labels_everything_is_open() -> None:
    assert open_suspicions([suspicion()], None, FPS) == (suspicion(),)


def test_the_order_is_by_worth_by_likelihood_or_by_time() -> None:
    cheap = suspicion(frame=1, likelihood=0.9, cost=1.0)
    dear = suspicion(frame=3, likelihood=0.2, cost=100.0)
    middling = suspicion(frame=2, likelihood=0.5, cost=10.0)
    suspicions = [cheap, middling, dear]
    assert ranked(suspicions, "worth") == (dear, middling, cheap)
    assert ranked(suspicions, "likelihood") == (cheap, middling, dear)
    assert ranked(reversed(suspicions), "time") == (cheap, middling, dear)


def stretch(start: int, end: int, likelihood: float) -> Suspicion:
    return Suspicion("turn", (1, 2), start, start, end, likelihood, 1.0, "why", "swap")


def test_most_is_found_for_the_time_watched_by_default() -> None:
    long, short = stretch(0, 100, 0.8), stretch(200, 210, 0.4)
    assert ranked([long, short]) == (short, long)


def test_what_is_watched_already_comes_free() -> None:
    likely, beside = stretch(0, 10, 0.9), stretch(2, 11, 0.1)
    elsewhere = stretch(50, 60, 0.8)
    assert ranked([elsewhere, beside, likely]) == (likely, beside, elsewhere)


spans = st.tuples(st.integers(0, 60), st.integers(1, 25), st.floats(0.01, 1.0))


@given(st.lists(spans, max_size=12))
def test_each_next_one_yields_as_much_as_any_that_is_left(spans: list) -> None:
    order = ranked([stretch(start, start + n, likely) for start, n, likely in spans])
    assert len(order) == len(spans)
    watched: set[int] = set()

    def gain(one: Suspicion) -> float:
        return one.likelihood / max(len(set(range(one.start, one.end)) - watched), 1e-3)

    for number, one in enumerate(order):
        assert gain(one) >= max(map(gain, order[number:])) - 1e-12
        watched |= set(range(one.start, one.end))
