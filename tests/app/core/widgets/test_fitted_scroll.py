"""A panel is as high as its content while there is room, and scrolls where there is none."""

import pytest
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from app.core.widgets.fitted_scroll import ScrolledPanel

WORDS = "what is to be done here, in many words; " * 12


@pytest.fixture
def column(qtbot, dark):
    """A panel of words above something that takes the rest."""
    whole = QWidget()
    qtbot.addWidget(whole)
    rows = QVBoxLayout(whole)
    rows.setContentsMargins(0, 0, 0, 0)
    panel, rest = ScrolledPanel(whole), QWidget(whole)
    inside = QVBoxLayout(panel.content)
    words = QLabel(WORDS, panel.content)
    words.setWordWrap(True)
    inside.addWidget(words)
    rows.addWidget(panel)
    rows.addWidget(rest, 1)
    whole.resize(300, 700)
    with qtbot.waitExposed(whole):
        whole.show()
    return whole, panel, words


def _needed(panel):
    return panel.content.layout().totalHeightForWidth(panel.width())


def test_with_room_all_of_it_is_seen_and_no_more(column, qtbot):
    _, panel, words = column
    qtbot.waitUntil(lambda: panel.height() == _needed(panel))
    words.setText("few")
    qtbot.waitUntil(lambda: panel.height() == _needed(panel))
    assert panel.height() < 100


def test_without_room_it_scrolls_and_the_window_stays_low(column, qtbot):
    whole, panel, _ = column
    whole.resize(300, 160)
    qtbot.waitUntil(lambda: panel.height() <= 160)
    assert whole.height() == 160
    assert panel._area.verticalScrollBar().maximum() > 0


def test_with_room_a_panel_with_a_border_has_no_scroll_bar(column, qtbot):
    _, panel, words = column
    panel.setStyleSheet("ScrolledPanel { border: 1px solid red }")
    words.setText("few")
    qtbot.waitUntil(lambda: panel.height() < 100)
    assert panel._area.verticalScrollBar().maximum() == 0
