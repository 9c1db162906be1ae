"""Edits that cannot be done are told, and leave everything as it is."""

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtGui import QHelpEvent
from PySide6.QtWidgets import QApplication, QToolTip

from tracking.editing import plan_delete
from tracking.errors import EditError, SessionError


def _track(desk) -> int:
    return int(desk.document.session.tracks.track_ids[0])


def test_going_to_an_edit_ends_at_the_first_that_cannot_be_taken_back(desk, monkeypatch):
    told = []
    for name in ("one", "two", "three"):
        desk.editing.rename(_track(desk), name)

    def refuse() -> None:
        raise SessionError("no space left on the disk")

    monkeypatch.setattr(desk.document.session, "undo", refuse)
    desk.failed.connect(lambda error: told.append(str(error)) or _fuse(told))
    desk.walk.go_back_to(1)
    assert told == ["no space left on the disk"]


def _fuse(told) -> None:
    if len(told) > 9:
        pytest.exit("it never ends")


def test_while_a_tracker_works_nobody_is_renamed_by_the_number_another_run_gave_them(desk):
    track, told = _track(desk), []
    desk.editing.rename(track, "anna")
    desk.failed.connect(lambda error: told.append(str(error)))
    desk.tracking.track("stereo-colour")
    assert desk.document.label(track).name == ""
    desk.editing.rename(track, "bert")
    desk.editing.undo()
    assert len(told) == 2
    assert "stop tracking first" in told[0]
    assert desk.document.session.labels.of_track(track).name == "anna"


def test_a_tracker_does_not_begin_where_its_result_could_not_be_kept(window, desk, tiny_session):
    desk.document.session._give_up_writing("for the test")
    window.run_command("tracks.track")
    assert "read only" in window.statusBar().currentMessage()


def test_an_edit_larger_than_the_history_can_keep_is_told_before_enter(window, desk, monkeypatch):
    monkeypatch.setattr("tracking.editing.log.text.LARGEST_TEXT", 64)
    desk.editing.pick(_track(desk))
    window.run_command("tracks.delete_track")
    scene = desk.document.planned.scene
    assert not scene.ready
    assert "more than the history can keep: choose a shorter range" in scene.details[0]
    window.run_command("tracks.confirm")
    assert len(desk.document.session.history) == 0


def test_what_is_taken_at_once_is_told_too_where_the_history_cannot_keep_it(desk, monkeypatch):
    change = plan_delete(desk.document.session.tracks, _track(desk))
    monkeypatch.setattr("tracking.editing.log.text.LARGEST_TEXT", 64)
    with pytest.raises(EditError, match="more than the history can keep"):
        desk.document.apply(change)


def test_an_entry_of_a_menu_that_cannot_be_chosen_says_why_beside_it(window, desk, monkeypatch):
    told = []
    monkeypatch.setattr(QToolTip, "showText", lambda _at, text, _menu: told.append(text))
    menu, entries = window.menus.menus["Playback", ""], window.menus.actions
    menu.popup(window.pos())
    for name in ("play.follow", "play.next"):
        at = menu.actionGeometry(entries[name]).center()
        QApplication.sendEvent(menu, QHelpEvent(QEvent.Type.ToolTip, at, at))
    menu.close()
    assert told == [entries["play.follow"].statusTip(), ""]
    assert "no tracker is at work" in told[0]


def test_why_not_is_no_longer_said_once_it_can_be_done(window, desk):
    window.run_command("tracks.split")
    line = window.statusBar()
    assert "Split" in line.currentMessage()
    desk.editing.pick(_track(desk))
    window.bring_up_to_date()
    assert line.currentMessage() == ""


def test_nothing_is_said_of_leaving_where_there_is_nothing_to_leave(window, desk):
    assert not desk.document.selection
    window.run_command("tracks.none")
    assert window.statusBar().currentMessage() == ""
