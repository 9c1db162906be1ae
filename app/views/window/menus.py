"""Menus and keys from the catalogue of commands."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QMainWindow,
    QMenu,
    QPlainTextEdit,
    QTextEdit,
)

from app.presenters.commands import COMMANDS, MENUS, Command
from app.presenters.scenes import CommandItem
from app.presenters.words import tr
from app.views.correcting.attributes import AttributesTable
from app.views.look.icons import icon
from app.views.widgets.id_edit import IdEdit

_TYPING = (
    QLineEdit,  # also what a cell of a table is typed into
    QPlainTextEdit,
    QTextEdit,
    QAbstractSpinBox,
    QComboBox,
    AttributesTable,  # a letter begins to type into its cell
)


class Menus(QObject):
    """The menu bar of a window; `asked(name)` says which command the user wants.

    Attributes:
        actions: by the name of their command. menus: by menu and submenu, "" for the menu itself.
    """

    asked = Signal(str)

    def __init__(self, window: QMainWindow) -> None:
        super().__init__(window)
        self.actions: dict[str, QAction] = {}
        self._filling = False
        self.menus = {(name, ""): window.menuBar().addMenu("&" + tr(name)) for name in MENUS}
        for command in COMMANDS:
            menu = self._menu_of(command)
            action = self._action(command, window)
            menu.addAction(action)
            self.actions[command.name] = action
        self.draw_icons()

    def show_items(self, items: Sequence[CommandItem]) -> None:
        """Enable, tick and explain the commands."""
        self._filling = True
        for item in items:
            action = self.actions[item.command]
            action.setEnabled(item.enabled)
            action.setStatusTip(item.why_not)
            action.setToolTip(_tip(item))
            if item.checked is not None:
                action.setChecked(item.checked)
        self._filling = False

    def command_of(self, keys: QKeySequence) -> str:
        """The command that has these keys; "" where none has."""
        having = (name for name, action in self.actions.items() if keys in action.shortcuts())
        return next(having, "")

    def draw_icons(self) -> None:
        """Draw the icons in the colours of the look in force."""
        for command in COMMANDS:
            if command.icon:
                self.actions[command.name].setIcon(icon(command.icon))

    def _menu_of(self, command: Command) -> QMenu:
        """The menu or submenu the command stands in, with the line above it where it has one."""
        outer, place = self.menus[command.menu, ""], (command.menu, command.submenu)
        begins = place not in self.menus
        if command.separated:
            (outer if begins else self.menus[place]).addSeparator()
        if begins:
            self.menus[place] = outer.addMenu(tr(command.submenu))
        return self.menus[place]

    def _action(self, command: Command, window: QMainWindow) -> QAction:
        action = QAction(tr(command.title), window)
        action.setShortcuts([QKeySequence(key) for key in command.keys])
        action.setIconText(tr(command.title).rstrip("."))
        action.setShortcutContext(Qt.ShortcutContext.WindowShortcut)
        action.setCheckable(command.checkable)
        action.triggered.connect(lambda _=False, name=command.name: self._ask(name))
        return action

    def _ask(self, name: str) -> None:
        if not self._filling:
            self.asked.emit(name)


class TypingGuard(QObject):
    """Lets a text field have every key that is typed into it, also those that are shortcuts.

    Keys with Ctrl stay shortcuts unless the field itself wants them.

    Attributes:
        typed: the key pressed last went into a field: it is no command, also where the field
            passes it on, as it does with Enter.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.typed = False

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Accept the keys for the field; Qt then types them instead of running a shortcut."""
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


def _tip(item: CommandItem) -> str:
    title = item.title.rstrip(".")
    keys = f"  ({item.keys[0]})" if item.keys else ""
    return f"{title}{keys}" + (f"\n{item.why_not}" if item.why_not else "")
