"""Tracks of other tools in and out of the real window."""

from __future__ import annotations

import re
import threading
from contextlib import closing

import numpy as np
import pytest
from correcting_window import open_for_correcting
from patient import PATIENCE_S
from PySide6.QtCore import Qt, QUrl
from PySide6.QtWidgets import QMessageBox

from app.cli.export import check_is_own
from app.features.files.export import capture_export
from app.features.files.export_formats import export_formats
from app.features.files.import_dialog import ImportDialog
from app.shell import export_controller, import_controller
from tracking.errors import OutputError
from tracking.formats import format_of, read_mot
from tracking.session import Session

Key, CTRL = Qt.Key, Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session)


def at_rest(window, qtbot) -> None:
    qtbot.waitUntil(lambda: not window.work.busy)


def looked_over(window, qtbot, path) -> ImportDialog:
    """The dialog of a file."""
    window.files.importing.read(path)
    return shown_dialog(window, qtbot)


def shown_dialog(window, qtbot) -> ImportDialog:
    """The dialog once it says what would happen."""
    qtbot.waitUntil(lambda: window.findChild(ImportDialog) is not None)
    dialog = window.findChild(ImportDialog)
    qtbot.waitUntil(lambda: dialog._why_not.text() != "Looking...")
    return dialog


def test_every_format_is_exported_and_known_again(window, controller, qtbot, tmp_path):
    for each in export_formats():
        path = tmp_path / f"{each.name}{each.ending}"
        window.files.exporting.tracks_to(path, each.name)
        at_rest(window, qtbot)
        assert path.exists(), each.title
        assert format_of(path).read is not None


def test_the_command_line_replaces_what_the_window_exported(window, controller, qtbot, tmp_path):
    path = tmp_path / "tracks.txt"
    window.files.exporting.tracks_to(path)
    at_rest(window, qtbot)
    check_is_own([path], force=False)
    path.write_text("put right by hand")
    with pytest.raises(OutputError, match="was changed since"):
        check_is_own([path], force=False)


def test_what_a_format_does_not_hold_stays_said_until_it_is_read(
    window, controller, qtbot, tmp_path
):
    window.files.exporting.tracks_to(tmp_path / "tracks.txt", "pedpy-txt")
    at_rest(window, qtbot)
    assert "PedPy text has none: boxes, velocities" in window.notice.text
    assert window.notice.text.startswith("Exported: ")


def test_an_export_that_was_cancelled_writes_nothing(
    window, controller, qtbot, tmp_path, monkeypatch
):
    cancelled, whole = threading.Event(), capture_export(controller.document.session)
    put_together = lambda: cancelled.wait(PATIENCE_S) and whole  # noqa: E731
    monkeypatch.setattr(export_controller, "prepare_export", lambda *_: put_together)
    window.files.exporting.tracks_to(tmp_path / "tracks.txt")
    window.work.cancel()
    cancelled.set()
    at_rest(window, qtbot)
    assert list(tmp_path.glob("tracks*")) == []


def test_imported_tracks_are_one_edit_that_is_undone_at_once(window, controller, qtbot, tmp_path):
    document = controller.document
    before, ids = document.session.tracks.columns(), document.tracks.ids
    path = tmp_path / "theirs.txt"
    lines = [f"{frame},500,{frame},50,30,60,1,-1,-1,-1" for frame in range(1, 60)]
    path.write_text("\n".join(lines))
    dialog = looked_over(window, qtbot, path)
    assert "1 is added" in dialog._lines.text()
    dialog._thins.click()
    qtbot.waitUntil(lambda: "59 boxes to 2 keyframes" in dialog._lines.text())
    dialog.accept()
    assert set(document.tracks.ids) == {*ids, 500}
    assert window.statusBar().currentMessage() == "1 track imported"
    controller.playback.go(7)
    qtbot.waitUntil(lambda: controller.playback.number == 7)
    document.selection.choose(0)
    controller.editing.undo()
    controller.editing.redo()
    assert controller.playback.clock.frame == 7
    assert document.selection.all == ()
    controller.editing.undo()
    after = document.session.tracks.columns()
    for name, column in before.items():
        np.testing.assert_array_equal(after[name], column)


