from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import two_people

from app.core.document.edit_history import EditMarks
from app.core.scenes import MarkKind, SpanKind, TimelineMark
from app.core.tracks.frame_state import FrameState
from app.core.tracks.session_tracks import SessionTracks
from app.features.timeline.lane_marks import shown_marks
from app.features.timeline.presenter import TimelinePresenter
from tracking.editing import (
    History,
    apply_change,
    plan_delete,
    plan_label_part,
    plan_split,
    plan_swap,
)
from tracking.session import Session
from tracking.tracks import Labels, PartLabel, ReviewedRange, Source, TrackTable

_NO_FRAMES = np.zeros(0, np.int32)
_EDIT = TimelineMark(MarkKind.EDIT, 50, 7, "Split 7")


@pytest.fixture
def table() -> TrackTable:
    return two_people.table()


@pytest.fixture
def tracks(table) -> SessionTracks:
    return SessionTracks(table, two_people.run())


@pytest.fixture
def timeline(tracks) -> TimelinePresenter:
    presenter = TimelinePresenter(two_people.FRAMES, 20.0)
    presenter.take(tracks, {7: (_EDIT,)})
    return presenter


def _scene(timeline, tracks, frame=0, **known):
    return timeline.scene(frame, FrameState(frame, tracks, **known), (0, 0), None)


def _edit(timeline, tracks, table, change):
    apply_change(table, Labels(), change)
    frames = change.before.rows["frame"], change.after.rows["frame"]
    timeline.take_changed(change.tracks, tracks, frames, {})


def test_lanes_stand_by_their_first_frame_with_spans_and_marks(timeline, tracks):
    lanes = _scene(timeline, tracks, names={7: "red coat"}).lanes
    assert [lane.track for lane in lanes] == [4, 7]
    assert lanes[1].label == "7 red coat"
    assert lanes[1].marks == (_EDIT,)
    assert lanes[1].spans.tolist() == [[10, 60, 0], [60, 70, 1], [70, 100, 0]]


def test_playing_leaves_lanes_and_activity_the_same_objects(timeline, tracks):
    first, second = (_scene(timeline, tracks, frame) for frame in (3, 4))
    assert first.lanes is second.lanes
    assert first.activity is second.activity
    assert first.review_items is second.review_items


def test_selecting_makes_new_lanes(timeline, tracks):
    first = _scene(timeline, tracks)
    second = _scene(timeline, tracks, selected=7)
    assert first.lanes is not second.lanes
    assert [lane.selected for lane in second.lanes] == [False, True]


def test_an_edit_makes_only_the_lanes_it_touched_anew(timeline, tracks, table):
    before = _scene(timeline, tracks).lanes
    _edit(timeline, tracks, table, plan_split(table, 7, 50))
    after = {lane.track: lane for lane in _scene(timeline, tracks).lanes}
    assert after[8].spans.tolist() == [[50, 60, 0], [60, 70, 1], [70, 100, 0]]
    assert after[4] is before[0]


def test_lanes_after_an_edit_are_those_of_a_fresh_start(timeline, tracks, table):
    _scene(timeline, tracks)
    _edit(timeline, tracks, table, plan_swap(table, 4, 7, 50))
    fresh = TimelinePresenter(two_people.FRAMES, 20.0)
    fresh.take(tracks, {})
    for lane, other in zip(
        _scene(timeline, tracks).lanes, _scene(fresh, tracks).lanes, strict=True
    ):
        assert lane.track == other.track
        assert lane.spans.tolist() == other.spans.tolist()


def test_a_track_without_rows_loses_its_lane(timeline, tracks, table):
    _edit(timeline, tracks, table, plan_delete(table, 7, 0))
    scene = _scene(timeline, tracks)
    assert [lane.track for lane in scene.lanes] == [4]
    assert scene.activity.tolist() == [1] * 100


def test_rows_that_come_and_go_change_the_people_counted(timeline, tracks):
    frames = np.array([3, 3, 5], np.int32), np.array([5, 6], np.int32)
    before = _scene(timeline, tracks).activity.astype(int)
    timeline.take_changed((), tracks, (frames[1], frames[0]), {})
    after = _scene(timeline, tracks).activity
    assert (after - before)[[3, 5, 6]].tolist() == [2, 0, -1]


