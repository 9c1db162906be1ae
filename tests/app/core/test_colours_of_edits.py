"""Whoever comes up by an edit has a colour of their own, and looking at an edit gives none."""

import shutil
from contextlib import closing
from dataclasses import replace

import numpy as np
import pytest

from app.core.colours import track_colours
from app.core.colours.palette import TRACK_COLOURS, usual_place
from app.core.colours.track_colours import TrackColours
from app.core.document import document_loader
from app.core.document.document import Document
from app.core.editing import edits
from app.core.tracks import session_colours
from app.shell.recording_scenes import RecordingScenes
from tracking.editing import plan_put_box, plan_reassign, plan_split
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import SIGNAL_COLUMNS, TRACK_COLUMNS, empty

USUAL_OF = {number: TRACK_COLOURS[usual_place(number)] for number in range(1, 60)}
STAYS = {1: (0, 60), 2: (50, 70), 25: (0, 70)}
"""Frames in which each stands; 26, who comes next, would look like 2."""


def _document(recording, run, stays, path):
    frames = np.concatenate([np.arange(*stay) for stay in stays.values()])
    tracks = np.concatenate([np.full(b - a, one) for one, (a, b) in stays.items()])
    order = np.lexsort((tracks, frames))
    rows = {name: np.zeros(len(order), kind) for name, kind in TRACK_COLUMNS.items()}
    rows["frame"], rows["track"] = frames[order].astype("i4"), tracks[order].astype("i4")
    rows["x"], rows["y"] = rows["track"] * np.float32(0.1), np.full(len(order), 4, "f4")
    rows["width"], rows["height"] = np.full((2, len(order)), 20, "f4")
    of_these = replace(run, tracks=rows, signals=empty(SIGNAL_COLUMNS))
    return Document(recording, Session.create(recording, [of_these], path))


@pytest.fixture
def recording(tiny_recording):
    with open_recording(tiny_recording) as recording:
        yield recording


@pytest.fixture
def document(recording, tiny_run, tmp_path):
    document = _document(recording, tiny_run, STAYS, tmp_path / "three.h5")
    yield document
    document.session.close()


def test_a_crowd_has_its_colours_later_however_short_it_is_there(recording, tiny_run, tmp_path):
    crowd = dict.fromkeys(range(1, 31), (0, 80))
    opened = _document(recording, tiny_run, crowd, tmp_path / "crowd.h5")
    assert opened.colours_due is None  # another thread opens it
    document = Document(recording)
    opened.session.colours = {}  # as one that nobody has looked at yet
    document.take_session(opened.session)
    due = document.colours_due
    document.session.close()
    assert due is not None
    assert due.make().of(25) != due.make().of(1)


def _colours(document, *tracks):
    return [document.colour_of(track) for track in tracks]


def test_who_is_split_off_differs_from_who_it_was_cut_from_and_from_who_is_there(document):
    assert USUAL_OF[26] == USUAL_OF[2]
    document.apply(plan_split(document.session.tracks, 1, 30))
    assert len(set(_colours(document, 1, 2, 25, 26))) == 4


def test_an_edit_takes_no_colour_from_anybody_who_had_one(document):
    before = _colours(document, 1, 2, 25)
    document.apply(plan_split(document.session.tracks, 1, 30))
    document.apply(plan_split(document.session.tracks, 25, 55))
    assert _colours(document, 1, 2, 25) == before


def test_who_is_given_a_new_id_differs_as_well(document):
    document.apply(plan_reassign(document.session.tracks, 1, 26, 20, 60))
    assert len(set(_colours(document, 1, 2, 25, 26))) == 4


def test_a_new_colour_stays_when_its_edit_is_undone_and_done_again(document):
    document.apply(plan_split(document.session.tracks, 1, 30))
    before = _colours(document, 1, 2, 25, 26)
    document.undo()
    document.redo()
    assert _colours(document, 1, 2, 25, 26) == before


def _look_at_a_split(document, at):
    document.selection.choose(1)
    document.correcting.begin(edits.SPLIT, at)
    return document.frame_state(at).colours


