"""The list of formats tracks are exported in."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from app.features.files.export import refuse_to_lose
from app.features.files.export_dialog import ExportDialog
from app.features.files.export_formats import (
    export_formats,
    propose_file_name,
    propose_report_folder,
)
from tracking.errors import OutputError

FORMATS = export_formats()


def test_by_keys_a_format_is_chosen(qtbot, dark, heard):
    parent = QWidget()
    qtbot.addWidget(parent)
    dialog = ExportDialog(FORMATS, ("Corrected tracks", "Run 0: flow"), FORMATS[0].name, parent)
    asked = heard(dialog.asked)
    dialog.show()
    qtbot.keyClick(dialog._list, Qt.Key.Key_Down)
    assert dialog._about.text() == FORMATS[1].about
    dialog._track_sources.setCurrentIndex(1)
    qtbot.keyClick(dialog._list, Qt.Key.Key_Return)
    assert asked == [(FORMATS[1].name, 0)]


def test_every_format_says_what_it_holds():
    assert all(each.about for each in FORMATS)
    assert {each.name for each in FORMATS if not each.ending} == {"x-anylabeling"}  # a folder
    assert all(each.ending.startswith(".") for each in FORMATS if each.ending)


def test_files_are_proposed_under_the_recordings_name():
    assert propose_file_name("Lobby, camera 3", FORMATS[0]) == "Lobby-camera-3-tracks.txt"
    assert propose_file_name("...", FORMATS[0]) == "tracks.txt"
    assert propose_report_folder("Lobby, camera 3") == "Lobby-camera-3-score"


def test_a_session_is_not_written_over(tiny_session, tmp_path):
    with pytest.raises(OutputError, match="would be lost"):
        refuse_to_lose(tiny_session)
    refuse_to_lose(tmp_path / "new.h5")
