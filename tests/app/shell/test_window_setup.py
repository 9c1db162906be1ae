"""From two files to a recording with metres, in the real window, with mouse and keys."""

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QLabel, QMessageBox, QWidget
from pytestqt.qtbot import QtBot
from setup_fixtures import Begin

from app.features.setup.presenter import mark_of
from app.features.setup.scene import Mark, Step
from app.shell.main_window import MainWindow
from tests.benchmarks.setup.user import SetupUser, set_up_roughly, set_up_with_file
from tests.calibration.rendered_boards import CAMERA, pair_of, write_pairs
from tracking.calibration.boards import Board
from tracking.geometry import Camera, read_calibration, write_calibration
from tracking.recording import open_recording, read_manifest
from tracking.setup.calibration_facts import field_of_view_deg

CTRL = Qt.KeyboardModifier.ControlModifier


def test_two_bare_videos_reach_live_tracking_with_metres_in_fifteen_actions(
    user: SetupUser, card: Path, tiny_recording: Path, qtbot: QtBot
) -> None:
    with open_recording(tiny_recording) as recording:
        truth, calibration = recording.ground, recording.calibration
    assert truth is not None
    assert calibration is not None
    fov_deg = field_of_view_deg(calibration.left)
    set_up_roughly(user, sorted(card.glob("GX*")), fov_deg, 1000 * calibration.baseline_m)
    controller = user.window.controller
    assert controller is not None
    qtbot.waitUntil(lambda: controller.playback.number >= 1, timeout=30_000)
    assert user.actions <= 15
    recording = controller.document.recording
    assert recording.is_stereo
    assert recording.view is not None
    assert recording.calibration is not None
    assert recording.calibration.rough
    ground = recording.ground
    assert ground is not None
    assert ground.height_m == pytest.approx(truth.height_m, rel=0.1)
    assert ground.tilt_deg == pytest.approx(truth.tilt_deg, abs=3.0)
    manifest = read_manifest(card)
    assert Path(manifest.left).stem == "GX010035"
    assert manifest.calibration == ("calibration.yaml",)
    assert controller.live.running or controller.document.session is not None
    window = user.window
    window.run_command("play.toggle")
    controller.tracking.stop()
    qtbot.waitUntil(lambda: not controller.live.running and not window.work.busy)


def test_a_calibration_beside_the_videos_is_taken_and_the_floor_is_measured(
    user: SetupUser, with_calibration: Path, tiny_recording: Path, qtbot: QtBot
) -> None:
    truth = read_manifest(tiny_recording).ground
    assert truth is not None
    set_up_with_file(user, [with_calibration])
    controller = user.window.controller
    assert controller is not None
    ground = controller.document.recording.ground
    assert ground is not None
    assert ground.height_m == pytest.approx(truth.height_m, rel=0.03)
    qtbot.waitUntil(lambda: controller.playback.number >= 1, timeout=30_000)
    assert controller.live.running or controller.document.session is not None
    window = user.window
    window.run_command("play.toggle")
    controller.tracking.stop()
    qtbot.waitUntil(lambda: not controller.live.running and not window.work.busy)


def test_every_change_is_undone_by_ctrl_z_in_a_field_too(begin: Begin, card: Path) -> None:
    dialog = begin(card).dialog
    left = dialog.cameras.left.text()
    QTest.mouseClick(dialog.cameras.exchange, Qt.MouseButton.LeftButton)
    assert dialog.cameras.right.text() == left
    dialog.cameras.lag.setFocus()
    dialog.cameras.lag.selectAll()
    QTest.keyClicks(dialog.cameras.lag, "2")
    QTest.keyClick(dialog.cameras.lag, Qt.Key.Key_Return)
    assert dialog.plan is not None
    assert dialog.plan.lag == 2
    QTest.keyClick(dialog.cameras.lag, Qt.Key.Key_Z, CTRL)
    assert dialog.plan.lag is None
    QTest.keyClick(dialog.cameras.lag, Qt.Key.Key_Z, CTRL)
    assert dialog.cameras.left.text() == left
    QTest.mouseClick(dialog.redo_button, Qt.MouseButton.LeftButton)
    assert dialog.cameras.right.text() == left


