"""Tracks of other tools in and out of the real window."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from correcting_desk import opened_desk
from PySide6.QtCore import Qt, QUrl

from app.presenters.files.export_formats import export_formats
from app.presenters.files.exporting import exported
from app.views.files import exporting
from app.views.files.export_dialog import ExportDialog
from app.views.files.import_dialog import ImportDialog
from tracking.formats import Filmed, format_of, read_mot

Key, CTRL = Qt.Key, Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def desk(window, qtbot, tiny_session):
    return opened_desk(window, qtbot, tiny_session)


def at_rest(window, qtbot) -> None:
    qtbot.waitUntil(lambda: not window.work.busy, timeout=20_000)


def looked_over(window, qtbot, path) -> ImportDialog:
    """The dialog once it says what would happen."""
    window.files.importing.read(path)
    qtbot.waitUntil(lambda: window.findChild(ImportDialog) is not None, timeout=20_000)
    dialog = window.findChild(ImportDialog)
    qtbot.waitUntil(lambda: dialog._why_not.text() != "Looking...", timeout=20_000)
    return dialog


def test_every_format_is_exported_and_known_again(window, desk, qtbot, tmp_path):
    rows = len(desk.document.session.tracks.columns()["frame"])
    for each in export_formats():
        path = tmp_path / f"{each.name}{each.ending}"
        window.files.exporting.tracks_to(path, each.name)
        at_rest(window, qtbot)
        assert path.is_file(), each.title
        filmed = Filmed(120, 8.0, desk.document.recording.size, desk.document.recording.view)
        read = format_of(path).read(path, filmed)
        assert len(read.columns["frame"]) == rows, each.title
        assert read.bad_count == 0


def test_an_export_onto_a_session_is_refused(window, desk, qtbot, tiny_session):
    before = tiny_session.read_bytes()
    window.files.exporting.tracks_to(tiny_session, "pedpy-h5")
    at_rest(window, qtbot)
    assert "would be lost" in window.notice._text.text()
    assert tiny_session.read_bytes() == before


def test_an_export_that_was_cancelled_writes_nothing(window, desk, qtbot, tmp_path, monkeypatch):
    cancelled, whole = threading.Event(), exported(desk.document.session)
    put_together = lambda: cancelled.wait(5) and whole  # noqa: E731
    monkeypatch.setattr(exporting, "exporting", lambda *_: put_together)
    window.files.exporting.tracks_to(tmp_path / "tracks.txt")
    window.work.cancel()
    cancelled.set()
    at_rest(window, qtbot)
    assert list(tmp_path.glob("tracks*")) == []


def test_by_key_a_format_is_chosen(window, desk, press, qtbot):
    press(Key.Key_E, CTRL)
    dialog = window.findChild(ExportDialog)
    asked = []
    dialog.asked.disconnect()
    dialog.asked.connect(lambda *chosen: asked.append(chosen))
    names = [each.name for each in export_formats()]
    qtbot.keyClick(dialog._list, Key.Key_Down)
    assert dialog._about.text()
    qtbot.keyClick(dialog._list, Key.Key_Return)
    assert asked == [(names[1], -1)]


def test_imported_tracks_are_one_edit_that_is_undone_at_once(window, desk, qtbot, tmp_path):
    document = desk.document
    before, ids = document.session.tracks.columns(), document.tracks.ids
    path = tmp_path / "theirs.txt"
    lines = [f"{frame},500,{frame},50,30,60,1,-1,-1,-1" for frame in range(1, 60)]
    path.write_text("\n".join(lines))
    dialog = looked_over(window, qtbot, path)
    assert "1 is added" in dialog._lines.text()
    dialog.accept()
    assert set(document.tracks.ids) == {*ids, 500}
    assert window.statusBar().currentMessage() == "1 track imported"
    desk.editing.undo()
    after = document.session.tracks.columns()
    for name, column in before.items():
        np.testing.assert_array_equal(after[name], column)


def test_a_file_of_tracks_that_is_dropped_is_imported(window, desk, qtbot, tmp_path):
    path = tmp_path / "theirs.txt"
    path.write_text("1,500,5,50,30,60,1,-1,-1,-1\n")
    window.files.open_dropped([QUrl.fromLocalFile(str(path))])
    qtbot.waitUntil(lambda: window.findChild(ImportDialog) is not None, timeout=20_000)
    assert window.desk is desk
    window.findChild(ImportDialog).reject()


def test_bad_rows_are_listed_and_the_good_ones_taken_only_on_a_word(window, desk, qtbot, tmp_path):
    path = tmp_path / "theirs.txt"
    path.write_text("1,500,5,50,30,60,1,-1,-1,-1\n2,-7,5,50,30,60,1,-1,-1,-1\n")
    dialog = looked_over(window, qtbot, path)
    assert not dialog._import.isEnabled()
    assert dialog._bad.item(0, 0).text() == "line 2"
    assert "id" in dialog._bad.item(0, 1).text()
    dialog._takes_good.click()
    assert dialog._import.isEnabled()
    dialog.accept()
    assert 500 in desk.document.tracks.ids
    assert "1 row was left out" in window.statusBar().currentMessage()


def test_another_tolerance_is_worked_out_at_once(window, desk, qtbot, tmp_path):
    path = tmp_path / "theirs.txt"
    lines = [f"{frame},500,{frame},50,30,60,1,-1,-1,-1" for frame in range(1, 60)]
    path.write_text("\n".join(lines))
    dialog = looked_over(window, qtbot, path)
    dialog._thins.click()
    qtbot.waitUntil(lambda: "59 boxes to 2 keyframes" in dialog._lines.text(), timeout=20_000)
    dialog.reject()
    assert 500 not in desk.document.tracks.ids


def test_into_a_recording_without_a_session_tracks_come_as_one(
    window, qtbot, tiny_recording, tmp_path
):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.desk is not None)
    dialog = looked_over(window, qtbot, tiny_recording / "truth.txt")
    dialog.accept()
    at_rest(window, qtbot)
    document = window.desk.document
    truth = read_mot(tiny_recording / "truth.txt")
    assert set(document.tracks.ids) == set(truth["track"].tolist())
    assert document.session.path is not None
