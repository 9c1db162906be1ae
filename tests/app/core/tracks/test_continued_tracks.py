"""A tracker goes on from corrected tracks at frame 40."""

import numpy as np
import pytest
from two_people import FRAMES, steps, table

from app.core.tracks.live_tracks import ContinuedTracks, LiveTracks
from app.core.tracks.session_tracks import SessionTracks
from tracking.editing import apply_change, plan_delete
from tracking.tracks import Labels

AT = 40


@pytest.fixture
def live():
    return LiveTracks()


@pytest.fixture
def shown(live):
    return ContinuedTracks(SessionTracks(table(), None), AT, live)


def test_before_anything_is_tracked_only_the_corrected_part_is_shown(shown):
    assert shown.ids == [4, 7]
    assert len(shown.of_frame(AT)["track"]) == 0
    assert len(shown.of_frame(AT - 1)["track"]) == 2
    assert shown.frames == (0, AT)
    assert int(shown.spans()[4][-1, 1]) == AT


def test_what_is_tracked_stands_behind_it(shown, live):
    live.extend(steps()[AT:60])
    assert len(shown.of_frame(50)["track"]) == 2
    assert shown.frames == (0, 60)
    assert shown.of_track(4)["frame"].tolist() == list(range(60))
    assert shown.spans()[4].tolist() == [[0, AT, 0], [AT, 60, 0]]


def test_trails_run_across_the_seam(shown, live):
    live.extend(steps()[AT:60])
    rows = shown.recent(45, 10)
    mine = rows["frame"][rows["track"] == 4]
    assert sorted(mine.tolist()) == list(range(35, 46))


def test_everybody_is_counted_once_a_frame(shown, live):
    live.extend(steps()[AT:])
    people = shown.activity(FRAMES)
    assert people.tolist() == [1] * 10 + [2] * (FRAMES - 10)


def test_rows_taken_hold_of_are_those_of_that_moment_from_both_sides(shown, live):
    live.extend(steps()[AT:60])
    read = shown.capture(("frame", "track", "x"))
    live.extend(steps()[60:])
    rows = read()
    assert sorted(rows) == ["frame", "track", "x"]
    assert sorted(rows["frame"][rows["track"] == 4].tolist()) == list(range(60))
    assert np.count_nonzero(rows["track"] == 7) == 50


def test_what_is_edited_meanwhile_is_not_among_the_rows_taken_hold_of():
    corrected = table()
    read = SessionTracks(corrected, None).capture(("frame", "track"))
    apply_change(corrected, Labels(), plan_delete(corrected, 7))
    assert set(read()["track"].tolist()) == {4, 7}


def test_taking_hold_of_rows_reads_no_track(live, monkeypatch):
    before = SessionTracks(table(), None)
    shown = ContinuedTracks(before, AT, live)
    asked = []
    monkeypatch.setattr(before, "of_track", asked.append)
    shown.capture(("frame", "track"))()
    assert asked == []


def test_lanes_of_whoever_did_not_change_stay_the_same(shown, live):
    live.extend(steps()[AT:50])
    assert shown.spans()[4] is shown.spans()[4]
    assert np.array_equal(shown.spans([7])[7], shown.spans()[7])
