from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QLabel, QLineEdit, QMenu

from app.presenters.comparing.differences_scene import DifferenceItem, DifferencesScene, Side
from app.presenters.reviewing.review_scene import ReviewScene
from app.presenters.scenes import ChoiceRow, EditPreview, HistoryItem, Proposal, TrackCard
from app.views.comparing.differences_panel import DifferencesPanel
from app.views.correcting.edit_panel import EditPanel
from app.views.correcting.track_panel import TrackPanel
from app.views.history.history_panel import HistoryPanel
from app.views.reviewing.review_panel import ReviewPanel
from app.views.widgets.notice import NoticeBar

LEFT = Qt.MouseButton.LeftButton
CARD = TrackCard(4, "red coat", (200, 30, 30), 12, 402, 381, 9, 0.87, (("bag", "none"),), "turns")
SWAP = EditPreview(
    "Swap 4 and 7 from frame 834 on",
    ("91 frames change",),
    834,
    end=850,
    choices=(ChoiceRow(0, "How far", ("from here on", "this range", "this frame"), 0, "R"),),
    other=7,
    others=(Proposal(7, "7", True, (40, 80, 220)), Proposal(9, "9", False, (220, 40, 40))),
    cuts=(Proposal(0, "834", True, None, "they meet"), Proposal(1, "790", False, None, "near")),
)


def words(widget) -> str:
    labels = widget.findChildren(QLabel) + widget.findChildren(QAbstractButton)
    return " ".join(one.text() for one in labels if not one.isHidden())


@pytest.fixture
def track_panel(qtbot, dark):
    panel = TrackPanel()
    qtbot.addWidget(panel)
    panel.show_scene(CARD)
    panel.resize(320, 480)
    panel.grab()  # lays it out
    return panel


def test_a_track_is_told_in_words(track_panel):
    said = words(track_panel)
    assert track_panel._name.text() == "red coat"
    assert track_panel._notes.toPlainText() == "turns"
    for part in ("4", "12", "402", "381 frames, 9 predicted", "0.87"):
        assert part in said


def test_an_unknown_confidence_is_not_shown_as_a_number(track_panel):
    track_panel.show_scene(replace(CARD, mean_confidence=float("nan")))
    assert "not known" in words(track_panel)


def test_a_new_name_is_sent_once(track_panel, qtbot, heard):
    edited = heard(track_panel.name_edited)
    track_panel._name.setText("blue coat")
    qtbot.keyClick(track_panel._name, Qt.Key.Key_Return)
    track_panel.show_scene(replace(CARD, name="blue coat"))
    track_panel._name.editingFinished.emit()
    assert edited == [(4, "blue coat")]


def test_escape_puts_the_name_back(track_panel, qtbot, heard):
    edited = heard(track_panel.name_edited)
    track_panel._name.setText("blue coat")
    qtbot.keyClick(track_panel._name, Qt.Key.Key_Escape)
    assert track_panel._name.text() == "red coat"
    assert edited == []


def test_changed_attributes_are_sent_all_together(track_panel, heard):
    edited = heard(track_panel.attributes_edited)
    table = track_panel._attributes
    table.add_row()
    for typed in ("coat", "red"):
        QTest.keyClicks(table.focusWidget(), typed)
        QTest.keyClick(table.focusWidget(), Qt.Key.Key_Tab)
    assert edited[-1] == (4, (("bag", "none"), ("coat", "red")))


def test_an_attribute_can_be_removed(track_panel, qtbot, heard):
    edited = heard(track_panel.attributes_edited)
    track_panel._attributes.setCurrentCell(0, 0)
    qtbot.mouseClick(track_panel._attributes.remove_button, LEFT)
    assert edited == [(4, ())]


def test_the_ends_of_a_track_can_be_gone_to(track_panel, qtbot):
    with qtbot.waitSignal(track_panel.frame_sought) as sought:
        qtbot.mouseClick(track_panel._last, LEFT)
    assert sought.args == [402]


def test_without_a_track_it_says_how_to_select_one(track_panel):
    track_panel.show_scene(None)
    assert track_panel._scroll.isHidden()
    assert "Click a person" in words(track_panel)


def test_the_windows_actions_are_offered_as_named_buttons(track_panel, qtbot):
    action = QAction("&Swap with...", track_panel)
    for _ in range(2):
        track_panel.set_actions([action])
    assert [tool.accessibleName() for tool in track_panel._tools] == ["Swap with..."]
    with qtbot.waitSignal(action.triggered):
        qtbot.mouseClick(track_panel._tools[0], LEFT)


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


@pytest.fixture
def preview(qtbot, dark):
    bar = EditPanel()
    qtbot.addWidget(bar)
    bar.show_scene(SWAP)
    return bar


def press(bar, name: str, qtbot):
    buttons = bar.findChildren(QAbstractButton)
    qtbot.mouseClick(next(one for one in buttons if one.accessibleName() == name), LEFT)


