"""The real window on the tiny session, with the keyboard at hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.views.desk.desk import Desk
from app.views.window.main_window import MainWindow

Press = Callable[..., None]


@pytest.fixture
def desk(window: MainWindow, qtbot: QtBot, tiny_session: Path) -> Desk:
    """The desk once its first frame is shown."""
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: window.desk is not None and window.desk.playback.frame is not None)
    assert window.desk is not None
    return window.desk


@pytest.fixture
def press(window: MainWindow, desk: Desk, qtbot: QtBot) -> Press:
    """Press a key where the keyboard is."""

    def press(key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        QTest.keyClick(window.focusWidget() or window, key, modifiers)
        qtbot.wait(1)

    return press