def test_a_text_without_a_unit_is_read_in_the_one_that_is_answered(
    window, controller, qtbot, tmp_path
):
    path = tmp_path / "theirs.txt"
    path.write_text("500 0 100 400 170\n500 1 110 400 170\n")
    window.files.importing.read(path)
    qtbot.waitUntil(lambda: window.findChild(QMessageBox, "unit") is not None)
    box = window.findChild(QMessageBox, "unit")
    assert path.name in box.text()
    next(each for each in box.buttons() if each.text() == "Centimetres").click()
    shown_dialog(window, qtbot).accept()
    assert controller.document.session.tracks.of_track(500)["x"].tolist() == [1.0, 1.1]


def test_of_a_dropped_file_good_rows_are_taken_only_on_a_word(window, controller, qtbot, tmp_path):
    path = tmp_path / "theirs.txt"
    path.write_text("1,500,5,50,30,60,1,-1,-1,-1\n2,-7,5,50,30,60,1,-1,-1,-1\n")
    window.files.open_dropped([QUrl.fromLocalFile(str(path))])
    dialog = shown_dialog(window, qtbot)
    assert not dialog._import.isEnabled()
    assert dialog._bad.item(0, 0).text() == "line 2"
    assert "id" in dialog._bad.item(0, 1).text()
    dialog._takes_good.click()
    assert dialog._import.isEnabled()
    dialog.accept()
    assert 500 in controller.document.tracks.ids
    assert "1 row was left out" in window.statusBar().currentMessage()


def test_into_a_recording_without_a_session_tracks_come_as_one(
    window, qtbot, tiny_recording, tmp_path
):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller is not None)
    dialog = looked_over(window, qtbot, tiny_recording / "truth.txt")
    dialog.accept()
    at_rest(window, qtbot)
    document = window.controller.document
    truth = read_mot(tiny_recording / "truth.txt")
    assert set(document.tracks.ids) == set(truth["track"].tolist())
    assert document.session.path is not None


def test_an_import_does_not_take_the_place_of_a_session_that_came_meanwhile(
    window, qtbot, tiny_recording, tiny_session
):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy)
    controller = window.controller
    window.files.open_dropped([QUrl.fromLocalFile(str(tiny_recording / "truth.txt"))])
    dialog = shown_dialog(window, qtbot)
    with closing(Session.open(tiny_session)) as tracked:
        window.files.keeping.keep(tracked.runs[0])  # as a tracker at work ends
        qtbot.waitUntil(lambda: controller.document.session is not None)
    at_rest(window, qtbot)
    kept, told = controller.document.session, []
    window.files.importing.failed.connect(told.append)
    dialog.accept()
    at_rest(window, qtbot)
    assert controller.document.session is kept
    assert "another session was opened meanwhile" in str(told[0])


def test_a_file_is_not_imported_by_dropping_it_while_other_work_is_going_on(
    window, controller, qtbot, tiny_recording
):
    over, told = threading.Event(), []
    window.files.importing.said.connect(told.append)
    window.work.run("waiting", lambda _: over.wait(PATIENCE_S), lambda _: None)
    window.files.open_dropped([QUrl.fromLocalFile(str(tiny_recording / "truth.txt"))])
    qtbot.waitUntil(lambda: bool(told))
    over.set()
    at_rest(window, qtbot)
    assert told == ["wait until the work in progress is done"]
    assert window.findChild(ImportDialog) is None


def test_each_ending_is_offered_once_though_formats_share_it(window, controller, monkeypatch):
    offered = []
    monkeypatch.setattr(
        import_controller, "choose_file", lambda _w, _title, filters, *_: offered.append(filters)
    )
    window.files.importing.ask()
    endings = re.findall(r"\*\.\w+", offered[0])
    assert len(endings) == len(set(endings)) > 5
