"""From two files to a recording with metres, in the real window."""

import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import Qt, QUrl
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialogButtonBox, QMessageBox

from tracking.recording import open_recording, read_manifest

OK = QDialogButtonBox.StandardButton.Ok


@pytest.fixture
def card(tiny_recording, tmp_path):
    """The cameras' files as a camera names them, the right one first, and the calibration."""
    folder = tmp_path / "card"
    folder.mkdir()
    for side, name in (("left", "GX010035"), ("right", "GX010034")):
        source = next(tiny_recording.glob(f"{side}*"))
        shutil.copyfile(source, folder / (name + source.suffix))
    shutil.copyfile(tiny_recording / "calibration.yaml", folder / "calibration.yaml")
    return folder


def _form(window, qtbot):
    qtbot.waitUntil(lambda: window.files.setup.dialog is not None, timeout=20_000)
    return window.files.setup.dialog


def _press(button):
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def test_two_files_that_are_dropped_reach_a_recording_with_metres(
    window, qtbot, card, tiny_recording
):
    with open_recording(tiny_recording) as recording:
        truth = recording.ground
    videos = sorted(card.glob("GX*"))
    window.welcome.dropped.emit([QUrl.fromLocalFile(str(path)) for path in videos])
    form = _form(window, qtbot)
    assert form.left.text().startswith("GX010035")
    assert "is the left camera" in form.cameras.text()
    assert form.calibration.text() == "calibration.yaml"
    bare = form.picture._whole.toImage()
    _press(form.measure)
    qtbot.waitUntil(lambda: form.floor.text().startswith("Measured"), timeout=20_000)
    assert form.height_m.value() == pytest.approx(truth.height_m, rel=0.03)
    assert form.picture._whole.toImage() != bare
    form.name.setText("Square, west")
    form.name.setModified(True)
    _press(form.buttons.button(OK))
    qtbot.waitUntil(lambda: window.controller is not None, timeout=20_000)
    recording = window.controller.document.recording
    assert recording.name == "Square, west"
    assert recording.is_stereo
    assert recording.view is not None
    assert Path(read_manifest(card).left).stem == "GX010035"


def test_a_floor_is_typed_and_cameras_are_swapped(window, qtbot, card):
    window.files.setup.begin(sorted(card.glob("GX*")))
    form = _form(window, qtbot)
    form.height_m.setValue(2.5)
    form.tilt_deg.setValue(31.0)
    assert (form.plan.ground.height_m, form.plan.ground.tilt_deg) == (2.5, 31.0)
    left = form.left.text()
    _press(form.swap)
    qtbot.waitUntil(lambda: form.right.text() == left, timeout=20_000)
    form.reject()
    assert not (card / "recording.toml").exists()


def test_a_calibration_that_does_not_fit_is_told_beside_and_nothing_is_written(
    window, qtbot, card, tmp_path
):
    window.files.setup.begin(sorted(card.glob("GX*")))
    form = _form(window, qtbot)
    other = tmp_path / "card" / "other.yaml"
    other.write_text("nothing of a camera")
    form.take_calibration(other)
    assert "other.yaml" in form.problem.text()
    assert not form.buttons.button(OK).isEnabled()
    form.reject()


def test_an_open_recording_is_set_up_again_and_asked_for_before_it_is_replaced(
    window, qtbot, tiny_recording, tmp_path
):
    folder = tmp_path / "again"
    shutil.copytree(tiny_recording, folder)
    window.files.open_path(folder)
    qtbot.waitUntil(lambda: window.controller is not None)
    window.menus.actions["file.setup_again"].trigger()
    form = _form(window, qtbot)
    old = (folder / "recording.toml").read_text()
    form.tilt_deg.setValue(form.tilt_deg.value() - 1.0)
    _press(form.buttons.button(OK))
    qtbot.waitUntil(lambda: bool(window.findChildren(QMessageBox)))
    boxes = window.findChildren(QMessageBox)
    _press(boxes[0].button(QMessageBox.StandardButton.Cancel))
    assert (folder / "recording.toml").read_text() == old
    assert form.isVisible()
    qtbot.waitUntil(lambda: not window.findChildren(QMessageBox))
    _press(form.buttons.button(OK))
    qtbot.waitUntil(lambda: bool(window.findChildren(QMessageBox)))
    boxes = window.findChildren(QMessageBox)
    _press(next(button for button in boxes[0].buttons() if button.text() == "Replace"))
    assert (folder / "recording.toml").read_text() != old


def test_two_files_of_different_scenes_are_told(window, qtbot, card, tmp_path):
    text = tmp_path / "a.mp4"
    text.write_text("no video")
    window.files.setup.begin([next(iter(card.glob("GX*"))), text])
    qtbot.waitUntil(lambda: window.notice.isVisible() or window.notice.text != "", timeout=20_000)
    assert window.files.setup.dialog is None
