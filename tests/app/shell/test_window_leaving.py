"""What is not saved is asked for by itself, kept while other work goes on, or let go whole."""

import gc
import shutil
import threading
import weakref

import pytest
from patient import PATIENCE_S
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QMessageBox

from app.core.tracking_process import TrackerProcess
from tracking.session.session_writer import companions

_BUTTON = QMessageBox.StandardButton


@pytest.fixture
def fresh(window, qtbot, tiny_recording):
    """A recording that nobody has tracked yet."""
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    return window.controller


def _answer(window, qtbot, button):
    qtbot.waitUntil(lambda: window.findChild(QMessageBox, "unsaved") is not None)
    box = window.findChild(QMessageBox, "unsaved")
    text = box.text()
    box.button(button).click()
    qtbot.waitUntil(lambda: window.findChild(QMessageBox, "unsaved") is not box)
    return text


def _rename(controller, name):
    controller.editing.rename(controller.document.session.tracks.track_ids[0], name)


def test_saving_that_is_refused_while_other_work_runs_can_be_done_later(window, controller, qtbot):
    go = threading.Event()
    _rename(controller, "first")
    window.work.run("Scoring", lambda _: go.wait(PATIENCE_S), lambda _: None)
    window.files.saving.save()
    go.set()
    qtbot.waitUntil(lambda: not window.work.busy)
    window.files.saving.save()
    qtbot.waitUntil(lambda: not window.files.saving.unsaved)


def test_edits_not_saved_are_asked_for_also_while_a_tracker_begins(window, controller):
    _rename(controller, "first")
    controller.tracking.track("stereo-colour")
    assert controller.live.done == 0
    assert window.files.saving.unsaved


def test_the_question_names_the_session_and_its_recording(window, controller, qtbot, tiny_session):
    _rename(controller, "first")
    window.files.close_recording()
    text = _answer(window, qtbot, _BUTTON.Cancel)
    assert tiny_session.name in text
    assert controller.document.recording.name in text


def test_the_question_names_the_tracker_at_work(window, fresh, qtbot):
    fresh.toggle()
    qtbot.waitUntil(lambda: fresh.live.done > 3)
    window.files.close_recording()
    text = _answer(window, qtbot, _BUTTON.Discard)
    assert f'{fresh.live.tracker} is still tracking "{fresh.document.recording.name}"' in text


def test_an_edit_that_was_taken_back_is_not_asked_about(window, controller):
    _rename(controller, "first")
    controller.editing.undo()
    assert window.files.may_leave(lambda: None)


def test_a_result_in_place_of_one_that_was_dropped_is_asked_about(window, controller, qtbot):
    session = controller.document.session
    session.add_run(session.runs[0], adopt=False)
    window.files.saving.save()
    qtbot.waitUntil(lambda: not window.files.saving.unsaved)
    assert not window.files.saving.changed_here
    session.drop_run(1)
    session.add_run(session.runs[0], adopt=False)
    window.files.close_recording()
    assert "Save" in _answer(window, qtbot, _BUTTON.Cancel)
    assert window.controller is controller


def test_a_result_that_was_added_and_dropped_again_is_not_asked_about(window, controller):
    session = controller.document.session
    session.add_run(session.runs[0], adopt=False)
    session.drop_run(1)
    assert window.files.may_leave(lambda: None)


def test_unsaved_work_of_an_earlier_sitting_is_kept_and_not_asked_about_again(
    window, controller, qtbot, tiny_session
):
    _rename(controller, "first")
    track = controller.document.session.history.next_undo.change.tracks[0]
    window.files.close_without_asking()
    for _ in range(2):
        window.files.open_path(tiny_session)
        qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy)
        assert window.controller.document.label(track).name == "first"
        assert window.files.saving.unsaved
        window.files.close_recording()
        assert window.controller is None


def test_a_session_that_was_never_saved_is_asked_about_where_it_was_made_alone(
    window, fresh, qtbot
):
    fresh.toggle()
    qtbot.waitUntil(lambda: window.files.session is not None and not window.work.busy)
    path = window.files.session.path
    window.files.close_recording()
    assert fresh.document.recording.name in _answer(window, qtbot, _BUTTON.Cancel)
    window.files.close_without_asking()
    window.files.open_path(path)
    qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy)
    window.files.close_recording()
    assert window.controller is None
    assert path.is_file()


def test_letting_a_tracker_go_does_not_let_edits_go(window, controller, qtbot):
    _rename(controller, "first")
    controller.tracking.track("stereo-colour")
    qtbot.waitUntil(lambda: controller.live.done > 3)
    window.files.close_recording()
    assert "tracker" in _answer(window, qtbot, _BUTTON.Discard)
    assert not controller.live.running
    assert "Save" in _answer(window, qtbot, _BUTTON.Cancel)
    assert controller.document.session.history.next_undo is not None


