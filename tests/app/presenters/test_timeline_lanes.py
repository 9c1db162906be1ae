import numpy as np
import pytest
import two_people

from app.presenters.session_tracks import SessionTracks
from app.presenters.setting import Instant
from app.presenters.timeline import TimelinePresenter

_NO_FRAMES = np.zeros(0, np.int32)


@pytest.fixture
def tracks() -> SessionTracks:
    return SessionTracks(two_people.table(), two_people.run())


@pytest.fixture
def timeline(tracks) -> TimelinePresenter:
    presenter = TimelinePresenter(two_people.FRAMES, 20.0)
    presenter.take(tracks, {7: (50,)})
    return presenter


def _scene(timeline, tracks, frame=0, **known):
    return timeline.scene(frame, Instant(frame, tracks, **known), (0, 0), None)


def test_lanes_stand_by_their_first_frame_with_spans_and_marks(timeline, tracks):
    lanes = _scene(timeline, tracks, names={7: "red coat"}).lanes
    assert [lane.track for lane in lanes] == [4, 7]
    assert lanes[1].label == "7 red coat"
    assert lanes[1].marks == (50,)
    assert lanes[1].spans.tolist() == [[10, 60, 0], [60, 70, 1], [70, 100, 0]]


def test_playing_leaves_lanes_and_activity_the_same_objects(timeline, tracks):
    first, second = (_scene(timeline, tracks, frame) for frame in (3, 4))
    assert first.lanes is second.lanes
    assert first.activity is second.activity


def test_selecting_makes_new_lanes(timeline, tracks):
    first = _scene(timeline, tracks)
    second = _scene(timeline, tracks, selected=7)
    assert first.lanes is not second.lanes
    assert [lane.selected for lane in second.lanes] == [False, True]


def test_an_edit_makes_only_the_lanes_it_touched_anew(timeline, tracks):
    before = _scene(timeline, tracks).lanes
    cut = {8: np.array([[50, 100, 0]]), 7: np.array([[10, 50, 0]])}
    timeline.take_changed((7, 8), cut, (_NO_FRAMES, _NO_FRAMES), {})
    after = {lane.track: lane for lane in _scene(timeline, tracks).lanes}
    assert after[8].spans.tolist() == [[50, 100, 0]]
    assert after[4].spans is before[0].spans


def test_a_track_without_rows_loses_its_lane(timeline, tracks):
    gone = np.arange(10, 100, dtype=np.int32)
    timeline.take_changed((7,), {}, (gone, _NO_FRAMES), {})
    scene = _scene(timeline, tracks)
    assert [lane.track for lane in scene.lanes] == [4]
    assert scene.activity.tolist() == [1] * 100


def test_rows_that_come_and_go_change_the_people_counted(timeline, tracks):
    frames = np.array([3, 3, 5], np.int32), np.array([5, 6], np.int32)
    before = _scene(timeline, tracks).activity.astype(int)
    timeline.take_changed((), {}, (frames[1], frames[0]), {})
    after = _scene(timeline, tracks).activity
    assert (after - before)[[3, 5, 6]].tolist() == [2, 0, -1]
