"""A person before the real window, who has a keyboard and a mouse and nothing else.

Keys go to the window that has the keyboard, and clicks to the place on the screen, as a desktop
delivers them: what is covered is not clicked, what has not the focus is not typed into.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAction, QGuiApplication, QInputMethodEvent, QKeySequence, QWindow
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QDialog,
    QListWidget,
    QMenu,
    QWidget,
)
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.core.commands import menu_of
from app.core.keymap import first_key
from app.core.scenes import CommandItem
from app.core.widgets.command_list import ITEM
from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController

NO_KEY = Qt.KeyboardModifier.NoModifier
LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
_STEPS = 5
"""Moves of the mouse in a drag."""
_POPUPS = 20
"""Presses of Esc that close what popped up, at most."""
_GLANCE = 4
"""Letters typed until one looks at what was found."""


@dataclass(frozen=True, slots=True)
class Person:
    """Presses, types, clicks, drags; looks at what is shown."""

    window: MainWindow
    qtbot: QtBot

    @property
    def controller(self) -> RecordingController:
        """Of the open recording."""
        controller = self.window.controller
        assert controller is not None, "a recording is open"
        return controller

    # keyboard

    def press(self, *keys: str) -> None:
        """Press keys, named as the program shows them, e.g. "Ctrl+K"."""
        for key in keys:
            for combination in _combinations(key):
                before = self._with_keyboard()
                try:
                    QTest.keyClick(before, *combination)
                except RuntimeError:
                    if isValid(before):  # else the key closed it, as Enter does in a dialog
                        raise
            self.look()

    def type(self, text: str) -> None:
        """Type a text; letters that no key has come from an input method, as on a desktop."""
        for letter in text:
            if letter.isascii():
                QTest.keyClick(self._with_keyboard(), letter)
            else:
                self._compose(letter)
        self.look()

    def _compose(self, text: str) -> None:
        focused = QGuiApplication.focusObject()
        assert focused is not None, "a control has the keyboard"
        written = QInputMethodEvent()
        written.setCommitString(text)
        QApplication.sendEvent(focused, written)

    def paste(self, text: str) -> None:
        """Paste a text that was copied elsewhere."""
        QGuiApplication.clipboard().setText(text)
        self.press("Ctrl+V")

    def key_of(self, command: str) -> None:
        """Press the key that is shown for a command."""
        key = first_key(command)
        assert key, f"{command} has no key"
        self.press(key)

    def search(self, command: str) -> None:
        """Ctrl+K, the command's words until it comes first, Enter."""
        self.press(first_key("edit.commands"))
        palette = self.window.palette_of_commands
        assert palette.isVisible(), "the search is open"
        found = palette.findChild(QListWidget)
        assert found is not None
        title = self.title(command)
        for at in range(0, len(title), _GLANCE):
            self.type(title[at : at + _GLANCE])
            if _first(found) == command:
                break
        for _ in range(found.count()):
            if _first(found) == command:
                break
            self.press("Down")
        assert _first(found) == command, f"{title} is not found"
        self.press("Return")

    def leave_popups(self) -> None:
        """Esc until no menu and no search is open."""
        for _ in range(_POPUPS):
            if QApplication.activePopupWidget() is None:
                break
            self.press("Esc")
        assert QApplication.activePopupWidget() is None, "what popped up does not leave"
        self._menu_closed()

    # mouse

    def click(
        self,
        widget: QWidget,
        at: QPointF | QPoint | None = None,
        button: Qt.MouseButton = LEFT,
        modifiers: Qt.KeyboardModifier = NO_KEY,
    ) -> None:
        """Click a place of a widget; without one its middle."""
        window, place = self._place(widget, at)
        QTest.mouseClick(window, button, modifiers, place)
        self.look()

    def drag(self, widget: QWidget, start: QPointF, end: QPointF) -> None:
        """Drag over a widget."""
        window, first = self._place(widget, start)
        _, last = self._place(widget, end)
        QTest.mousePress(window, LEFT, NO_KEY, first)
        for step in range(1, _STEPS + 1):
            QTest.mouseMove(window, first + (last - first) * step / _STEPS)
        QTest.mouseRelease(window, LEFT, NO_KEY, last)
        self.look()

    def choose(self, command: str) -> None:
        """Click through the menu bar to a command."""
        menus, bar = self.window.menus, self.window.menuBar()
        place = menu_of(next(one for one in self.window.registry.commands if one.id == command))
        outer = menus.menus[place[0], ""]
        self.click(bar, bar.actionGeometry(outer.menuAction()).center())
        if place[1]:
            self.click_entry(outer, menus.menus[place].menuAction())
        self.click_entry(menus.menus[place], menus.actions[command])

    def click_entry(self, menu: QMenu, entry: QAction) -> None:
        """Click an entry of a menu that is open."""
        assert menu.isVisible(), f"{menu.title()} is open"
        place = menu.actionGeometry(entry)
        assert menu.rect().contains(place), f"{entry.text()} can be seen"
        self.click(menu, place.center())
        self._menu_closed()

    def click_text(self, text: str, inside: QWidget | None = None) -> None:
        """Click the button that says this."""
        self.click(self.button(text, inside))

    # looking

    def look(self) -> None:
        """Let the window draw what came of it."""
        self.qtbot.wait(1)

    def wait(self, until: Callable[[], bool]) -> None:
        """Wait until something is so."""
        self.qtbot.waitUntil(until)

    def title(self, command: str) -> str:
        """What a command is called now."""
        return self.window.registry.item(command).title

    def button(self, text: str, inside: QWidget | None = None) -> QAbstractButton:
        """The button that says this, in a part of the window or in the dialog in front."""
        where = inside or self.dialog()
        for one in where.findChildren(QAbstractButton):
            said = one.text().replace("&", "") or one.accessibleName()
            if said == text and one.isVisible() and one.isEnabled():
                return one
        raise AssertionError(f"no button says {text}")

    def dialog(self) -> QWidget:
        """The dialog in front; where there is none the window."""
        front = QApplication.activeModalWidget()
        if front is None:
            asked = [one for one in self.window.findChildren(QDialog) if one.isVisible()]
            front = asked[-1] if asked else self.window
        return front

    # where things are

    def _menu_closed(self) -> None:
        """A desktop gives the keyboard back when a menu closes; the offscreen one does not."""
        closed = QApplication.activePopupWidget() is None
        if closed and QGuiApplication.focusWindow() is None:
            self.dialog().activateWindow()
            self.wait(lambda: QGuiApplication.focusWindow() is not None)

    def _with_keyboard(self) -> QWindow | QWidget:
        """The window that keys go to.

        Qt for Python may hand out a window that has gone in place of a new one where the old one
        was in memory; the control that has the keyboard is asked then.
        """
        popup = QApplication.activePopupWidget()
        if isinstance(popup, QAbstractItemView):  # proposals below a field, which has the focus
            return popup
        window = popup.windowHandle() if popup is not None else QGuiApplication.focusWindow()
        assert window is not None, "no window has the keyboard"
        if isValid(window):
            return window
        focused = QApplication.focusWidget()
        assert focused is not None, "a control has the keyboard"
        return focused

    def _place(
        self, widget: QWidget, at: QPointF | QPoint | None
    ) -> tuple[QWindow | QWidget, QPoint]:
        """A place of a widget in its window; in itself where that is out of date, as for keys."""
        assert widget.isVisible(), f"{widget} is seen"
        inner = widget.rect().center() if at is None else at
        place = inner.toPoint() if isinstance(inner, QPointF) else inner
        handle = widget.window().windowHandle()
        assert handle is not None
        if not isValid(handle):
            return widget, place
        return handle, widget.mapTo(widget.window(), place)


def _first(found: QListWidget) -> str:
    """The command that Enter would run."""
    row = found.currentItem()
    item = row.data(ITEM) if row is not None else None
    return item.command if isinstance(item, CommandItem) else ""


def _combinations(keys: str) -> list[tuple[Qt.Key, Qt.KeyboardModifier]]:
    sequence = QKeySequence(keys, QKeySequence.SequenceFormat.PortableText)
    pressed = [sequence[at] for at in range(sequence.count())]
    return [(one.key(), one.keyboardModifiers()) for one in pressed]