def test_steps_are_left_and_entered_at_will_and_say_how_they_stand(
    begin: Begin, with_calibration: Path
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    assert [dialog.steps.item(row).text().split("\n")[1] for row in range(3)] == [
        "done",
        "done",
        "no metres yet",
    ]
    user.key(dialog, Qt.Key.Key_PageDown, CTRL)
    assert dialog.page is dialog.calibration
    user.key(dialog.steps, Qt.Key.Key_Down)
    assert dialog.page is dialog.floor
    user.type(dialog.floor.height_m, "2.5")
    user.type(dialog.floor.tilt_deg, "31")
    user.wait_for_rest()
    assert dialog.steps.item(2).text().endswith("done")
    user.hover_image(100, 200)
    first = dialog.picture.picture.figure
    user.hover_image(220, 200)
    assert first is not None
    assert dialog.picture.picture.figure != first
    user.key(dialog, Qt.Key.Key_PageUp, CTRL)
    assert dialog.page is dialog.calibration


def test_a_height_in_centimetres_stays_as_typed_and_is_told(
    begin: Begin, with_calibration: Path
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.FLOOR)
    user.type(dialog.floor.height_m, "278")
    assert dialog.plan is not None
    assert dialog.plan.ground is not None
    assert dialog.plan.ground.height_m == 278.0
    assert "give 2.78 m" in dialog.floor.doubt.text()
    user.type(dialog.floor.height_m, "2.78")
    assert dialog.floor.doubt.text() == ""


def test_an_interrupted_set_up_is_offered_again(
    begin: Begin, with_calibration: Path, window: MainWindow, qtbot: QtBot
) -> None:
    user = begin(with_calibration)
    user.dialog.go_to(Step.FLOOR)
    user.type(user.dialog.floor.height_m, "2.5")
    user.wait_for_rest()
    user.press(user.dialog.close_button)
    assert not (with_calibration / "recording.toml").exists()
    window.menus.actions["file.setup"].trigger()
    dialog = user.dialog
    assert "did not write it" in dialog.cameras.resume_told.text()
    user.press(dialog.cameras.resume_button)
    user.wait_for_rest()
    assert dialog.plan is not None
    assert dialog.plan.ground is not None
    assert dialog.plan.ground.height_m == 2.5
    user.press(dialog.cameras.resume_button)  # begin anew
    qtbot.waitUntil(lambda: dialog.plan is not None and dialog.plan.ground is None)


def test_a_region_is_drawn_with_the_mouse_and_with_keys(begin: Begin, card: Path) -> None:
    user = begin(card)
    dialog = user.dialog
    dialog.go_to(Step.REGION)
    user.press(dialog.region.look_here)
    for corner in ((20, 40), (300, 40), (300, 230)):
        user.click_image(*corner)
    user.key(dialog.picture, Qt.Key.Key_Return)
    assert dialog.plan is not None
    (outline,) = dialog.plan.region.look
    assert np.allclose(outline, ((20, 40), (300, 40), (300, 230)), atol=1.0)
    user.drag_image(outline[0], (30, 60))
    assert np.allclose(dialog.plan.region.look[0][0], (30, 60), atol=1.5)
    user.press(dialog.region.leave_out)
    user.key(dialog.picture, Qt.Key.Key_Return)  # a rectangle in the middle
    before = dialog.plan.region.mask[0][0]
    user.key(dialog.picture, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert dialog.plan.region.mask[0][0][0] == before[0] + 10
    user.key(dialog.picture, Qt.Key.Key_Delete)
    assert len(dialog.plan.region.mask[0]) == 3
    user.key(dialog, Qt.Key.Key_Z, CTRL)
    assert len(dialog.plan.region.mask[0]) == 4
    user.press(dialog.region.remove)
    assert dialog.plan.region.mask == ()
    user.wait_for_rest()
    assert "People are looked for in" in dialog.region.told.text()


def test_an_outline_that_nobody_ended_is_kept_when_another_step_is_shown(
    begin: Begin, card: Path
) -> None:
    user = begin(card)
    dialog = user.dialog
    dialog.go_to(Step.REGION)
    user.press(dialog.region.look_here)
    for corner in ((20, 40), (300, 40), (300, 230)):
        user.click_image(*corner)
    dialog.go_to(Step.WRITE)
    assert dialog.plan is not None
    assert len(dialog.plan.region.look[0]) == 3


def test_points_are_clicked_and_their_places_typed(
    begin: Begin, with_calibration: Path, tiny_recording: Path
) -> None:
    with open_recording(tiny_recording) as recording:
        view, truth = recording.view, recording.ground
    assert view is not None
    assert truth is not None
    places = np.array([(-1.5, 3.5), (1.5, 3.5), (1.5, 6.0), (-1.5, 6.5)])
    pixels = view.pixel_from_world(np.column_stack((places, np.zeros(4))))
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.FLOOR)
    user.choose(dialog.floor.method, "points")
    for pixel in pixels:
        user.click_image(*pixel)
    table = dialog.floor.points.table
    for row, place in enumerate(places):
        for column, value in enumerate(place, 1):
            item = table.item(row, column)
            assert item is not None
            item.setText(f"{value:g}")
    assert dialog.plan is not None
    assert dialog.plan.ground is not None
    assert dialog.plan.ground.height_m == pytest.approx(truth.height_m, rel=0.05)
    item = table.item(0, 1)
    assert item is not None
    item.setText("three")
    assert "three is no number" in dialog.floor.problem.text()


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda image: image[:, ::-1], "mirrored"),
        (lambda image: image[::-1, ::-1], "upside down"),
    ],
)
def test_a_mirrored_or_turned_camera_is_told_beside_the_files(
    spoil: Callable[[np.ndarray], np.ndarray],
    words: str,
    user: SetupUser,
    tiny_recording: Path,
    tmp_path: Path,
) -> None:
    folders = tmp_path / "left", tmp_path / "right"
    for folder in folders:
        folder.mkdir()
    with open_recording(tiny_recording) as recording:
        for number in range(0, 80, 10):
            frame = recording.read(number)
            assert frame.right is not None
            cv2.imwrite(str(folders[0] / f"{number:03}.png"), frame.left)
            cv2.imwrite(str(folders[1] / f"{number:03}.png"), spoil(frame.right))
    user.drop(folders)
    user.wait(lambda: user.window.files.setup.dialog is not None)
    user.wait_for_rest()
    assert words in user.dialog.cameras.doubts.text()
    assert user.dialog.picture.picture.image is not None
    assert "fps" in user.dialog.cameras.problem.text()  # images do not say how fast they come
    user.type(user.dialog.cameras.fps, "8")
    user.wait_for_rest()
    assert user.dialog.cameras.problem.text() == ""
    assert user.dialog.steps.item(0).text().endswith("warning")


