"""Keys of commands are changed in the real window, and everything that names them follows."""

import pytest
from person import Person
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolTip

from app.core.commands import MENUS
from app.core.keymap import keys_of
from app.core.look.icons import IconButton
from app.features.keys.dialog import KeysDialog
from app.features.keys.scene import SHIPPED, OwnKeys
from app.shell.shortcuts import ShortcutsDialog


@pytest.fixture
def dialog(window, qtbot):
    window.run_command("edit.keys")
    dialog = window.findChild(KeysDialog)
    qtbot.waitUntil(dialog.isVisible)
    return dialog


def _choose(dialog, command):
    rows = range(dialog.table.rowCount())
    row = next(r for r in rows if dialog.table.item(r, 0).data(Qt.ItemDataRole.UserRole) == command)
    dialog.table.setCurrentCell(row, 0)
    return row


def test_a_key_is_added_by_pressing_it_and_runs_the_command(window, dialog, qtbot):
    row = _choose(dialog, "file.setup")
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_U, Qt.KeyboardModifier.ControlModifier)
    assert keys_of("file.setup") == ("Ctrl+U",)
    assert dialog.table.item(row, 2).text().startswith("Ctrl+U")
    assert window.menus.actions["file.setup"].shortcut().toString() == "Ctrl+U"


def test_tab_and_enter_can_be_keys(window, dialog, qtbot):
    _choose(dialog, "file.setup")
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_Tab, Qt.KeyboardModifier.ControlModifier)
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_Return, Qt.KeyboardModifier.AltModifier)
    assert keys_of("file.setup") == ("Alt+Return", "Ctrl+Tab")


def test_a_sign_that_needs_shift_is_the_sign_alone(dialog, qtbot):
    _choose(dialog, "file.setup")
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_Question, Qt.KeyboardModifier.ShiftModifier)
    assert keys_of("file.setup") == ("?",)


def test_a_conflict_is_told_and_taken_over_or_left(dialog, qtbot):
    _choose(dialog, "tracks.split")
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_X)
    assert dialog.said.text() == 'X belongs to "Swap with". Take it for "Split here"?'
    dialog.leave.click()
    assert keys_of("tracks.split") == ("S",)
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_X)
    dialog.take.click()
    assert (keys_of("tracks.split"), keys_of("tracks.swap")) == (("X", "S"), ())


def test_a_profile_changes_menus_cheat_sheet_palette_and_tooltips(window, dialog, qtbot):
    dialog.profile.setCurrentIndex(dialog.profile.findData("cvat"))
    dialog.profile.activated.emit(dialog.profile.currentIndex())
    dialog.reject()
    assert window.menus.actions["play.next"].shortcut().toString() == "F"
    shown = {item.command: item.keys for item in window.registry.items()}
    assert shown["tracks.draw"] == ("N", "W")
    sheet = ShortcutsDialog(window.registry.items(), window)
    assert any("N" in item.keys for item in sheet._items)
    buttons = window.workspace.transport.findChildren(IconButton)
    forward = next(one for one in buttons if one.accessibleName() == "Next frame")
    window.show_workspace()
    assert "(F)" in _tooltip(forward)


def _tooltip(button):
    from PySide6.QtCore import QPoint
    from PySide6.QtGui import QHelpEvent
    from PySide6.QtWidgets import QApplication

    place = QPoint(2, 2)
    event = QHelpEvent(QHelpEvent.Type.ToolTip, place, button.mapToGlobal(place))
    QApplication.sendEvent(button, event)
    QToolTip.hideText()
    return button.toolTip()


def test_keys_are_there_again_at_the_next_start(window, dialog, remembered, qtbot):
    _choose(dialog, "tracks.swap")
    dialog.remove.click()
    dialog.reject()
    assert window.key_choice.own.changes == {"tracks.swap": ()}
    remembered.set_text("keys", "[keys]\n" + "a = " + 400 * "[")
    assert window.key_choice.own.changes == {}


