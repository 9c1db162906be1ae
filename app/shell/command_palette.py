"""Ctrl+K: find a command by a few of its letters."""

from __future__ import annotations

import re

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, Signal
from PySide6.QtGui import QHideEvent, QKeyEvent
from PySide6.QtWidgets import (
    QFrame,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.theme import scaled_font
from app.core.scenes import CommandItem
from app.core.widgets.command_list import ITEM, CommandDelegate, row_height
from app.core.widgets.parts import quiet

_MOST_FOUND = 60
_ROWS = 10


def match_score(typed: str, text: str) -> float | None:
    """How well letters typed in order are found in a text; None where they are not.

    Letters at the start of words and runs of letters count more; short texts before long ones.
    """
    letters, lower = typed.lower().replace(" ", ""), text.lower()
    score, at, previous = 0.0, 0, -2
    for letter in letters:
        starts = [i for i in range(at, len(lower)) if lower[i] == letter]
        if not starts:
            return None
        at = next(
            (i for i in starts if i == previous + 1 or not lower[i - 1 : i].isalnum()), starts[0]
        )
        score += 3.0 if at == previous + 1 else 2.0 if not lower[at - 1 : at].isalnum() else 0.5
        previous, at = at, at + 1
    if typed.strip().lower() in lower:
        score += 4.0 * len(letters)
    return score - 0.01 * len(text)


def best_commands(typed: str, items: tuple[CommandItem, ...]) -> list[CommandItem]:
    """The commands that match, best first; all in their own order where nothing is typed.

    What is written as typed, at the start of words or within them, leaves out what is only spelled
    by the beginnings of its words ("dfh" for "Delete from here"). Among those that match alike,
    titles, of this language or English, come before menus and further words; then what can be
    done now.
    """
    if not typed.strip():
        return list(items)
    found: list[tuple[tuple[int, bool, bool, float], CommandItem]] = []
    for item in items:
        titles = {item.title, item.english or item.title}
        text = f"{' '.join(sorted(titles))} {item.menu} {item.also}".rstrip()
        likeness = _likeness(typed, text)
        if likeness is not None:
            titled = any(_likeness(typed, title) == likeness for title in titles)
            score = match_score(typed, text) or 0.0
            found.append(((-likeness, not titled, not item.enabled, -score), item))
    found.sort(key=lambda pair: pair[0])
    written = any(-rank[0] > _SPELLED for rank, _ in found)
    kept = [item for rank, item in found if -rank[0] > _SPELLED or not written]
    return kept[:_MOST_FOUND]


_STARTS, _WITHIN, _SPELLED = 2, 1, 0
"""How a text has what is typed: words begin so; it is written somewhere; beginnings spell it."""


def _likeness(typed: str, text: str) -> int | None:
    """How a text has every word that is typed; None: it has not."""
    words, lower = typed.lower().split(), text.lower()
    if all(re.search(rf"(?<!\w){re.escape(word)}", lower) for word in words):
        return _STARTS
    if all(word in lower for word in words):
        return _WITHIN
    return _SPELLED if _spells("".join(words), re.findall(r"\w+", lower)) else None


def _spells(letters: str, words: list[str]) -> bool:
    """Whether letters are made of beginnings of some of the words, in their order."""
    if not letters:
        return True
    for at, word in enumerate(words):
        lengths = range(min(len(letters), len(word)), 0, -1)
        begun = (n for n in lengths if word.startswith(letters[:n]))
        if any(_spells(letters[n:], words[at + 1 :]) for n in begun):
            return True
    return False


class CommandPalette(QFrame):
    """A list over the middle of the window.

    Signals:
        run_asked(str): the id of the command chosen. left(): it is gone, whatever for.
    """

    run_asked = Signal(str)
    left = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._items: tuple[CommandItem, ...] = ()
        self.setProperty("popup", True)
        self.setWindowFlag(Qt.WindowType.Popup)
        self.setAccessibleName(tr("Commands"))
        rows = QVBoxLayout(self)
        rows.setContentsMargins(8, 8, 8, 8)
        rows.setSpacing(8)
        self._edit = QLineEdit(self)
        self._edit.setPlaceholderText(tr("Search commands"))
        self._edit.setAccessibleName(tr("Search commands"))
        self._edit.setFont(scaled_font(self.font(), 1.2))
        self._edit.textChanged.connect(self._search)
        self._edit.installEventFilter(self)
        self._list = QListWidget(self)
        self._list.setAccessibleName(tr("Commands found"))
        self._list.setItemDelegate(CommandDelegate(self._list))
        self._list.setProperty("rows", True)
        self._list.setUniformItemSizes(True)
        self._list.setMouseTracking(True)
        self._list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._list.itemClicked.connect(self._run)
        self._none = quiet(tr("No command matches."), self)
        rows.addWidget(self._edit)
        rows.addWidget(self._list, 1)
        rows.addWidget(self._none)

    def show_scene(self, items: tuple[CommandItem, ...]) -> None:
        """Know other commands."""
        self._items = items
        self._search(self._edit.text())

    def open_over(self, window: QWidget) -> None:
        """Appear in the upper middle of a window, empty and ready to type."""
        line = row_height(self.fontMetrics())
        width = min(96 * self.fontMetrics().averageCharWidth(), window.width() - 32)
        self.resize(width, min((_ROWS + 2) * line, window.height() - 32))
        left = (window.width() - self.width()) // 2
        self.move(window.mapToGlobal(QPoint(left, max(16, window.height() // 8))))
        self._edit.clear()
        self._search("")
        self.show()
        self._edit.setFocus(Qt.FocusReason.PopupFocusReason)

    def hideEvent(self, event: QHideEvent) -> None:  # noqa: N802 - Qt's name
        """Say so, so that the window has the keys again also where nothing gives it them back."""
        super().hideEvent(event)
        self.left.emit()

    def _search(self, typed: str) -> None:
        self._list.clear()
        for item in best_commands(typed, self._items):
            row = QListWidgetItem(item.title)
            row.setData(ITEM, item)
            self._list.addItem(row)
        self._list.setCurrentRow(0)
        self._none.setVisible(self._list.count() == 0)

    def _run(self, row: QListWidgetItem | None) -> None:
        item = row.data(ITEM) if row is not None else None
        if isinstance(item, CommandItem) and item.enabled:
            self.hide()
            self.run_asked.emit(item.command)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Arrows move in the list while the cursor stays in the line."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            steps = {Qt.Key.Key_Down: 1, Qt.Key.Key_Up: -1, Qt.Key.Key_PageDown: 8}
            steps[Qt.Key.Key_PageUp] = -8
            key = Qt.Key(event.key())
            if key in steps:
                wanted = self._list.currentRow() + steps[key]
                self._list.setCurrentRow(min(max(wanted, 0), self._list.count() - 1))
                return True
            if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                self._run(self._list.currentItem())
                return True
            if key == Qt.Key.Key_Escape:
                self.hide()
                return True
        return super().eventFilter(watched, event)