def test_a_preview_tells_what_where_and_how_far(preview):
    (row,) = SWAP.choices
    for part in (SWAP.title, "91 frames change", "834", "849", "790", *row.options):
        assert part in words(preview)


def test_a_preview_is_done_left_moved_and_widened(preview, qtbot, heard):
    signals = ("confirmed", "cancelled", "cut_moved", "end_moved", "other_typed", "cut_proposed")
    said = [heard(getattr(preview, name)) for name in signals]
    choices = heard(preview.choice_made)
    for name in (
        "Do the edit",
        "Leave the edit undone",
        "From a frame earlier",
        "to a frame later",
        "9",
        "Changed over at 790 near",
        "this range",
    ):
        press(preview, name, qtbot)
    assert said == [[()], [()], [-1], [1], [9], [1]]
    assert choices == [(0, 1)]


def test_while_the_other_person_is_to_be_picked_nothing_can_be_done_yet(preview):
    preview.show_scene(
        EditPreview("Swap 4 with...", ("Pick the other person",), 834, other=0, ready=False)
    )
    assert "Pick the other person" in words(preview)
    assert not preview._confirm.isEnabled()
    assert preview._frames.isHidden()


def test_without_a_preview_the_bar_is_hidden(preview):
    preview.show_scene(None)
    assert preview.isHidden()


def test_the_review_queue_says_why_it_is_empty(qtbot, dark):
    panel = ReviewPanel()
    qtbot.addWidget(panel)
    panel.show_scene(ReviewScene(title="Nothing left to look at", text="All is decided."))
    assert "Nothing left to look at" in words(panel)
    assert "All is decided." in words(panel)
    assert panel._list.isHidden()


@pytest.mark.parametrize(
    "kind", [TrackPanel, HistoryPanel, EditPanel, ReviewPanel, DifferencesPanel]
)
def test_every_control_has_a_name_for_screen_readers(qtbot, dark, kind):
    widget = kind()
    qtbot.addWidget(widget)
    if kind is TrackPanel:
        widget.show_scene(CARD)
    controls = widget.findChildren(QLineEdit) + widget.findChildren(QAbstractButton)
    ours = [one for one in controls if not one.objectName().startswith("qt_")]
    assert [one for one in ours if not (one.accessibleName() or one.text())] == []


def test_the_other_persons_id_can_be_typed(preview, qtbot, heard):
    typed = heard(preview.other_typed)
    preview.show_scene(EditPreview("Swap 4 with...", (), 834, other=0, ready=False))
    QTest.keyClicks(preview._other, "12x")
    qtbot.keyClick(preview._other, Qt.Key.Key_Return)
    assert typed == [12]


def test_an_edit_without_a_cut_cannot_be_moved(preview):
    preview.show_scene(replace(SWAP, has_cut=False, other=None))
    assert preview._frames.isHidden()
    assert preview._other_line.isHidden()
    assert not preview._confirm.isHidden()


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


def test_a_name_that_was_refused_is_put_back(track_panel, qtbot, heard):
    edited = heard(track_panel.name_edited)
    track_panel._name.setText("blue coat")
    qtbot.keyClick(track_panel._name, Qt.Key.Key_Return)
    assert track_panel._name.text() == "red coat"
    assert edited == [(4, "blue coat")]


def test_a_single_frame_is_not_said_in_the_plural(track_panel):
    track_panel.show_scene(replace(CARD, frames_seen=1, frames_predicted=0))
    assert "1 frame, 0 predicted" in words(track_panel)


def test_what_the_trails_of_a_preview_mean_is_said_once_there_are_any(preview):
    assert not preview._legend.isHidden()
    preview.show_scene(replace(SWAP, ready=False, other=0))
    assert preview._legend.isHidden()


def test_errors_have_a_ground_of_their_own(qtbot, dark, drawn):
    notice = NoticeBar()
    qtbot.addWidget(notice)
    notice.resize(600, 50)
    grounds = {}
    for is_error in (True, False):
        notice.say("The disk is full", is_error=is_error)
        grounds[is_error] = drawn(notice).pixelColor(5, 25).name()
    assert grounds == {True: dark.danger_ground.name(), False: dark.selection.name()}


def test_rows_of_differences_take_another_line_where_their_words_do_not_fit(qtbot):
    panel = DifferencesPanel()
    qtbot.addWidget(panel)
    words = "1 stands elsewhere for 3.0 s, by up to 0.6 m, where nobody was before"
    item = DifferenceItem(0, "Elsewhere", (), "00:04 - 00:07", words, False)
    side = Side("run 0", "run 0", True)
    panel.show_scene(DifferencesScene(side, side, (item,)))
    panel.show()
    heights = []
    for width in (280, 900):
        panel.resize(width, 500)
        qtbot.wait(1)
        heights.append(panel._list.sizeHintForRow(0))
    assert heights[0] > heights[1]
