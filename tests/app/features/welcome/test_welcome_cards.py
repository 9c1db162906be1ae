"""The large choices of the welcome page."""

from __future__ import annotations

from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.core.look.theme import scaled_font
from app.features.welcome.welcome_parts import ChoiceButton


def test_a_card_is_as_wide_as_its_title_and_its_keys(qtbot: QtBot) -> None:
    page = QWidget()
    qtbot.addWidget(page)
    title = "Eine Aufnahme einrichten und vermessen"
    card, other = ChoiceButton("open", title, "", page), ChoiceButton("open", title, "Ctrl+O", page)
    words = QFontMetrics(scaled_font(card.font(), 1.2, bold=True)).horizontalAdvance(title)
    assert card.sizeHint().width() >= card.minimumSizeHint().width() > words
    assert other.minimumSizeHint().width() > card.minimumSizeHint().width()
