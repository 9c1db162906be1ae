"""The large choices of the welcome page."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.features.welcome.welcome_parts import ChoiceButton


def test_a_card_is_as_high_as_its_title_needs_beside_its_keys(qtbot: QtBot) -> None:
    page = QWidget()
    qtbot.addWidget(page)
    title = "Eine Aufnahme einrichten und vermessen"
    cards = [ChoiceButton("open", text, keys, page) for text, keys in ((title, ""), ("A", ""))]
    long, short = cards
    for card in cards:
        card.resize(200, 100)
    assert long.sizeHint().height() > short.sizeHint().height()
    with_keys = ChoiceButton("open", title, "Ctrl+Alt+Shift+O", page)
    with_keys.resize(200, 100)
    assert with_keys.sizeHint().height() >= long.sizeHint().height()
