"""What panels have in common, and the short ones."""

from __future__ import annotations

import pytest
from panel_words import CARD, words
from PySide6.QtWidgets import QAbstractButton, QLineEdit

from app.core.widgets.notice import NoticeBar
from app.features.comparison.differences_scene import DifferenceItem, DifferencesScene, Side
from app.features.comparison.panel import DifferencesPanel
from app.features.correction.panel import EditPanel
from app.features.correction.track_panel import TrackPanel
from app.features.history.panel import HistoryPanel
from app.features.review.panel import ReviewPanel
from app.features.review.scene import ReviewScene


def test_the_review_queue_says_why_it_is_empty(qtbot, dark):
    panel = ReviewPanel()
    qtbot.addWidget(panel)
    panel.show_scene(ReviewScene(title="No review items left", text="All is decided."))
    assert "No review items left" in words(panel)
    assert "All is decided." in words(panel)
    assert panel._list.isHidden()


def test_an_order_of_the_queue_is_called_as_on_the_command_line(qtbot, dark):
    panel = ReviewPanel()
    qtbot.addWidget(panel)
    orders = panel._orders
    said = {orders.itemText(at): orders.itemData(at) for at in range(orders.count())}
    assert said == {"by worth": "worth", "by time": "time"}


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


def test_the_differences_say_how_many_are_ticked_and_how_many_are_locked(qtbot):
    side = Side("run 0", "run 0", True)
    panel = DifferencesPanel()
    qtbot.addWidget(panel)
    panel.show_scene(DifferencesScene(side, side, ticked=21, takeable=21, locked=3))
    assert panel._ticks.text() == "21 of 24 ticked, 3 are locked"
