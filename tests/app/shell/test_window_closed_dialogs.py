"""A dialog that was closed is gone: none stays behind with all its widgets."""

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QDialog

_COMMANDS = (
    *("tracks.track", "review.again", "tracks.runs", "detector.train", "file.export"),
    *("file.export_clip", "file.restore", "file.setup_again", "file.author", "file.open"),
    *("edit.keys", "help.keys", "help.doctor", "view.jobs"),
)


@pytest.fixture
def opened(window, qtbot, parted_session):
    window.files.open_path(parted_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    window.controller.editing.rename(window.controller.document.tracks.ids[0], "Anna")
    window.files.saving.save()
    qtbot.waitUntil(lambda: not window.work.busy and not window.files.saving.unsaved)
    window.bring_up_to_date()
    return window


@pytest.mark.parametrize("command", _COMMANDS)
def test_a_dialog_that_was_closed_is_gone(opened, qtbot, command) -> None:
    opened.run_command(command)
    qtbot.waitUntil(lambda: bool(opened.findChildren(QDialog)))
    for dialog in opened.findChildren(QDialog):
        dialog.reject()

    def gone() -> bool:
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        return not opened.findChildren(QDialog)

    qtbot.waitUntil(gone)
