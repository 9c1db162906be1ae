"""The card of a track."""

from __future__ import annotations

from dataclasses import replace

import pytest
from panel_words import CARD, words
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest

from app.features.correction.track_panel import TrackPanel

LEFT = Qt.MouseButton.LeftButton


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


def test_a_name_that_was_refused_is_put_back(track_panel, qtbot, heard):
    edited = heard(track_panel.name_edited)
    track_panel._name.setText("blue coat")
    qtbot.keyClick(track_panel._name, Qt.Key.Key_Return)
    assert track_panel._name.text() == "red coat"
    assert edited == [(4, "blue coat")]


def test_a_single_frame_is_not_said_in_the_plural(track_panel):
    track_panel.show_scene(replace(CARD, frames_seen=1, frames_predicted=0))
    assert "1 frame, 0 predicted" in words(track_panel)


def test_frames_in_which_nobody_was_seen_are_counted_apart(track_panel):
    apart = replace(CARD, frames_seen=9, frames_predicted=2, frames_interpolated=21)
    track_panel.show_scene(replace(apart, frames_occluded=1))
    assert "9 frames, 2 predicted, 21 interpolated, 1 occluded" in words(track_panel)


def test_of_a_long_name_the_beginning_is_seen(track_panel):
    track_panel.show_scene(replace(CARD, name="Bob Mueller with a very long name indeed " * 3))
    assert track_panel._name.cursorPosition() == 0


def test_another_person_is_shown_from_the_top(track_panel, qtbot):
    track_panel.show_scene(CARD)
    track_panel.resize(300, 220)
    with qtbot.waitExposed(track_panel):
        track_panel.show()
    bar = track_panel._scroll.verticalScrollBar()
    bar.setValue(bar.maximum())
    assert bar.value() > 0
    track_panel.show_scene(replace(CARD, mean_confidence=0.5))
    assert bar.value() > 0  # the same person: nothing moves
    track_panel.show_scene(replace(CARD, track=CARD.track + 1))
    assert bar.value() == 0


def test_three_attributes_are_in_sight_at_least(track_panel):
    table = track_panel._attributes
    rows = table.minimumHeight() - table.horizontalHeader().sizeHint().height()
    assert rows >= 3 * table.verticalHeader().defaultSectionSize()
