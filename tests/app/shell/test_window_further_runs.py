"""What becomes of the window, and of an edit that waits, when a tracker ends."""

import threading

import numpy as np
import pytest
from patient import PATIENCE_S
from PySide6.QtCore import Qt

from app.core.colours.track_colours import TrackColours
from app.core.editing import edits
from app.core.tracks import session_colours
from app.features.history.controller import HistoryWalk
from app.features.runs.run_summary import describe_coming_run
from app.features.scoring.controller import ScoreController
from app.shell.recording_controller import RecordingController
from tracking.editing import plan_delete
from tracking.errors import EditError, RecordingError
from tracking.session import Session
from tracking.trackers import StepResult
from tracking.tracks import ASSOCIATION_COLUMNS, DETECTION_COLUMNS, PARTICLE_COLUMNS, empty
from tracking.tracks.run import Particles

Key = Qt.Key


@pytest.fixture
def untracked(window, qtbot, tiny_recording) -> RecordingController:
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    return window.controller


@pytest.fixture
def looked_away(controller) -> RecordingController:
    """The controller with a further tracker at work, while the session's tracks are looked at."""
    controller.document.begin_live()
    assert controller.document.show_live(on=False)
    return controller


def _steps(run, until):
    none = empty(DETECTION_COLUMNS), Particles.none(PARTICLE_COLUMNS).of_frame(0)
    for frame in range(until):
        here = run.tracks["frame"] == frame
        rows = {name: column[here] for name, column in run.tracks.items()}
        yield StepResult(frame, rows, *none, empty(ASSOCIATION_COLUMNS))


@pytest.fixture
def followed(controller, tiny_run, monkeypatch) -> RecordingController:
    """The recording's controller that follows a further tracker at work, whose people it shows."""
    monkeypatch.setattr(type(controller.live), "running", property(lambda _: True))
    controller.document.begin_live()
    controller.document.take_live(_steps(tiny_run, 30))
    controller.tracking.following.begin()
    assert controller.document.is_live
    return controller


@pytest.fixture
def swapping(followed) -> RecordingController:
    """The same controller once somebody has looked away from it and begun to correct."""
    controller, document = followed, followed.document
    controller.playback.go(40)
    assert not document.is_live
    first, second = document.tracks.of_frame(40)["track"].tolist()[:2]
    document.correcting.pick(first)
    controller.editing.begin(edits.SWAP)
    document.correcting.pick(second)
    return controller


def _waiting(controller):
    flow = controller.document.flow
    return None if flow is None else (flow.spec, flow.track, flow.other)


def test_an_edit_waits_on_when_the_further_tracker_fails(swapping):
    before = _waiting(swapping)
    swapping.live.failed.emit(RecordingError("out of memory"))
    assert _waiting(swapping) == before
    assert swapping.document.selection.track == before[1]
    assert not swapping.document.at_work
    swapping.editing.confirm()
    assert swapping.document.session.history.next_undo is not None


def test_an_edit_waits_on_when_tracks_were_tracked_again_meanwhile(swapping, tiny_run):
    before = _waiting(swapping)
    swapping.tracking._again = True
    swapping.live.finished.emit(tiny_run)
    assert _waiting(swapping) == before
    assert not swapping.comparing.shown


def test_following_a_further_run_is_refused_while_an_edit_waits(swapping, window, press):
    before, said = _waiting(swapping), []
    swapping.said.connect(said.append)
    press(Key.Key_L, Qt.KeyboardModifier.ShiftModifier)
    window.workspace.transport.follow_toggled.emit()
    assert _waiting(swapping) == before
    assert not swapping.document.is_live
    assert "an edit is in preview" in said[-1]


def test_why_not_is_said_also_where_the_other_ones_id_is_asked_for(followed, window, press):
    followed.playback.go(40)
    followed.document.correcting.pick(followed.document.tracks.of_frame(40)["track"].tolist()[0])
    followed.editing.begin(edits.SWAP)
    field = window.workspace.preview._other
    assert window.focusWidget() is field
    window.bring_up_to_date()  # which disables the command: its key comes to the field
    press(Key.Key_L, Qt.KeyboardModifier.ShiftModifier)
    assert "an edit is in preview" in window.statusBar().currentMessage()
    assert followed.document.flow is not None
    press(Key.Key_2)
    assert field.text() == "2"


def test_that_the_playhead_is_to_be_moved_is_no_longer_said_once_it_was(followed, window, press):
    window.bring_up_to_date()
    window.run_command("tracks.swap")
    assert "move the playhead" in window.statusBar().currentMessage()
    followed.document.selection.choose(0)
    followed.playback.go(40)
    window.bring_up_to_date()
    assert not window.menus.actions["tracks.swap"].isEnabled()  # nobody is selected
    assert "move the playhead" not in window.statusBar().currentMessage()


