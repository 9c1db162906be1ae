"""The panel of edits."""

from __future__ import annotations

import pytest
from panel_words import words
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu

from app.core.scenes import HistoryItem
from app.core.widgets.eliding_label import ElidingLabel
from app.features.history.panel import HistoryPanel

LEFT = Qt.MouseButton.LeftButton


def edit(number: int, undone: bool = False) -> HistoryItem:
    return HistoryItem(number, f"edit {number}", "10:4" + str(number), "mika", 100 * number, undone)


@pytest.fixture
def history(qtbot, dark):
    panel = HistoryPanel()
    qtbot.addWidget(panel)
    panel.resize(300, 300)
    panel.show_scene((edit(1), edit(2), edit(3, undone=True)))
    panel.grab()
    return panel


def row_point(panel, row: int):
    return panel._list.visualRect(panel._model.index(row)).center()


def listed(panel) -> list[str]:
    return [panel._model.item(row).text for row in range(panel._model.rowCount())]


def test_the_newest_edit_stands_on_top(history):
    assert listed(history) == ["edit 3", "edit 2", "edit 1"]


def test_the_title_is_whole_beside_the_filter(history):
    title = history.findChild(ElidingLabel)
    assert title.shown_text() == title.text()


def test_a_click_goes_to_what_an_edit_changed(history, qtbot):
    with qtbot.waitSignal(history.edit_sought) as sought:
        qtbot.mouseClick(history._list.viewport(), LEFT, pos=row_point(history, 1))
    assert sought.args == [2]


def test_a_double_click_undoes_to_an_edit(history, qtbot):
    with qtbot.waitSignal(history.goto_asked) as asked:
        history._list.doubleClicked.emit(history._model.index(2))
    assert asked.args == [1]


@pytest.mark.parametrize(("row", "text"), [(0, "Redo to here"), (1, "Undo to here")])
def test_the_menu_of_an_edit_says_what_it_will_do(history, qtbot, heard, row, text):
    asked = heard(history.goto_asked)
    history._open_menu(row_point(history, row))
    menu = history._list.findChildren(QMenu)[-1]
    action = next(one for one in menu.actions() if one.text() == text)
    action.trigger()
    menu.close()
    assert asked == [3 - row]


def test_undo_and_redo_are_offered_only_where_there_is_something(history):
    assert history._undo.isEnabled()
    assert history._redo.isEnabled()
    history.show_scene(())
    assert not history._undo.isEnabled()
    assert not history._redo.isEnabled()
    assert "No edits yet" in words(history)


def test_a_further_edit_leaves_the_rows_of_the_others_as_they_are(history):
    history._list.setCurrentIndex(history._model.index(2))
    history.show_scene((edit(1), edit(2), edit(3), edit(4)))
    assert history.current_edit == 1
    assert listed(history) == ["edit 4", "edit 3", "edit 2", "edit 1"]
    history.show_scene((edit(1), edit(5)))
    assert listed(history) == ["edit 5", "edit 1"]
    assert history.current_edit == 1
    history.show_scene(())
    assert history._model.rowCount() == 0
