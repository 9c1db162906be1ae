"""Backups of a session listed, looked at and restored in the real window."""

import pytest
from PySide6.QtWidgets import QPlainTextEdit, QTableWidget

from app.features.files.backup_dialog import BackupDialog
from app.features.history.panel import HistoryPanel
from tracking.editing import plan_delete
from tracking.translation import use_catalogue, use_language


@pytest.fixture
def saved_twice(window, controller, qtbot):
    """Saved with one edit, then with another one; a third waits in the journal."""
    a, b = controller.document.tracks.ids[:2]
    for edit in (lambda: controller.editing.rename(a, "one"), lambda: _delete(controller, b)):
        edit()
        window.files.saving.save()
        qtbot.waitUntil(lambda: not window.work.busy and not window.files.saving.unsaved)
    controller.editing.rename(a, "not saved")
    return a, b


def _delete(controller, track: int) -> None:
    controller.document.apply(plan_delete(controller.document.session.tracks, track))
    controller.draw()


@pytest.fixture
def dialog(window, saved_twice, qtbot):
    window.run_command("file.restore")
    qtbot.waitUntil(lambda: window.findChild(BackupDialog, "backups") is not None)
    return window.findChild(BackupDialog, "backups")


def _differences(dialog) -> str:
    return dialog.findChild(QPlainTextEdit).toPlainText()


def test_edits_that_backups_lack_are_told_in_the_language_of_the_window(window, saved_twice, qtbot):
    use_language("ja")
    try:
        window.run_command("file.restore")
        qtbot.waitUntil(lambda: window.findChild(BackupDialog, "backups") is not None)
        shown = window.findChild(BackupDialog, "backups")
        qtbot.waitUntil(lambda: "編集" in _differences(shown))
        assert "Delete track" not in _differences(shown)
        shown.reject()
    finally:
        use_catalogue(None)


def test_backups_are_listed_with_what_would_be_other_than_now(dialog, saved_twice, qtbot):
    table = dialog.findChild(QTableWidget)
    edits = [table.item(row, 1).text() for row in range(table.rowCount())]
    assert edits == ["1 edit", "0 edits"]
    qtbot.waitUntil(lambda: "Without" in _differences(dialog))
    told = _differences(dialog)
    a, b = saved_twice
    assert "Without 2 edits:" in told
    assert f"Delete track {b}" in told
    assert f'Name {a} "not saved"' in told
    assert f"With the tracks {b}" in told
    dialog.reject()


def test_a_backup_is_restored_and_what_was_there_can_be_restored(
    window, controller, dialog, saved_twice, qtbot
):
    a, b = saved_twice
    qtbot.waitUntil(lambda: dialog._restore.isEnabled())
    dialog._restore.click()
    qtbot.waitUntil(lambda: not window.work.busy)
    session = controller.document.session
    assert b in session.tracks
    assert controller.document.label(a).name == "one"
    assert len(window.workspace.of(HistoryPanel)._items) == 1
    assert window.workspace.isEnabled()
    controller.editing.rename(a, "again")  # it can be worked on
    qtbot.waitUntil(lambda: not window.work.busy)
    window.files.backups.restore(1)
    qtbot.waitUntil(lambda: not window.work.busy)
    names = [one.name for one in controller.document.session.labels.tracks.values()]
    assert names == ["not saved"]
    assert b not in controller.document.session.tracks


def test_a_session_saved_once_has_no_backup(window, controller, qtbot):
    said: list[str] = []
    window.files.said.connect(said.append)
    window.run_command("file.restore")
    qtbot.waitUntil(lambda: bool(said))
    assert "There is no backup yet" in said[0]
