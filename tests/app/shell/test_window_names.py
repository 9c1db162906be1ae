"""Every control says its name to screen readers; every command is in a menu, with its key."""

import pytest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QDialog,
    QLineEdit,
    QPlainTextEdit,
    QWidget,
)

from app.core.commands import menu_of
from app.core.drawing.canvas import Canvas
from app.shell.commands import COMMANDS

_CONTROLS = (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QLineEdit,
    QPlainTextEdit,
    Canvas,
)


_WHOLE = (QAbstractSpinBox, QComboBox, QLineEdit, QAbstractItemView)


def _nameless(widget: QWidget) -> list[str]:
    """Visible controls without a name; Qt's own parts inside a control speak for themselves."""
    found = []
    for control in widget.findChildren(QWidget):
        part = control.objectName().startswith("qt_") or isinstance(control.parent(), _WHOLE)
        if part or not control.isVisible() or not isinstance(control, _CONTROLS):
            continue
        text = control.text() if isinstance(control, QAbstractButton) else ""
        if not (control.accessibleName() or text):
            found.append(f"{type(control).__name__} in {type(control.parent()).__name__}")
    return found


@pytest.fixture
def opened(window, qtbot, tiny_session):
    window.files.open_path(tiny_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    window.controller.editing.pick(window.controller.document.tracks.ids[0])
    return window


def test_every_control_of_the_window_has_a_name(opened):
    opened.run_command("tracks.swap")
    assert _nameless(opened) == []


@pytest.mark.parametrize(
    "command", ["tracks.track", "detector.train", "help.keys", "edit.commands"]
)
def test_every_control_of_a_dialog_has_a_name(opened, command):
    opened.run_command(command)
    dialogs = opened.findChildren(QDialog) or [opened.palette_of_commands]
    assert [name for dialog in dialogs for name in _nameless(dialog)] == []
    for dialog in dialogs:
        dialog.close()


def test_every_command_stands_in_its_menu_with_its_key(window):
    menus = {menu.title().replace("&", ""): menu for menu in _menus(window)}
    for command in COMMANDS:
        name, submenu = menu_of(command)
        action, menu = window.menus.actions[command.id], menus[name]
        if submenu:
            inner = [one.menu() for one in menu.actions() if one.menu() is not None]
            menu = next(one for one in inner if one.title() == submenu)
        assert action in menu.actions()
        assert [keys.toString() for keys in action.shortcuts()] == list(command.keys)


def test_no_menu_is_longer_than_can_be_read_at_a_glance(window):
    menus = _menus(window)
    inner = [one.menu() for menu in menus for one in menu.actions() if one.menu() is not None]
    assert len(inner) >= 5
    for menu in menus + inner:
        entries = [action for action in menu.actions() if not action.isSeparator()]
        assert 2 <= len(entries) <= 16, menu.title()


def test_no_two_menus_open_with_the_same_letter(window):
    letters = [menu.title()[menu.title().index("&") + 1].lower() for menu in _menus(window)]
    assert len(letters) == len(set(letters))


def test_no_key_has_two_commands():
    keys = [key for command in COMMANDS for key in command.keys]
    assert len(keys) == len(set(keys))


def test_the_title_marks_what_is_not_saved(opened, qtbot):
    qtbot.waitUntil(lambda: "tiny.h5" in opened.windowTitle())
    assert not opened.isWindowModified()
    opened.controller.editing.rename(opened.controller.document.tracks.ids[0], "red coat")
    qtbot.waitUntil(opened.isWindowModified)
    opened.run_command("file.save")
    qtbot.waitUntil(lambda: not opened.isWindowModified())


def _menus(window):
    return [action.menu() for action in window.menuBar().actions()]