def test_interpolated_stretches_and_keyframes_are_told_apart():
    rows = two_people.columns(20, (4, 7))
    source = np.full(len(rows["frame"]), Source.INTERPOLATED, np.uint8)
    source[rows["track"] == 7] = Source.TRACKER
    source[(rows["track"] == 4) & np.isin(rows["frame"], [0, 10, 19])] = Source.PERSON
    tracks = SessionTracks(TrackTable({**rows, "source": source}), None)
    presenter = TimelinePresenter(20, 20.0)
    presenter.take(tracks, {})
    made, seen = _scene(presenter, tracks).lanes
    assert made.keyframes.tolist() == [0, 10, 19]
    assert made.spans[1].tolist() == [1, 10, SpanKind.INTERPOLATED]
    assert seen.keyframes.tolist() == []


def test_review_items_stand_in_their_lanes_until_others_take_their_place(timeline, tracks):
    first = _scene(timeline, tracks)
    doubt = TimelineMark(MarkKind.REVIEW_ITEM, 20, 7, "likely swap")
    timeline.take_review_items([doubt])
    marked = _scene(timeline, tracks)
    assert marked.lanes[1].marks == (doubt, _EDIT)
    assert marked.lanes[0] is first.lanes[0]
    assert marked.review_items == (doubt,)
    timeline.take_review_items([])
    after = _scene(timeline, tracks)
    assert after.review_items == ()
    assert after.lanes[1].marks == (_EDIT,)


def test_reviewed_ranges_of_a_track_are_in_its_lane_and_those_of_all_in_the_scene(timeline, tracks):
    timeline.take_reviewed((ReviewedRange(0, 0, 30), ReviewedRange(7, 40, 60)))
    scene = _scene(timeline, tracks)
    assert scene.reviewed == ((0, 30),)
    assert [lane.reviewed for lane in scene.lanes] == [(), ((40, 60),)]


def test_edits_are_marked_while_they_are_in_force(table, tmp_path):
    footage = SimpleNamespace(
        folder=tmp_path,
        name="n",
        fps=20.0,
        frame_count=100,
        size=(64, 48),
        is_stereo=False,
        manifest_text="",
        own_manifest=True,
        calibration_text="",
        fingerprints=tuple,
    )
    marks, session = EditMarks(), Session.create(footage, [two_people.run()])
    session.apply(plan_swap(session.tracks, 4, 7, 50))
    session.apply(plan_split(session.tracks, 7, 80))
    kinds = {track: [one.kind for one in own] for track, own in marks.of(session.history).items()}
    assert kinds == {4: [MarkKind.SWAP], 7: [MarkKind.SWAP, MarkKind.EDIT], 8: [MarkKind.EDIT]}
    session.undo()
    session.undo()
    assert marks.of(session.history) == {}
    session.redo()
    assert set(marks.of(session.history)) == {4, 7}


def test_an_edit_of_many_tracks_is_marked_where_it_first_touches_each():
    frames = ((20, 4), (30, 4), (60, 7))
    box = (1.0, 2.0, 3.0, 4.0)
    labels = [PartLabel(frame, track, 0, box, True) for frame, track in frames]
    history, change = History(), plan_label_part(Labels(), labels)
    history.add(history.draft(change, "2020-01-01T00:00:00.000+00:00", "somebody"), change)
    marks = EditMarks().of(history)
    assert {track: [one.frame for one in own] for track, own in marks.items()} == {4: [20], 7: [60]}


def test_an_edit_is_not_marked_on_a_lane_that_ends_before_it(tracks):
    presenter = TimelinePresenter(two_people.FRAMES, 20.0)
    last = int(tracks.spans()[7][-1, 1])
    reached, beyond = (TimelineMark(MarkKind.SWAP, f, 7, "Swap 4 and 7") for f in (last, last + 1))
    presenter.take(tracks, {7: (reached, beyond)})
    (lane,) = (one for one in _scene(presenter, tracks).lanes if one.track == 7)
    assert lane.marks == (reached,)


def test_a_frame_bears_one_mark_of_an_edit_its_keyframe(timeline, tracks):
    lane = _scene(timeline, tracks).lanes[1]
    assert shown_marks(lane) == [_EDIT]
    swap = TimelineMark(MarkKind.SWAP, 50, 7, "Swap 4 and 7")
    made = replace(lane, keyframes=np.array([50]), marks=(_EDIT, swap))
    assert shown_marks(made) == [swap]