def test_a_file_that_does_not_open_leaves_the_open_session_as_it_is_and_asks_nothing(
    window, controller, qtbot, tmp_path
):
    wrong = tmp_path / "wrong.h5"
    wrong.write_text("no session")
    _rename(controller, "first")
    window.files.open_path(wrong)
    qtbot.waitUntil(lambda: "wrong.h5" in window.notice.text and not window.work.busy)
    assert window.findChild(QMessageBox, "unsaved") is None
    assert window.controller is controller
    assert window.files.saving.unsaved


@pytest.mark.parametrize("button", [_BUTTON.Save, _BUTTON.Discard], ids=["save", "discard"])
def test_a_file_that_opens_takes_the_place_of_the_session_once_that_is_answered(
    window, controller, qtbot, tiny_recording, button
):
    _rename(controller, "first")
    window.files.open_path(tiny_recording)
    assert "Save" in _answer(window, qtbot, button)
    qtbot.waitUntil(lambda: window.controller not in (None, controller))
    assert window.files.session is None


def test_a_session_opened_once_more_is_as_it_was_saved_where_its_changes_are_discarded(
    window, controller, qtbot, tiny_session
):
    _rename(controller, "first")
    window.files.open_path(tiny_session)
    _answer(window, qtbot, _BUTTON.Discard)
    qtbot.waitUntil(lambda: window.controller not in (None, controller))
    assert window.files.session.history.next_undo is None
    assert not window.files.session.read_only


def test_what_a_tracker_found_while_other_work_ran_is_kept(window, fresh, qtbot):
    go = threading.Event()
    fresh.toggle()
    qtbot.waitUntil(lambda: fresh.live.done > 3)
    window.work.run("Making the demo", lambda _: go.wait(PATIENCE_S), lambda _: None)
    fresh.live.stop()
    qtbot.waitUntil(lambda: not fresh.live.running)
    assert window.files.saving.unsaved
    go.set()
    qtbot.waitUntil(lambda: window.files.session is not None)


def test_playing_on_while_the_result_is_being_kept_does_not_track_anew(window, fresh, qtbot):
    fresh.toggle()
    qtbot.waitUntil(lambda: fresh.live.done > 3)
    fresh.playback.pause()
    fresh.live.stop()
    qtbot.waitUntil(lambda: not fresh.live.running)
    fresh.toggle()
    assert not fresh.live.running
    qtbot.waitUntil(lambda: window.files.session is not None)


def test_opening_another_recording_lets_the_first_one_go(
    window, qtbot, tiny_session, tiny_recording
):
    let_go = []
    for path in (tiny_session, tiny_recording):
        window.files.open_path(path)
        qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy)
        qtbot.waitUntil(lambda: window.controller.playback.frame is not None)
        window.run_command("view.foreground")
        let_go.append(weakref.ref(window.controller.document.recording))
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    gc.collect()
    assert let_go[0]() is None
    assert let_go[1]() is not None


def test_edits_whose_folder_vanished_are_told_when_the_recording_is_closed(
    window, controller, tmp_path
):
    _rename(controller, "first")
    path = controller.document.session.path
    shutil.rmtree(companions(path))
    path.rename(tmp_path / "elsewhere.h5")
    window.files.close_without_asking()
    assert window.controller is None
    assert "may be lost" in window.notice.text


@pytest.fixture
def winding_down(monkeypatch):
    """A tracker that was stopped, which ends once this is set."""
    ended = threading.Event()
    end = TrackerProcess._end

    def slowly(process, child):
        ended.wait(PATIENCE_S)
        end(process, child)

    monkeypatch.setattr(TrackerProcess, "_end", slowly)
    yield ended
    ended.set()


def test_the_question_about_a_tracker_that_stops_goes_once_its_result_is_on_disk(
    window, fresh, qtbot, winding_down
):
    fresh.toggle()
    qtbot.waitUntil(lambda: fresh.live.done > 3)
    window.run_command("tracks.stop")
    window.files.close_recording()
    box = window.findChild(QMessageBox, "unsaved")
    assert "is stopping" in box.text()
    winding_down.set()
    qtbot.waitUntil(lambda: window.files.session is not None and not window.work.busy)

    def asked():
        return [one.text()[:4] for one in window.findChildren(QMessageBox, "unsaved")]

    qtbot.waitUntil(lambda: asked() == ["Save"])  # of what is on disk, never saved by its name
    _answer(window, qtbot, _BUTTON.Cancel)
    assert window.files.session.path.is_file()


def test_stopping_is_said_at_once_and_cannot_be_asked_for_twice(window, fresh, qtbot, winding_down):
    fresh.toggle()
    qtbot.waitUntil(lambda: fresh.live.done > 3)
    window.run_command("tracks.stop")
    window.bring_up_to_date()
    assert window.progress._left.text() == "Stopping..."
    assert not window.progress._stop.isEnabled()
    assert window.workspace.transport._status.text() == "stopping"
    window.bring_up_to_date()  # results on their way do not change it
    assert window.progress._left.text() == "Stopping..."
    assert window.registry.item("tracks.stop").why_not == "the tracker is stopping"