def test_an_edit_that_waits_shows_the_colour_its_new_id_will_have(document):
    shown = _look_at_a_split(document, 30).of(26)
    document.confirm_edit()
    assert document.colour_of(26) == shown != USUAL_OF[26]


def test_an_edit_that_was_left_has_given_no_colour(document):
    _look_at_a_split(document, 30)
    document.correcting.leave()
    assert not document.frame_state(30).colours.has(26)


def test_an_edit_that_waits_leaves_the_colours_of_the_lanes_as_they_are(document):
    scenes = RecordingScenes(document)
    lanes = scenes.timeline(30, 30).lanes
    _look_at_a_split(document, 30)
    shown = scenes.timeline(30, 30).lanes
    assert [one.track for one in shown] == [one.track for one in lanes]
    assert all(a is b for a, b in zip(lanes, shown, strict=True) if a.track != 1)


def test_when_many_come_up_at_once_their_colours_are_made_later(document):
    table = document.session.tracks
    document.session.apply(plan_split(table, 25, 30))
    for frame in range(2, 12):
        document.session.apply(plan_split(table, 26 if frame == 2 else 24 + frame, 30 + frame))
    document._track_source.session_colours.meet(table, table.track_ids)
    due = document.colours_due
    assert due is not None
    assert document.take_colours(due, due.make())
    assert document.colours_due is None
    last = table.track_ids[-1]
    assert len(set(_colours(document, 1, 2, last))) == 3


def test_an_edit_that_waits_has_the_colours_that_came_meanwhile(document):
    _look_at_a_split(document, 30)
    own = document._track_source.session_colours
    before = document.frame_state(30).colours
    own.now = own.now.copy()
    assert document.frame_state(30).colours is not before


def test_a_run_that_goes_on_and_is_not_kept_gives_no_colour(document):
    rows = document.session.tracks.of_frame(55)
    new = {**rows, "track": np.where(rows["track"] == 1, 26, rows["track"]).astype("i4")}
    document._track_source.begin_live(50)
    document._track_source._live_colours.meet(new)
    assert document._track_source.colours.has(26)
    document._track_source.take_session(document.session)
    assert not document._track_source.colours.has(26)


@pytest.mark.parametrize("quick", [True, False])
def test_who_was_watched_while_a_tracker_worked_keeps_the_colour_when_its_run_is_kept(
    recording, document, monkeypatch, quick
):
    if not quick:
        monkeypatch.setattr(session_colours, "_QUICK_ROWS", 0)
    live, session = Document(recording), document.session
    session.colours = {}  # as one that was made a moment ago
    live.begin_live()
    for frame in (0, 55):  # 2 comes up where 1 and 25 have theirs already
        live._track_source._live_colours.meet(session.tracks.of_frame(frame))
    watched = live._track_source._live_colours
    watched._place = {one: (place + 1) % 24 for one, place in watched._place.items()}
    before = _colours(live, 1, 2, 25)
    live.take_session(session)
    assert _colours(live, 1, 2, 25) == before
    due = live.colours_due
    assert (due is None) is quick
    if due is not None:
        assert live.take_colours(due, due.make())
    assert _colours(live, 1, 2, 25) == before


def _kept_from(recording, document, places):
    """The colours in which the session's people are shown who were watched in others."""
    live = Document(recording)
    live.begin_live()
    live._track_source._live_colours._place = dict(places)
    document.session.colours = {}  # as one that was made a moment ago
    live.take_session(document.session)
    return _colours(live, *places)


def test_of_two_watched_in_one_colour_who_meet_in_the_run_the_shorter_has_another(
    recording, document
):
    far = int(track_colours._ALIKE[0].argmin())
    one, two, third = _kept_from(recording, document, {1: 0, 2: 0, 25: far})
    assert (one, third) == (TRACK_COLOURS[0], TRACK_COLOURS[far])
    assert len({one, two, third}) == 3


