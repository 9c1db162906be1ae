"""Track with detections: what the dialog offers, asks for and tells."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from app.core.widgets.user_settings import UserSettings
from app.features.runs.track_dialog import TrackDialog
from tracking.detections import DetectionSettings
from tracking.recording import open_recording

ROWS = "".join(f"{n},-1,{20 + n},40,24,60,{0.9 if n % 5 else 0.1}\n" for n in range(1, 81))


@pytest.fixture
def dialog(qtbot: QtBot, tiny_recording: Path, remembered: UserSettings, tmp_path: Path):
    folder = Path(shutil.copytree(tiny_recording, tmp_path / "tiny"))
    (folder / "det.txt").write_text(ROWS)
    with open_recording(folder) as recording:
        asked = TrackDialog(recording, "three-part", remembered)
        qtbot.addWidget(asked)
        asked.show()
        yield asked


def test_a_file_beside_the_recording_is_offered_and_none_is_used_unasked(dialog) -> None:
    offered = dialog._detections._left.files
    assert [offered.itemText(row) for row in range(offered.count())] == [
        "none (found here: det.txt)",
        "det.txt",
    ]
    assert dialog.answer()[1].detections.file == ""
    assert not dialog._detections._use.isVisible()


def test_a_chosen_file_is_read_and_its_format_count_and_threshold_are_told(dialog, qtbot) -> None:
    line = dialog._detections
    line._left.put("det.txt")
    qtbot.waitUntil(lambda: "boxes" in line._told.text())
    assert "det.txt (MOTChallenge text): 64 of 80 boxes are used" in line._told.text()
    assert "from 0.9 on" in line._told.text()
    assert dialog.answer()[1].detections.file == "det.txt"


def test_the_right_camera_and_the_way_they_are_used_are_asked_for_then(dialog) -> None:
    line = dialog._detections
    dialog.put_settings("stereo-joint", {}, 0)
    line._right.put("det.txt")
    assert dialog.answer()[1].detections.file_right == ""  # nothing without the left one
    line._left.put("det.txt")
    line._use.setCurrentIndex(1)
    assert line._right.isVisible()
    chosen = dialog.answer()[1].detections
    assert (chosen.file_right, chosen.use) == ("det.txt", "only")
    dialog._choice.setCurrentText("three-part")  # looks at the left camera alone
    assert line._left.path == "det.txt"
    assert not line._right.isVisible()
    assert dialog.answer()[1].detections.file_right == ""


def test_a_file_that_cannot_be_read_is_told(dialog, qtbot, tmp_path: Path) -> None:
    line, path = dialog._detections, tmp_path / "prose.txt"
    path.write_text("People walk.\n")
    line._left.put(str(path))
    qtbot.waitUntil(lambda: "no file of detections" in line._told.text())
    assert line._told.textFormat() is Qt.TextFormat.PlainText  # a file's name is no markup
    assert line._told.property("role") == "warning"
    start = next(one for one in dialog.findChildren(QPushButton) if one.text() == "Track")
    assert not start.isEnabled()
    line._left.put("det.txt")
    qtbot.waitUntil(start.isEnabled)
    assert line._told.property("role") == "muted"
    line._left.put(str(path))
    assert not start.isEnabled()
    line._left.put("")
    assert start.isEnabled()


def test_what_was_answered_once_is_filled_in_again(dialog, qtbot) -> None:
    answer = ("three-part", dialog.answer()[1], 4, (3, 9))
    dialog._detections._left.put("det.txt")
    dialog._seed.setValue(7)
    chosen = dialog.answer()
    dialog.put_answer(*answer)
    assert dialog.answer() == answer
    dialog.put_answer(*chosen)
    assert dialog.answer() == chosen


def test_defaults_choose_no_detections_and_their_usual_use(dialog) -> None:
    line = dialog._detections
    line._left.put("det.txt")
    line._right.put("det.txt")
    line._use.setCurrentIndex(1)
    reset = next(one for one in dialog.findChildren(QPushButton) if one.text() == "Defaults")
    reset.click()
    assert dialog.answer()[1].detections == DetectionSettings()
    assert not line._use.isVisible()
    line._left.put("det.txt")
    assert line.values() == {"detections.file": "det.txt"}


def test_the_name_of_a_file_elsewhere_shows_before_its_folder(dialog, tmp_path: Path) -> None:
    path = tmp_path / "elsewhere.txt"
    files = dialog._detections._left
    files.put(str(path))
    assert files.path == str(path)
    assert files.files.currentText() == f"elsewhere.txt in {tmp_path}"
    assert files.files.toolTip() == str(path)
    files.put("det.txt")
    assert files.files.currentText() == "det.txt"


def test_the_settings_of_a_run_fill_them_in(dialog) -> None:
    values = {"detections.file": "boxes.json", "detections.use": "only"}
    dialog.put_settings("three-part", values, 3)
    assert dialog._detections.values() == values


@pytest.mark.parametrize("name", ["detections.file", "detections.file_right"])
def test_a_file_outside_that_a_session_names_is_not_read_but_told(
    dialog, qtbot, tmp_path, name
) -> None:
    outside = tmp_path / "elsewhere.txt"
    outside.write_text(ROWS)
    values = {"detections.file": "det.txt", name: str(outside)}
    line = dialog._detections
    dialog.put_settings("three-part", values, 0)
    assert line.values() == {}
    assert not line._look.busy
    assert line._told.isVisibleTo(dialog)
    assert "elsewhere.txt, which is not in the folder of the recording" in line._told.text()
    line._left.put(str(outside))  # the user names it
    qtbot.waitUntil(lambda: "boxes are used" in line._told.text())


def test_a_network_is_chosen_by_its_toml_and_its_licence_told(
    dialog, qtbot, tmp_path: Path
) -> None:
    path, line = tmp_path / "people.toml", dialog._detections
    text = 'licence = "MIT"\ndecoder = "yolo"\nclasses = "coco"\nsize = [64, 64]\n'
    path.write_text(text)
    line._left.put(str(path))
    qtbot.waitUntil(lambda: "cannot read" in line._told.text())  # there is no ONNX
    path.with_suffix(".onnx").write_bytes(b"not looked into yet")
    line._left.put("")
    line._left.put(str(path))
    qtbot.waitUntil(lambda: "Network people (MIT)" in line._told.text())
    assert dialog.answer()[1].detections.model == str(path)
    assert dialog.answer()[1].detections.file == ""
    assert line._use.isVisible()
    assert not line._right.isVisible()


def test_a_network_of_a_run_is_filled_in_again_unless_it_lies_elsewhere(dialog) -> None:
    line = dialog._detections
    line.put({"detections.model": "network", "detections.use": "only"})
    assert line.values() == {"detections.model": "network", "detections.use": "only"}
    line.put({"detections.model": "/elsewhere/people.toml"})
    assert line.values() == {}
    assert "/elsewhere/people.toml" in line._told.text()


def test_an_appearance_network_is_one_more_cue_and_no_detections(
    dialog, qtbot, tmp_path: Path
) -> None:
    path, line = tmp_path / "who.toml", dialog._detections
    path.write_text('kind = "appearance"\nlicence = "MIT"\nsize = [64, 64]\n')
    path.with_suffix(".onnx").write_bytes(b"not looked into yet")
    line._left.put(str(path))
    qtbot.waitUntil(lambda: "Appearance network who (MIT)" in line._told.text())
    chosen = dialog.answer()[1].detections
    assert (chosen.appearance, chosen.model) == (str(path), "")
    assert not line._use.isVisible()
    line._left.put("det.txt")
    qtbot.waitUntil(lambda: "boxes are used" in line._told.text())
    assert dialog.answer()[1].detections == DetectionSettings(file="det.txt")
    assert line._use.isVisible()
