"""The history walked and undone in the real window."""

import json
from dataclasses import replace

import pytest
from correcting_window import open_for_correcting
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QInputDialog, QMenu

from app.core.document.edit_history import HistoryList
from app.features.history.controller import HistoryWalk
from app.features.history.panel import HistoryPanel
from tests.pace import spent
from tracking.editing import Change, History, LabelState, State
from tracking.tracks import TrackLabel

LEFT = Qt.MouseButton.LeftButton
_CTRL_ALT = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
MANY = 20_000


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session, 0)


@pytest.fixture
def named(controller):
    """Four edits: track a named twice, b once between, and b noted."""
    a, b = controller.document.tracks.of_frame(60)["track"].tolist()[:2]
    controller.editing.rename(a, "one")
    controller.editing.rename(b, "two")
    controller.editing.rename(a, "three")
    controller.editing.write_notes(b, "late")
    return a, b


def _row(panel, edit: int):
    index = panel._model.index(panel._model.row_of(edit))
    return panel._list.visualRect(index).center()


def _click(window, edit: int) -> None:
    panel = window.workspace.of(HistoryPanel)
    panel._list.scrollTo(panel._model.index(panel._model.row_of(edit)))
    QTest.mouseClick(panel._list.viewport(), LEFT, pos=_row(panel, edit))


def test_a_click_goes_to_the_frame_and_selects_the_tracks(window, controller, named):
    _click(window, 2)
    entry = controller.document.session.history.entry(2)
    assert controller.playback.clock.frame == entry.frame
    assert controller.document.selection.track == named[1]


def test_an_old_edit_is_undone_alone_by_its_key_or_the_reason_is_told(window, controller, named):
    _click(window, 1)
    panel = window.workspace.of(HistoryPanel)
    QTest.keyClick(panel._list, Qt.Key.Key_Z, _CTRL_ALT)
    assert "edit 3" in window.notice._text.text()  # the later name stands on it
    assert len(controller.document.session.history) == 4
    _click(window, 3)
    QTest.keyClick(panel._list, Qt.Key.Key_Z, _CTRL_ALT)
    assert controller.document.label(named[0]).name == "one"
    assert controller.document.label(named[1]).notes == "late"
    assert panel._model.item(panel._model.row_of(3)).taken_by == 5


def test_the_menu_says_why_an_edit_cannot_be_undone_alone(window, controller, named):
    panel = window.workspace.of(HistoryPanel)
    panel._open_menu(_row(panel, 1))
    menu = panel._list.findChildren(QMenu)[-1]
    alone = next(one for one in menu.actions() if one.text().startswith("Undo only this edit"))
    assert not alone.isEnabled()
    assert "edit 3" in alone.toolTip()
    menu.close()


def test_undo_to_here_goes_back_and_forth(window, controller, named, qtbot):
    controller.of(HistoryWalk).go_back_to(1)
    qtbot.waitUntil(lambda: controller.document.session.history.next_undo.id == 1)
    assert controller.document.label(named[0]).name == "one"
    controller.of(HistoryWalk).go_back_to(4)
    qtbot.waitUntil(lambda: controller.document.session.history.next_undo.id == 4)
    assert controller.document.label(named[0]).name == "three"


def test_the_list_is_narrowed_down_and_what_is_undone_stays_in_it(window, controller, named):
    controller.editing.undo()
    panel = window.workspace.of(HistoryPanel)
    assert [panel._model.item(row).undone for row in range(4)] == [True, False, False, False]
    panel._text.setText("three")
    assert [panel._model.item(row).edit for row in range(panel._model.rowCount())] == [3]
    panel._text.clear()
    panel._by.setCurrentIndex(panel._by.findText("Kind: notes"))
    assert [panel._model.item(row).edit for row in range(panel._model.rowCount())] == [4]


def test_edits_are_logged_under_the_name_that_was_set_and_it_is_remembered(
    window, controller, named, remembered
):
    window.run_command("file.author")
    dialog = window.findChild(QInputDialog, "author")
    dialog.setTextValue("  Ann  B. ")
    dialog.accept()
    controller.editing.rename(named[0], "five")
    assert controller.document.session.history.next_undo.author == "Ann B."
    assert remembered.text("author") == "Ann B."
    first = next(iter(controller.document.session.history))
    assert first.author != "Ann B."


def test_the_log_is_exported_as_csv_or_json(window, controller, named, qtbot, tmp_path):
    for name in ("log.csv", "log.json"):
        window.files.exporting.log_to(tmp_path / name)
        qtbot.waitUntil(lambda: not window.work.busy)
    lines = (tmp_path / "log.csv").read_text("utf-8").splitlines()
    assert len(lines) == 5
    assert 'Name 1 ""one""' in lines[1]
    log = json.loads((tmp_path / "log.json").read_text("utf-8"))
    assert log[0]["text"] == 'Name 1 "one"'


def test_twenty_thousand_edits_are_listed_and_one_more_is_told_quickly(window, controller):
    state = State(labels=LabelState({1: TrackLabel("one")}))
    change = Change("rename", "Name 1", 7, state, state)
    made = History().draft(change, "2024-05-01T10:00:00.000Z", "mika")
    history = History(
        replace(made, id=number + 1, text=f"Name {number % 99} edit {number}")
        for number in range(MANY)
    )
    listed, panel = HistoryList(), window.workspace.of(HistoryPanel)
    panel.show_scene(listed.of(history))
    assert panel._model.rowCount() == MANY
    history.mark_undone()
    with spent() as time:
        panel.show_scene(listed.of(history))
    assert time.paces < 30
    panel._text.setText("98")
    assert 0 < panel._model.rowCount() < MANY / 50