def test_an_edit_of_the_history_is_gone_to_from_a_further_run(followed):
    document = followed.document
    followed.playback.go(40)
    track = document.tracks.of_frame(40)["track"].tolist()[0]
    document.correcting.pick(track)
    followed.editing.begin(edits.SPLIT)
    followed.editing.confirm()
    followed.tracking.following.begin()
    assert document.is_live
    followed.of(HistoryWalk).go_to(1)
    assert not document.is_live
    assert track in document.selection.all


def test_the_begin_of_a_track_is_refused_where_going_there_would_show_others(followed, window):
    track = followed.document.tracks.ids[0]
    followed.document.selection.choose(track)
    before = followed.playback.clock.frame
    window.run_command("tracks.to_start")
    assert followed.document.is_live
    assert followed.document.selection.track == track
    assert followed.playback.clock.frame == before


def test_errors_of_a_further_run_select_nobody_of_the_sessions_tracks(followed):
    followed.of(ScoreController).go_to(40, followed.document.session.tracks.track_ids)
    assert not followed.document.is_live
    assert not followed.document.selection


def test_after_a_first_tracker_failed_somebody_can_be_drawn(untracked, window):
    untracked.document.begin_live()
    untracked.live.failed.emit(RecordingError("out of memory"))
    assert not untracked.document.at_work
    window.run_command("tracks.draw")
    assert untracked.document.flow.spec is edits.DRAW


def test_after_a_tracker_was_stopped_before_its_first_frame_the_session_is_shown(controller):
    controller.document.begin_live()
    controller.live.finished.emit(None)
    assert not controller.document.is_live
    assert controller.document.tracks.ids


def test_after_a_run_that_cannot_be_kept_the_session_can_be_corrected(
    controller, window, tiny_run, monkeypatch
):
    def refuse(*_, **__) -> int:
        raise EditError("the run's tracks are no table")

    monkeypatch.setattr(Session, "add_run", refuse)
    controller.document.begin_live()
    controller.live.finished.emit(tiny_run)
    assert window.files.keeping.holds
    assert (controller.document.at_work, controller.document.is_live) == (False, False)


def test_a_run_that_ends_leaves_the_table_under_an_edit_that_waits(looked_away, press, tiny_run):
    controller, document = looked_away, looked_away.document
    before = document.session.tracks.columns()["track"].copy()
    first, second = document.tracks.of_frame(40)["track"].tolist()[:2]
    controller.playback.go(40)
    document.correcting.pick(first)
    controller.editing.begin(edits.SWAP)
    document.correcting.pick(second)
    controller.live.finished.emit(tiny_run)
    assert document.session.adopted_run == 0
    assert np.array_equal(document.session.tracks.columns()["track"], before)
    assert (document.flow.track, document.flow.other) == (first, second)
    controller.editing.confirm()
    assert set(document.session.history.next_undo.change.tracks) == {first, second}


def test_tracks_that_are_looked_at_are_not_replaced_by_a_run_that_ends(looked_away, tiny_run):
    looked_away.live.finished.emit(tiny_run)
    assert looked_away.document.session.adopted_run == 0


def test_whoever_watches_a_further_run_to_its_end_has_its_tracks_and_nobody_selected(
    controller, tiny_run
):
    controller.document.begin_live()
    controller.document.selection.choose(1)  # by the tracker's numbers
    controller.live.finished.emit(tiny_run)
    assert controller.document.session.adopted_run == 1
    assert not controller.document.selection


def test_before_a_further_run_it_is_said_what_becomes_of_the_corrected_tracks(controller, tiny_run):
    session = controller.document.session
    assert "takes the place of the corrected tracks of run 0" in describe_coming_run(session)
    controller.document.begin_live()
    controller.live.finished.emit(tiny_run)
    assert session.adopted_run == 1
    controller.document.apply(plan_delete(session.tracks, controller.document.tracks.ids[0], 0, 80))
    assert "stay as they are" in describe_coming_run(session)
    controller.document.begin_live()
    controller.live.finished.emit(tiny_run)
    assert session.adopted_run == 1


def test_a_colour_stays_as_runs_end_and_are_dropped(controller, tiny_run):
    document, session = controller.document, controller.document.session
    track = session.tracks.track_ids[0]
    controller.editing.rename(track, "first")  # so that a further run is kept beside
    document.correcting.pick(track)
    controller.playback.go(40)
    controller.editing.begin(edits.SPLIT)
    controller.editing.confirm()
    before = [document.colour_of(one) for one in session.tracks.track_ids]
    colours = document._track_source.colours
    document.begin_live()
    controller.live.finished.emit(tiny_run)
    controller.tracking.drop()
    assert [document.colour_of(one) for one in session.tracks.track_ids] == before
    assert document._track_source.colours is colours


