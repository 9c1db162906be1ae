"""In a made-up language every text of the window is translated; what stays English was missed."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from opened_session import open_with_anna
from PySide6.QtCore import QAbstractItemModel, QAbstractListModel, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QMenu,
    QWidget,
)

from app.shell import language_choice
from app.shell.features import FEATURES
from tests.pseudo import TRANSLATED, Pseudo
from tracking.trackers import TRACKERS
from tracking.translation import use_catalogue

_DIALOGS = (
    *("tracks.track", "file.export", "file.author", "detector.train", "help.keys", "tracks.runs"),
    "edit.commands",
)
PANELS = (*(f"view.{feature.id}" for feature in FEATURES if feature.opens), "labels.parts")
_WORD = re.compile(r"[A-Za-z]{3,}")
_DATA = frozenset({"HOTA", "IDF1", "MOTA", "MOTP", "trackwright"})
_OF_QT = frozenset({"Cancel", "Close", "Save", "OK", "Scroll Left", "Scroll Right"})
"""What Qt translates by files of its own."""


@pytest.fixture
def pseudo(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(language_choice, "use_language", lambda: use_catalogue(Pseudo()))
    yield
    use_catalogue(None)


@pytest.fixture
def opened(pseudo, window, qtbot, parted_session):
    open_with_anna(window, qtbot, parted_session)
    window.bring_up_to_date()
    return window


def texts_of(widget: QWidget) -> Iterator[str]:
    """What a person can read of a widget, or a screen reader say."""
    if not isinstance(widget, QMenu):
        yield from (widget.toolTip(), widget.accessibleName(), widget.windowTitle())
    if isinstance(widget, (QLabel, QAbstractButton)):
        yield widget.text()
    if isinstance(widget, QLineEdit):
        yield widget.placeholderText()
    if isinstance(widget, (QComboBox, QAbstractItemView)) and widget.model() is not None:
        yield from cells_of(widget.model())
    for action in widget.actions():
        yield from (action.text(), action.toolTip(), action.statusTip())


def cells_of(model: QAbstractItemModel) -> Iterator[str]:
    columns = 1 if isinstance(model, QAbstractListModel) else model.columnCount()
    for column in range(columns):
        yield str(model.headerData(column, Qt.Orientation.Horizontal) or "")
        for row in range(min(model.rowCount(), 50)):
            yield str(model.index(row, column).data() or "")


def untranslated(window: QWidget, known: set[str]) -> set[str]:
    """Texts with words that are neither translated nor data."""
    found = set()
    for widget in (window, *window.findChildren(QWidget)):
        for text in texts_of(widget):
            words = set(_WORD.findall(text.replace("&", "")))
            if words - _DATA and TRANSLATED not in text and text not in known | _OF_QT:
                found.add(text)
    return found


def names_of_data(window) -> set[str]:
    """What the recording and people are called, and keys."""
    document = window.controller.document
    return {
        document.recording.name,
        "Anna",
        window.windowTitle(),
        *TRACKERS,
        *(key for command in window.registry.commands for key in command.keys),
    }


def test_every_text_of_the_window_is_translated(opened, qtbot):
    for name in PANELS:
        opened.run_command(name)
    opened.run_command("tracks.swap")
    qtbot.wait(50)
    assert "\n".join(sorted(untranslated(opened, names_of_data(opened)))) == ""


@pytest.mark.parametrize("command", _DIALOGS)
def test_every_text_of_a_dialog_is_translated(opened, command):
    opened.run_command(command)
    dialogs = opened.findChildren(QDialog) or [opened.palette_of_commands]
    found = set().union(*(untranslated(one, names_of_data(opened)) for one in dialogs))
    for dialog in dialogs:
        dialog.close()
    assert "\n".join(sorted(found)) == ""


def test_every_text_of_the_first_page_is_translated(pseudo, window):
    assert "\n".join(sorted(untranslated(window, set()))) == ""
