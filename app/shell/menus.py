"""Menus and keys from the catalogue of commands."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QHelpEvent, QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QMainWindow,
    QMenu,
    QPlainTextEdit,
    QTextEdit,
    QToolTip,
)

from app.core.commands import MENUS, Command, menu_of
from app.core.i18n import tr
from app.core.keymap import keys_of
from app.core.look.icons import icon
from app.core.scenes import CommandItem
from app.core.widgets.id_edit import IdEdit
from app.features.correction.attributes import AttributesTable

_TYPING = (
    QLineEdit,  # also what a cell of a table is typed into
    QPlainTextEdit,
    QTextEdit,
    QAbstractSpinBox,
    QComboBox,
    AttributesTable,  # a letter begins to type into its cell
)

_HOLD_MS = 3000
_OF_TEXT = (Qt.Key.Key_Backspace, Qt.Key.Key_Shift, Qt.Key.Key_AltGr, Qt.Key.Key_CapsLock)
"""Keys without letters that are part of typing."""


class Menus(QObject):
    """The menu bar of a window; `asked(name)` says which command the user wants.

    Attributes:
        actions: by the name of their command. menus: by menu and submenu, "" for the menu itself.
    """

    asked = Signal(str)

    def __init__(self, window: QMainWindow, commands: Sequence[Command[Any]]) -> None:
        super().__init__(window)
        self._commands = commands
        self.actions: dict[str, QAction] = {}
        self._filling = False
        self.menus = {(name, ""): window.menuBar().addMenu(_with_letter(name)) for name in MENUS}
        for command in commands:
            menu = self._menu_of(command)
            action = self._action(command, window)
            menu.addAction(action)
            self.actions[command.id] = action
        for menu in self.menus.values():
            menu.installEventFilter(self)
        self.draw_icons()

    def show_items(self, items: Sequence[CommandItem]) -> None:
        """Enable, tick and explain the commands."""
        self._filling = True
        for item in items:
            action = self.actions[item.command]
            action.setText(item.title.replace("&", "&&"))
            action.setEnabled(item.enabled)
            action.setStatusTip(item.why_not)
            action.setToolTip(_tip(item))
            if item.checked is not None:
                action.setChecked(item.checked)
        self._filling = False

    def use_keys(self) -> None:
        """Give every command the keys that are in use; a menu's letter gives way to them."""
        for name, action in self.actions.items():
            action.setShortcuts([QKeySequence(key) for key in keys_of(name)])
        taken = {key for name in self.actions for key in keys_of(name)}
        for name in MENUS:
            self.menus[name, ""].setTitle(_with_letter(name, taken))

    def command_of(self, keys: QKeySequence) -> str:
        """The command that has these keys; "" where none has."""
        having = (name for name, action in self.actions.items() if keys in action.shortcuts())
        return next(having, "")

    def draw_icons(self) -> None:
        """Draw the icons in the colours of the look in force."""
        for command in self._commands:
            if command.icon:
                self.actions[command.id].setIcon(icon(command.icon))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Say beside an entry that cannot be chosen why; what can be needs no words."""
        if isinstance(watched, QMenu) and isinstance(event, QHelpEvent):
            entry = watched.actionAt(event.pos())
            why = entry.statusTip() if entry is not None and not entry.isEnabled() else ""
            QToolTip.showText(event.globalPos(), why, watched)
            return True
        return super().eventFilter(watched, event)

    def _menu_of(self, command: Command[Any]) -> QMenu:
        """The menu or submenu the command stands in, with the line above it where it has one."""
        place = menu_of(command)
        outer = self.menus[place[0], ""]
        begins = place not in self.menus
        if command.separated:
            (outer if begins else self.menus[place]).addSeparator()
        if begins:
            self.menus[place] = outer.addMenu(tr(place[1]))
        return self.menus[place]

    def _action(self, command: Command[Any], window: QMainWindow) -> QAction:
        action = QAction(tr(command.title), window)
        action.setIconText(tr(command.title).rstrip("."))
        action.setShortcutContext(Qt.ShortcutContext.WindowShortcut)
        action.setCheckable(command.checked is not None)
        action.triggered.connect(lambda _=False, name=command.id: self._ask(name))
        return action

    def _ask(self, name: str) -> None:
        if not self._filling:
            self.asked.emit(name)


class TypingGuard(QObject):
    """Lets a text field have every key that is typed into it, also those that are shortcuts.

    Keys with Ctrl stay shortcuts unless the field itself wants them.

    After `hold` it takes what is typed from everybody: the text was meant for a field that could
    not be opened, and must not run as one command after the other. Enter, Esc, a click, any other
    key or a pause end that.

    Attributes:
        typed: the key pressed last went into a field: it is no command, also where the field
            passes it on, as it does with Enter.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.typed = False
        self._holding = QTimer(self, singleShot=True, interval=_HOLD_MS)

    @property
    def holds(self) -> bool:
        """Whether what is typed now is taken from everybody."""
        return self._holding.isActive()

    def hold(self) -> None:
        """Take what is typed from everybody until it ends."""
        self._holding.start()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Accept the keys for the field; Qt then types them instead of running a shortcut."""
        if event.type() == QEvent.Type.MouseButtonPress:
            self._holding.stop()
        if self.holds and isinstance(event, QKeyEvent):
            return self._take(event)
        if event.type() != QEvent.Type.ShortcutOverride or not isinstance(event, QKeyEvent):
            return super().eventFilter(watched, event)
        self.typed = (
            isinstance(focus := QApplication.focusWidget(), _TYPING)
            and not isinstance(focus, IdEdit)  # which lets through what is no digit
            and not event.modifiers() & Qt.KeyboardModifier.ControlModifier
            and event.key() not in range(Qt.Key.Key_F1, Qt.Key.Key_F35)
        )
        if self.typed:
            event.accept()
        return self.typed or super().eventFilter(watched, event)

    def _take(self, event: QKeyEvent) -> bool:
        """Keep a key of the text from everybody; its last one, Enter or Esc, too."""
        ends = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape)
        letters = bool(event.text()) and event.text().isprintable()
        of_text = ends or letters or event.key() in _OF_TEXT
        if event.type() == QEvent.Type.ShortcutOverride:
            if not of_text:
                self._holding.stop()
                return False
            event.accept()
        elif event.type() == QEvent.Type.KeyPress:
            if ends:
                self._holding.stop()
            else:
                self._holding.start()
        return True


def _with_letter(name: str, taken: Collection[str] = ()) -> str:
    """A menu's name with the letter that opens it: behind it where the name has no such letters.

    taken: keys of commands; where Alt and the letter is one of them, both would do nothing.
    """
    shown = tr(name)
    letter = shown[0] if shown[:1].isascii() else name[0]
    if f"Alt+{letter.upper()}" in taken:
        return shown
    return f"&{shown}" if shown[:1].isascii() else f"{shown}(&{name[0]})"


def _tip(item: CommandItem) -> str:
    title = item.title.rstrip(".")
    keys = f"  ({item.keys[0]})" if item.keys else ""
    return f"{title}{keys}" + (f"\n{item.why_not}" if item.why_not else "")