def test_files_that_are_no_videos_are_told_beside_and_others_can_be_chosen(
    user: SetupUser, card: Path, tmp_path: Path
) -> None:
    text = tmp_path / "a.mp4"
    text.write_text("no video")
    user.drop([next(iter(card.glob("GX*"))), text])
    user.wait(lambda: user.window.files.setup.dialog is not None)
    user.wait_for_rest()
    dialog = user.dialog
    assert "a.mp4" in dialog.cameras.problem.text()
    user.drop([card], on=dialog)
    user.wait_for_rest()
    assert dialog.cameras.problem.text() == ""
    assert dialog.cameras.left.text().startswith("GX010035")


def test_calibrations_that_do_not_fit_are_told_beside_and_nothing_is_lost(
    begin: Begin, with_calibration: Path, tmp_path: Path
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.FLOOR)
    user.type(dialog.floor.height_m, "2.5")
    dialog.go_to(Step.CALIBRATION)
    calibration = read_calibration([with_calibration / "calibration.yaml"])
    other = tmp_path / "other.yaml"
    left = replace(calibration.left, width=400)
    write_calibration(other, replace(calibration, left=left, right=left))
    nothing = tmp_path / "nothing.yaml"
    nothing.write_text("nothing of a camera")
    for file, words in ((other, "another shape"), (nothing, "nothing.yaml")):
        dialog.calibration.take_files((file,))
        user.wait_for_rest()
        assert words in dialog.calibration.problem.text()
        dialog.go_to(Step.WRITE)
        assert not dialog.write.write.isEnabled()
        dialog.go_to(Step.CALIBRATION)
    user.key(dialog, Qt.Key.Key_Z, CTRL)
    user.key(dialog, Qt.Key.Key_Z, CTRL)
    user.wait_for_rest()
    assert dialog.plan is not None
    assert dialog.plan.ground is not None
    dialog.go_to(Step.WRITE)
    assert dialog.write.write.isEnabled()


