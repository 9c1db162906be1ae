"""Edits that cannot be done are told, and leave everything as it is."""

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip

from app.features.history.controller import HistoryWalk
from tracking.editing import plan_delete
from tracking.errors import EditError, SessionError


def _track(controller) -> int:
    return int(controller.document.session.tracks.track_ids[0])


def test_going_to_an_edit_ends_at_the_first_that_cannot_be_taken_back(controller, monkeypatch):
    told = []
    for name in ("one", "two", "three"):
        controller.editing.rename(_track(controller), name)

    def refuse() -> None:
        raise SessionError("no space left on the disk")

    monkeypatch.setattr(controller.document.session, "undo", refuse)
    controller.failed.connect(lambda error: told.append(str(error)) or _fuse(told))
    controller.of(HistoryWalk).go_back_to(1)
    assert told == ["no space left on the disk"]


def _fuse(told) -> None:
    if len(told) > 9:
        pytest.exit("it never ends")


def test_while_a_tracker_works_nobody_is_renamed_by_the_number_another_run_gave_them(controller):
    track, told = _track(controller), []
    controller.editing.rename(track, "anna")
    controller.failed.connect(lambda error: told.append(str(error)))
    controller.tracking.track("stereo-colour")
    assert controller.document.label(track).name == ""
    controller.editing.rename(track, "bert")
    controller.editing.undo()
    assert len(told) == 2
    assert "stop tracking first" in told[0]
    assert controller.document.session.labels.of_track(track).name == "anna"


def test_a_tracker_does_not_begin_where_its_result_could_not_be_kept(
    window, controller, tiny_session
):
    controller.document.session._give_up_writing("for the test")
    window.run_command("tracks.track")
    assert "read-only" in window.statusBar().currentMessage()


def test_an_edit_larger_than_the_history_can_keep_is_told_before_enter(
    window, controller, monkeypatch
):
    monkeypatch.setattr("tracking.editing.log.text.LARGEST_TEXT", 64)
    controller.editing.pick(_track(controller))
    window.run_command("tracks.delete_track")
    scene = controller.document.planned.scene
    assert not scene.ready
    assert "more than the history can keep: choose a shorter range" in scene.details[0]
    window.run_command("tracks.confirm")
    assert len(controller.document.session.history) == 0


def test_what_is_taken_at_once_is_told_too_where_the_history_cannot_keep_it(
    controller, monkeypatch
):
    change = plan_delete(controller.document.session.tracks, _track(controller))
    monkeypatch.setattr("tracking.editing.log.text.LARGEST_TEXT", 64)
    with pytest.raises(EditError, match="more than the history can keep"):
        controller.document.apply(change)


def test_an_entry_of_a_menu_that_cannot_be_chosen_says_why_beside_it(
    window, controller, monkeypatch
):
    told = []
    monkeypatch.setattr(QToolTip, "showText", lambda _at, text, _menu: told.append(text))
    menu, entries = window.menus.menus["Playback", ""], window.menus.actions
    menu.popup(window.pos())
    for name in ("play.follow", "play.next"):
        at = menu.actionGeometry(entries[name]).center()
        QApplication.sendEvent(menu, QHelpEvent(QEvent.Type.ToolTip, at, at))
    menu.close()
    assert told == [entries["play.follow"].statusTip(), ""]
    assert "no tracker is running" in told[0]


def test_why_not_is_no_longer_said_once_it_can_be_done(window, controller):
    window.run_command("tracks.split")
    line = window.statusBar()
    assert "Split" in line.currentMessage()
    controller.editing.pick(_track(controller))
    window.bring_up_to_date()
    assert line.currentMessage() == ""


def test_nothing_is_said_of_leaving_where_there_is_nothing_to_leave(window, controller):
    assert not controller.document.selection
    window.run_command("tracks.none")
    assert window.statusBar().currentMessage() == ""