def test_keys_are_written_to_a_file_and_read_again(dialog, tmp_path):
    _choose(dialog, "tracks.swap")
    dialog.remove.click()
    dialog.write(tmp_path / "mine.toml")
    dialog.reset_all.click()
    assert keys_of("tracks.swap") == ("X",)
    dialog.read(tmp_path / "mine.toml")
    assert keys_of("tracks.swap") == ()
    (tmp_path / "none.toml").write_text("no")
    dialog.read(tmp_path / "none.toml")
    assert "no profile of keys" in dialog.said.text()
    assert keys_of("tracks.swap") == ()


def test_a_refusal_names_the_key_in_use(dialog):
    _choose(dialog, "tracks.new")
    dialog.remove.click()
    dialog.reject()
    from types import SimpleNamespace

    from app.core.commands.conditions import session

    now = SimpleNamespace(document=SimpleNamespace(session=None), busy=False)
    assert session(now) == "track the recording first, or draw a person"


def test_of_several_keys_one_is_chosen_to_go(dialog, qtbot):
    _choose(dialog, "tracks.swap")
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_U, Qt.KeyboardModifier.ControlModifier)
    assert keys_of("tracks.swap") == ("Ctrl+U", "X")
    dialog.remove.click()
    next(one for one in dialog.keys_menu.actions() if one.text() == "X").trigger()
    assert keys_of("tracks.swap") == ("Ctrl+U",)


def test_a_question_is_of_the_command_it_was_asked_for(dialog, qtbot):
    _choose(dialog, "tracks.split")
    dialog.add.click()
    qtbot.keyClick(dialog.field, Qt.Key.Key_X)
    _choose(dialog, "file.setup")
    dialog.take.click()
    assert keys_of("tracks.split") == ("X", "S")
    assert keys_of("file.setup") == ()


def test_another_profile_asks_before_own_keys_go(dialog):
    _choose(dialog, "tracks.swap")
    dialog.remove.click()
    for answer, profile in ((dialog.leave, ""), (dialog.take, "cvat")):
        dialog.profile.setCurrentIndex(dialog.profile.findData("cvat"))
        dialog.profile.activated.emit(dialog.profile.currentIndex())
        assert "replaces your keys of 1 command" in dialog.said.text()
        answer.click()
        assert dialog.profile.currentData() == profile
        assert (keys_of("tracks.swap") == ()) is (profile == "")


def test_commands_that_are_unknown_here_are_named(dialog, tmp_path):
    (tmp_path / "mine.toml").write_text('[keys]\n"tracks.fly" = ["F"]\n"tracks.swap" = ["Q"]\n')
    dialog.read(tmp_path / "mine.toml")
    assert "without 1 command that is unknown here, tracks.fly" in dialog.said.text()
    assert keys_of("tracks.swap") == ("Q",)


@pytest.mark.parametrize("profile", SHIPPED)
def test_the_letter_of_every_menu_opens_it_in_every_profile(window, qtbot, profile):
    window.key_choice.use(OwnKeys(profile))
    with qtbot.waitActive(window):
        window.activateWindow()
    one = Person(window, qtbot)
    for name in MENUS:
        one.press(f"Alt+{name[0]}")
        assert window.menus.menus[name, ""].isVisible(), name
        one.leave_popups()


def test_the_letter_of_a_menu_gives_way_to_a_key_of_the_user(window, qtbot):
    window.key_choice.use(OwnKeys(changes={"help.about": ("Alt+F",)}))
    with qtbot.waitActive(window):
        window.activateWindow()
    one = Person(window, qtbot)
    one.press("Alt+F")
    assert not window.menus.menus["File", ""].isVisible()
    assert "trackwright: people tracked" in window.notice.text
    assert window.menus.menus["File", ""].title() == "File"
    assert window.menus.menus["Edit", ""].title() == "&Edit"