def test_a_calibration_of_other_cameras_is_a_warning_that_next_tells_once(
    begin: Begin, with_calibration: Path, tmp_path: Path
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.CALIBRATION)
    user.wait_for_rest()
    assert mark_of(Step.CALIBRATION, dialog.editor.scene)[0] is Mark.DONE
    calibration = read_calibration([with_calibration / "calibration.yaml"])
    tilted, _ = cv2.Rodrigues(np.array([0.03, 0.0, 0.0]))
    other = tmp_path / "other.yaml"
    write_calibration(other, replace(calibration, rotation=tilted @ calibration.rotation))
    dialog.calibration.take_files((other,))
    user.wait_for_rest()
    assert mark_of(Step.CALIBRATION, dialog.editor.scene) == (Mark.WARNING, "does not fit")
    assert "does not fit" in dialog.calibration.misfit.text()
    assert not dialog.calibration.misfit.isHidden()
    dialog.go_on()
    assert dialog.page is dialog.calibration
    assert "press Next again" in dialog.calibration.misfit.text()
    dialog.go_on()
    assert dialog.page is dialog.floor


def test_a_square_of_no_size_and_boards_never_found_are_told(begin: Begin, card: Path) -> None:
    user = begin(card)
    dialog = user.dialog
    dialog.go_to(Step.CALIBRATION)
    user.choose(dialog.calibration.method, "board")
    board = dialog.calibration.board
    user.type(board.left, str(card / "GX010035.mp4"))
    assert board.right.text().endswith("GX010034.mp4")
    user.press(board.calibrate)
    user.wait_for_rest()
    assert "is not entered" in dialog.calibration.problem.text()
    user.type(board.fields.square, "0.025")
    user.press(board.calibrate)
    user.wait_for_rest()
    assert "Square: 0.025 mm" in dialog.calibration.problem.text()
    user.type(board.fields.square, "25")
    user.press(board.calibrate)
    user.wait_for_rest()
    assert "is found in 0 of" in dialog.calibration.problem.text()
    assert dialog.editor.state.board.square_mm == 25.0