@pytest.fixture
def long(controller, monkeypatch) -> RecordingController:
    """The controller with every session counted as long, and other colours for everybody."""
    monkeypatch.setattr(session_colours, "_QUICK_ROWS", 0)
    at_first = TrackColours.at_first
    controller.made_in = []

    def shifted(run, seen=None):
        controller.made_in.append(threading.current_thread())
        colours = at_first(run, seen)
        colours._place = {one: (place + 5) % 20 for one, place in colours._place.items()}
        return colours

    monkeypatch.setattr(TrackColours, "at_first", shifted)
    return controller


def test_colours_of_a_long_session_come_from_another_thread_into_all_views(long, tiny_run, qtbot):
    controller, document = long, long.document
    qtbot.waitUntil(lambda: len(controller.reviewing.queue.kinds()) > 0)
    track = document.session.tracks.track_ids[0]
    before = document.colour_of(track)
    document.begin_live()
    controller.live.finished.emit(tiny_run)
    document.selection.choose(track)
    controller.draw()
    assert document.session.adopted_run == 1
    assert document.colour_of(track) == before  # the old ones till then
    qtbot.waitUntil(lambda: document.colours_due is None)
    now, frame = document.colour_of(track), controller.playback.number
    assert threading.main_thread() not in controller.made_in
    assert now != before
    lanes = {lane.track: lane.colour for lane in controller.scenes.timeline(frame, frame).lanes}
    assert lanes == {one: document.colour_of(one) for one in lanes}
    assert document.card().colour == now
    people = [one for item in controller.reviewing.queue.items for one in item.people]
    assert all(one.colour == document.colour_of(one.track) for one in people)


def test_colours_that_cannot_be_made_are_told_and_not_due_for_ever(
    long, tiny_run, qtbot, monkeypatch
):
    def fail(*_):
        raise MemoryError

    monkeypatch.setattr(TrackColours, "at_first", fail)
    long.document.begin_live()
    with qtbot.waitSignal(long.failed):
        long.live.finished.emit(tiny_run)
    assert long.document.colours_due is None


def test_closing_a_recording_does_not_wait_for_its_colours(
    long, window, tiny_run, qtbot, monkeypatch
):
    begun, go_on, made = threading.Event(), threading.Event(), threading.Event()

    def slow(*_):
        begun.set()
        go_on.wait(PATIENCE_S)
        made.set()
        return TrackColours()

    monkeypatch.setattr(TrackColours, "at_first", slow)
    long.document.begin_live()
    long.live.finished.emit(tiny_run)
    qtbot.waitUntil(begun.is_set)
    long.colouring.close()
    waited = made.is_set()
    go_on.set()
    assert not waited


def test_whoever_looks_away_from_a_further_run_reads_what_made_the_tracks_in_view(
    looked_away, monkeypatch
):
    controller = looked_away
    monkeypatch.setattr(type(controller.live), "running", property(lambda _: True))
    monkeypatch.setattr(controller.live, "tracker", "three-part")
    monkeypatch.setattr(type(controller.live), "status", property(lambda _: "live"))
    made_by = controller.document.session.corrected_run.tracker
    assert (controller.tracking.state.name, controller.tracking.state.status) == (
        made_by,
        "tracked",
    )
    assert controller.document.show_live(on=True)
    assert (controller.tracking.state.name, controller.tracking.state.status) == (
        "three-part",
        "live",
    )


def test_the_review_goes_on_where_it_was_once_the_new_run_was_looked_at(followed, qtbot):
    controller, queue = followed, followed.reviewing.queue
    controller.playback.go(40)
    qtbot.waitUntil(lambda: bool(queue.items))
    assert controller.reviewing.lists_items
    controller.reviewing.narrow(queue.kinds()[0].kind)
    kind, items, meter = queue.kind, queue.items, controller.reviewing._scenes._meter
    controller.tracking.following.begin()
    assert not controller.reviewing.lists_items
    assert (
        controller.reviewing._scenes.scene(
            hidden=controller.reviewing._is_hidden, waits=False, plays=False
        ).items
        == ()
    )
    controller.playback.go(40)
    assert (queue.kind, queue.items) == (kind, items)
    assert controller.reviewing._scenes._meter is meter
    assert not controller.reviewing.busy


def test_the_keyboard_stays_with_the_picture_when_a_row_is_clicked_and_a_further_run_begins(
    followed, window, press, qtbot
):
    left = window.workspace.left
    left.setFocus()
    queue = window.workspace.review._list
    qtbot.mouseClick(queue.viewport(), Qt.MouseButton.LeftButton, pos=queue.rect().center())
    assert window.focusWidget() is left
    followed.document.begin_live()  # nobody is found yet
    window.bring_up_to_date()
    assert not window.menus.actions["tracks.next"].isEnabled()
    press(Key.Key_Tab)
    assert window.focusWidget() is left
    assert "Select next track" in window.statusBar().currentMessage()