def test_who_came_first_has_another_colour_where_they_are_the_shorter(
    recording, tiny_run, tmp_path
):
    stays = _document(recording, tiny_run, {1: (0, 20), 2: (10, 70)}, tmp_path / "short.h5")
    one, two = _kept_from(recording, stays, {1: 4, 2: 4})
    assert two == TRACK_COLOURS[4] != one
    stays.session.close()


def test_who_was_watched_in_one_colour_keeps_it_where_they_never_meet_in_the_run(
    recording, tiny_run, tmp_path
):
    apart = _document(recording, tiny_run, {1: (0, 30), 2: (40, 70)}, tmp_path / "apart.h5")
    assert _kept_from(recording, apart, {1: 7, 2: 7}) == [TRACK_COLOURS[7]] * 2
    apart.session.close()


def test_colours_of_a_run_that_was_dropped_are_not_those_of_another_run(recording, document):
    session, live = document.session, Document(recording, document.session)
    own = _colours(live, 1, 2, 25)
    live.begin_live()
    live._track_source._live_colours._place = {1: 5, 2: 9, 25: 13}
    live.end_live()  # stopped, or kept beside
    assert _colours(live, 1, 2, 25) == own
    session.adopt_run(session.add_run(session.corrected_run, adopt=False))
    live.take_session(session)
    assert _colours(live, 1, 2, 25) == own


def test_people_keep_the_colours_they_were_watched_in_when_their_session_is_opened_again(
    recording, tiny_run, tmp_path
):
    ids = np.unique(tiny_run.tracks["track"]).tolist()
    seen = TrackColours.kept({one: (usual_place(one) + 5) % len(TRACK_COLOURS) for one in ids})
    path = tmp_path / "watched.h5"
    document_loader.keep_run(recording, tiny_run, path, seen).close()
    first, again = (_looked_at(recording, path, ids) for _ in range(2))
    assert first == again == [seen.of(one) for one in ids]


def test_colours_given_by_edits_are_the_same_when_a_saved_session_is_opened_again(
    recording, document
):
    document.undo()
    for at in (20, 40, 65):
        table = document.session.tracks
        document.apply(plan_split(table, max(table.of_frame(at)["track"].tolist()), at))
    ids = document.session.tracks.track_ids
    given = _colours(document, *ids)
    path = document.session.path
    document.session.save()
    document.session.close()
    assert _looked_at(recording, path, ids) == given


def test_colours_of_the_run_that_is_corrected_no_more_are_not_those_of_another(
    recording, tiny_run, tmp_path
):
    ids = np.unique(tiny_run.tracks["track"]).tolist()
    seen = TrackColours.kept({one: (usual_place(one) + 5) % len(TRACK_COLOURS) for one in ids})
    session = document_loader.keep_run(recording, tiny_run, tmp_path / "two.h5", seen)
    session.adopt_run(session.add_run(tiny_run, adopt=False))
    assert not session.colours
    session.close()


def _looked_at(recording, path, ids):
    session = Session.open(path)
    colours = _colours(Document(recording, session), *ids)
    session.close()
    return colours


def test_who_was_drawn_looks_the_same_where_the_program_ended_before_it_saved(recording, tmp_path):
    path = tmp_path / "before" / "by-hand.h5"
    path.parent.mkdir()
    document = Document(recording, Session.create(recording, [], path))
    places = {1: 0, 25: 0, 2: 40, 26: 40, 3: 90}  # of two ids whose usual colours are alike
    for frame, shift in ((0, 0), (10, 4)):
        for track, left in places.items():
            table = document.session.tracks
            box = np.array([20.0 + left + shift, 40.0, 20.0, 50.0], np.float32)
            document.apply(plan_put_box(table, track, frame, box))
    document.apply(plan_split(document.session.tracks, 25, 5))
    given = _colours(document, *document.session.tracks.track_ids)
    usual = [USUAL_OF[one] for one in document.session.tracks.track_ids]
    assert given != usual
    after = shutil.copytree(path.parent, tmp_path / "after")  # what a crash leaves on the disk
    with closing(Session.open(after / path.name)) as session:
        again = Document(recording, session)
        assert _colours(again, *session.tracks.track_ids) == given
    document.session.close()
