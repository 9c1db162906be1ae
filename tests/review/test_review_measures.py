"""A review is measured: what is found, in how much of the footage."""

from __future__ import annotations

import math

import numpy as np
import pytest
from walks_on_a_floor import Walk, made_run, straight

from tracking.review import ReviewItem, ReviewMeter, review_measures
from tracking.scoring import IdentityError
from tracking.tracks import Labels, TrackTable, Verdict

FRAMES, FPS = 1200, 20.0


def item(tracks: tuple[int, ...], start: int, end: int) -> ReviewItem:
    return ReviewItem("turn", tracks, start, start, end, 0.5, 10.0, "why", "swap")


def error(frame: int, *tracks: int) -> IdentityError:
    return IdentityError(frame, tracks, (1,))


@pytest.fixture
def table() -> TrackTable:
    return TrackTable(made_run([Walk(straight((x, 5), (0, 0), FRAMES)) for x in (0, 3)]).tracks)


def test_an_error_is_found_where_its_moment_is_watched_and_one_of_its_tracks(
    table: TrackTable,
) -> None:
    errors = [error(100, 1, 2), error(100, 3), error(130, 1)]
    measured = review_measures([item((1, 2), 90, 110)], errors, FRAMES, FPS)
    assert (measured.errors, measured.found.tolist()) == (3, [1])


def test_footage_is_the_union_of_the_stretches(table: TrackTable) -> None:
    items = [item((1,), 0, 60), item((2,), 30, 90), item((1,), 0, 120)]
    measured = review_measures(items, [], FRAMES, FPS)
    np.testing.assert_allclose(measured.footage, [0.05, 0.075, 0.1])


def test_recall_counts_what_fits_into_the_footage_allowed(table: TrackTable) -> None:
    items = [item((1,), 0, 60), item((1,), 600, 660), item((1,), 900, 960)]
    errors = [error(30, 1), error(630, 1), error(930, 1), error(400, 1)]
    measured = review_measures(items, errors, FRAMES, FPS)
    assert [measured.recall(share) for share in (0.04, 0.05, 0.1, 1.0)] == [0, 0.25, 0.5, 0.75]


def test_without_errors_there_is_no_recall(table: TrackTable) -> None:
    assert math.isnan(review_measures([], [], FRAMES, FPS).recall(1.0))


def test_the_meter_tells_decisions_and_fixes_a_minute() -> None:
    decisions = ("right", "fixed", "dismissed", "fixed")
    verdicts = [Verdict("turn", (1, 2), at, said) for at, said in enumerate(decisions)]
    labels = Labels(verdicts={one.key: one for one in verdicts})
    meter = ReviewMeter.of(labels, minutes=2.0)
    assert (meter.decided, meter.fixed) == (4, 2)
    assert meter.fixed_per_minute == 1.0
    assert math.isnan(ReviewMeter.of(labels, 0.0).fixed_per_minute)
