"""A result that cannot be put on disk waits in memory until it can, or is given up."""

import errno

import pytest
from PySide6.QtWidgets import QMessageBox

from app.core.document import document_loader
from tracking.errors import OutputError


class FullDisk:
    """Stands in for keeping a run; full until there is room."""

    def __init__(self, keep_run):
        self._keep_run = keep_run
        self.full = True
        self.asked = 0

    def __call__(self, recording, run, path=None, seen=None):
        self.asked += 1
        if self.full:
            raise OutputError("session.h5 cannot be written: no space left on the device")
        return self._keep_run(recording, run, path, seen)


@pytest.fixture
def disk(monkeypatch):
    disk = FullDisk(document_loader.keep_run)
    monkeypatch.setattr(document_loader, "keep_run", disk)
    return disk


@pytest.fixture
def held(window, qtbot, tiny_recording, tiny_run, disk):
    """The window with a run that could not be kept."""
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    window.controller.tracking.tracked.emit(tiny_run)
    qtbot.waitUntil(lambda: bool(window.notice.text) and not window.work.busy)
    return window


def test_why_it_is_not_kept_is_told_and_it_stays_in_memory(held):
    assert "no space left" in held.notice.text
    assert "Nothing is lost" in held.notice.text
    assert held.notice.action_text == "Try again"
    assert held.files.keeping.holds
    assert held.files.saving.unsaved


def test_trying_again_keeps_it_once_there_is_room(held, disk, qtbot):
    disk.full = False
    held.notice._action.click()
    qtbot.waitUntil(lambda: held.files.session is not None)
    assert not held.files.keeping.holds
    assert held.files.session.path.exists()


def test_save_tries_again_too(held, disk, qtbot):
    qtbot.waitUntil(lambda: held.menus.actions["file.save"].isEnabled())
    disk.full = False
    held.run_command("file.save")
    qtbot.waitUntil(lambda: held.files.session is not None)


def test_it_can_be_saved_at_another_place(held, disk, qtbot, tmp_path):
    disk.full = False
    held.files.saving.save_to(tmp_path / "elsewhere.h5")
    qtbot.waitUntil(lambda: held.files.session is not None)
    assert held.files.session.path == tmp_path / "elsewhere.h5"


def test_still_full_is_told_again(held, disk, qtbot):
    held.notice._action.click()
    qtbot.waitUntil(lambda: disk.asked == 2 and not held.work.busy)
    qtbot.waitUntil(lambda: bool(held.notice.text))
    assert held.files.keeping.holds


def test_no_other_tracker_is_begun_over_it(held):
    held.notice.hide()
    held.run_command("tracks.track")
    assert "in memory only" in held.notice.text


def test_leaving_asks_and_discarding_drops_it(held, qtbot):
    held.files.close_recording()
    box = held.findChild(QMessageBox, "unsaved")
    box.button(QMessageBox.StandardButton.Discard).click()
    qtbot.waitUntil(lambda: held.controller is None)
    assert not held.files.keeping.holds


def test_a_folder_that_cannot_be_made_is_no_bug(
    window, qtbot, tiny_recording, tiny_run, monkeypatch
):
    def refuse(*_):
        raise OSError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(document_loader, "keep_run", refuse)
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    window.controller.tracking.tracked.emit(tiny_run)
    qtbot.waitUntil(lambda: "Permission denied" in window.notice.text)
    assert window.files.keeping.holds


def test_who_ends_the_program_is_told_of_a_loss_only_where_keeping_failed(
    window, qtbot, tiny_recording, tiny_run, disk
):
    disk.full = False
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy)
    window.controller.tracking.tracked.emit(tiny_run)
    assert window.files.keeping.holds
    assert window.files.describe_unsaved() == []
    qtbot.waitUntil(lambda: window.files.session is not None)


def test_who_ends_the_program_is_told_of_a_result_that_could_not_be_kept(held):
    assert "is lost" in "".join(held.files.describe_unsaved())