def test_pictures_of_a_board_are_left_out_and_taken_in_again(
    begin: Begin, card: Path, tmp_path: Path
) -> None:
    pictures = tmp_path / "board"
    pictures.mkdir()
    board = Board("chessboard", 7, 5, 0.03)
    small = Camera(CAMERA.matrix * [[0.5], [0.5], [1.0]], CAMERA.distortion, 320, 240)
    write_pairs(pictures, board, pair_of(small), count=8)
    user = begin(card)
    dialog = user.dialog
    dialog.go_to(Step.CALIBRATION)
    user.choose(dialog.calibration.method, "board")
    form = dialog.calibration.board
    user.type(form.left, str(pictures / "left*.png"))
    assert form.right.text() == str(pictures / "right*.png")
    user.type(form.fields.columns, "7")
    user.type(form.fields.rows, "5")
    user.type(form.fields.square, "30")
    user.press(form.calibrate)
    user.wait_for_rest()
    assert "Error 0." in dialog.calibration.told.text()
    assert dialog.calibration.file.text() == "Calibration from the board"
    assert form.table.rowCount() >= 7
    used = dialog.editor.scene.boards
    assert used is not None
    item = form.table.item(0, 0)
    assert item is not None
    name = item.text()
    item.setCheckState(Qt.CheckState.Unchecked)
    user.wait_for_rest()
    fewer = dialog.editor.scene.boards
    assert fewer is not None
    assert name in fewer.rejected
    assert len(fewer.used) == len(used.used) - 1
    plan = dialog.plan
    assert plan is not None
    assert plan.calibration_file == card / "calibration.yaml"
    assert not (card / "calibration.yaml").exists()
    dialog.calibration.shown.setCurrentIndex(2)
    assert "covered" in dialog.picture.picture.said


def test_an_open_recording_is_set_up_again_and_keeps_what_set_up_does_not_know(
    user: SetupUser, window: MainWindow, tiny_recording: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    folder = tmp_path / "again"
    shutil.copytree(tiny_recording, folder)
    manifest = folder / "recording.toml"
    manifest.write_text("# of the north hall\n" + manifest.read_text() + "\n[mine]\nkey = 1\n")
    window.files.open_path(folder)
    qtbot.waitUntil(lambda: window.controller is not None)
    window.menus.actions["file.setup_again"].trigger()
    dialog = user.dialog
    user.wait_for_rest()
    old = manifest.read_text()
    dialog.go_to(Step.FLOOR)
    user.type(dialog.floor.tilt_deg, "55.5")
    dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    user.press(dialog.write.write)
    qtbot.waitUntil(lambda: bool(window.findChildren(QMessageBox)))
    (box,) = window.findChildren(QMessageBox)
    user.press(box.button(QMessageBox.StandardButton.Cancel))
    assert manifest.read_text() == old
    assert dialog.isVisible()
    qtbot.waitUntil(lambda: not window.findChildren(QMessageBox))
    user.press(dialog.write.write)
    qtbot.waitUntil(lambda: bool(window.findChildren(QMessageBox)))
    (box,) = window.findChildren(QMessageBox)
    user.press(next(button for button in box.buttons() if button.text() == "Replace"))
    qtbot.waitUntil(lambda: window.files.setup.dialog is None and not window.work.busy)
    text = manifest.read_text()
    assert "tilt = 55.5" in text
    assert "# of the north hall" in text
    assert "[mine]\nkey = 1" in text


def test_without_a_floor_there_is_no_overhead_view_and_a_button_leads_to_metres(
    user: SetupUser, window: MainWindow, card: Path, qtbot: QtBot
) -> None:
    window.files.open_path(card / "GX010035.mp4")
    qtbot.waitUntil(lambda: window.controller is not None)
    qtbot.waitUntil(lambda: window.workspace.setup.isVisibleTo(window))
    assert not window.workspace.overhead.isVisibleTo(window)
    window.workspace.setup.click()
    assert user.dialog.page is user.dialog.calibration
    assert user.dialog.cameras.editor.state.plan is not None


def test_everything_in_every_step_has_a_name_and_file_names_are_plain_text(
    begin: Begin, with_calibration: Path
) -> None:
    dialog = begin(with_calibration).dialog
    for step in Step:
        dialog.go_to(step)
        for label in dialog.findChildren(QLabel):
            assert label.textFormat() is Qt.TextFormat.PlainText
        for button in dialog.page.findChildren(QAbstractButton):
            assert button.accessibleName() or button.text() or button.parent() is not dialog.page
    lists: list[QWidget] = [dialog.picture, dialog.instant, dialog.steps]
    assert all(widget.accessibleName() for widget in lists)
