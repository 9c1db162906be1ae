from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.features.review.review_meter import _corrections
from app.features.review.watched_ranges import WatchedRanges
from tracking.editing import History, plan_draw_box
from tracking.tracks import TrackTable

FPS = 10.0


@pytest.fixture
def watching():
    return WatchedRanges(1000, FPS)


def _see(watching, *frames):
    for frame in frames:
        watching.saw(frame)


def test_playing_on_makes_one_stretch(watching):
    _see(watching, *range(100, 131))
    assert watching.stretch == (100, 131)


def test_frames_left_out_by_fast_playing_belong_to_it(watching):
    _see(watching, 100, 108, 116)
    assert watching.stretch == (100, 117)


def test_a_jump_begins_another_stretch(watching):
    _see(watching, *range(100, 131), 500, 501)
    assert watching.stretch == (500, 502)


def test_one_frame_alone_was_not_watched(watching):
    _see(watching, 100, 500)
    assert watching.stretch == (0, 0)
    assert watching.minutes == 0.0


def test_what_was_seen_twice_counts_once(watching):
    _see(watching, *range(600), *range(599, -1, -1))
    assert watching.minutes == pytest.approx(1.0)
    assert watching.stretch == (0, 600)


@given(st.lists(st.integers(0, 999), min_size=1, max_size=60))
def test_the_stretch_holds_the_frame_that_is_shown(frames):
    watching = WatchedRanges(1000, FPS)
    _see(watching, *frames)
    start, end = watching.stretch
    assert (start, end) == (0, 0) or start <= frames[-1] < end


@pytest.mark.parametrize("kind", ["label", "unlabel", "occluders", "lines", "regions", "rename"])
def test_labels_are_no_corrections_of_tracks(kind):
    log = _log(kind, "swap")
    assert len(_corrections(log)) == 1


def test_an_edit_taken_back_alone_is_no_correction_and_nor_is_taking_it_back():
    log = _log("split", "rename")
    change = log.entry(1).change
    log.add(log.draft(replace(change.inverse, kind="undo"), "2026-01-01", "ann", undoes=1))
    assert not _corrections(log)


def _log(*kinds):
    """A history with an edit of each kind."""
    log = History()
    for kind in kinds:
        change = replace(plan_draw_box(TrackTable(), None, 0, (1.0, 2.0, 3.0, 4.0)), kind=kind)
        log.add(log.draft(change, "2026-01-01", "ann"))
    return log
