"""What fails in the set-up is told in words beside the field, and changes nothing that is good."""

from __future__ import annotations

import threading
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QUrl
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot
from setup_fixtures import PATIENCE_MS, Begin

from app.features.setup import trial
from app.features.setup.scene import Step
from app.shell.main_window import MainWindow
from tests.benchmarks.setup.user import SetupUser
from tests.calibration.rendered_boards import CAMERA, GROUND, lying, pair_of, write_pairs
from tracking.calibration.boards import Board
from tracking.geometry import Camera, read_calibration, write_calibration
from tracking.recording import open_recording
from tracking.setup.plan import setup_text


def _mark(user: SetupUser, step: Step) -> str:
    """How a step stands, as the list of steps says."""
    return user.dialog.steps.item(list(Step).index(step)).text().split("\n")[1]


def test_a_failed_try_of_points_leaves_a_good_floor_as_it_is(
    begin: Begin, with_calibration: Path
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.FLOOR)
    user.type(dialog.floor.height_m, "2.5")
    user.wait_for_rest()
    for method in ("points", "distances"):
        user.choose(dialog.floor.method, method)
        assert dialog.floor.problem.text() == ""
        user.press(dialog.floor.points.use)
        assert dialog.floor.problem.text().startswith("Floor: 0 ")
        assert dialog.floor.problem.text().endswith(".")
        assert _mark(user, Step.FLOOR) == "done"
    dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    assert "Floor" not in dialog.write.remarks.text()
    assert "height = 2.5" in dialog.write.text.toPlainText()


def test_a_failed_try_of_a_board_or_roughly_leaves_the_calibration_as_it_is(
    begin: Begin, with_calibration: Path
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.CALIBRATION)
    user.choose(dialog.calibration.method, "board")
    user.press(dialog.calibration.board.calibrate)
    user.wait_for_rest()
    assert dialog.calibration.problem.text().startswith("Choose the pictures")
    assert _mark(user, Step.CALIBRATION) == "done"
    user.choose(dialog.calibration.method, "rough")
    assert dialog.calibration.problem.text() == ""
    user.press(dialog.calibration.rough.calibrate)
    user.wait_for_rest()
    assert "distance of the cameras is not entered" in dialog.calibration.problem.text()
    assert _mark(user, Step.CALIBRATION) == "done"


def test_names_of_files_at_the_beginning_of_a_sentence_stay_as_they_are(
    user: SetupUser, card: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    text = Path("a.mp4")
    text.write_text("no video")
    user.window.files.setup.begin([next(iter(card.glob("GX*"))), text])
    user.wait_for_rest()
    assert user.dialog.cameras.problem.text().startswith("a.mp4: text, not a video")


def test_two_videos_of_different_scenes_are_told_and_others_can_be_dropped(
    user: SetupUser, card: Path, tmp_path: Path
) -> None:
    other = tmp_path / "noise"
    other.mkdir()
    random = np.random.default_rng(1)
    for number in range(4):
        noise = cv2.resize(random.integers(0, 255, (20, 30, 3), np.uint8), (320, 240))
        cv2.imwrite(str(other / f"{number}.png"), noise)
    left = next(iter(card.glob("GX010035*")))
    user.drop([left, other])
    user.wait(lambda: user.window.files.setup.dialog is not None)
    user.wait_for_rest()
    doubts = user.dialog.cameras.doubts.text()
    assert f"{left.name} and noise do not show the same place" in doubts
    assert _mark(user, Step.CAMERAS) == "warning"
    user.drop([card], on=user.dialog)
    user.wait_for_rest()
    assert user.dialog.cameras.doubts.text() == ""


def test_a_calibration_of_another_resolution_is_scaled_and_says_so(
    begin: Begin, with_calibration: Path, tmp_path: Path
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.CALIBRATION)
    calibration = read_calibration([with_calibration / "calibration.yaml"])
    larger = tmp_path / "larger.yaml"
    write_calibration(larger, calibration.scaled_to((640, 480)))
    dialog.calibration.take_files((larger,))
    user.wait_for_rest()
    assert "scaled to the cameras' 320 x 240 px" in dialog.calibration.read_told.text()
    assert _mark(user, Step.CALIBRATION) == "done"


def test_of_pictures_of_a_board_the_blurred_ones_are_told(
    begin: Begin, card: Path, tmp_path: Path
) -> None:
    pictures = tmp_path / "board"
    pictures.mkdir()
    small = Camera(CAMERA.matrix * [[0.5], [0.5], [1.0]], CAMERA.distortion, 320, 240)
    write_pairs(pictures, Board("chessboard", 7, 5, 0.03), pair_of(small), count=8)
    sharp = sorted(pictures.glob("left*.png"))
    for number, left in enumerate(sharp * 2, 50):
        for side in ("left", "right"):
            image = cv2.imread(str(left.with_name(left.name.replace("left", side))))
            assert image is not None
            blurred = cv2.blur(image, (1, 25))
            cv2.imwrite(str(pictures / f"{side}{number}.png"), blurred)
    user = begin(card)
    dialog = user.dialog
    dialog.go_to(Step.CALIBRATION)
    user.choose(dialog.calibration.method, "board")
    form = dialog.calibration.board
    user.type(form.left, str(pictures / "left*.png"))
    user.type(form.fields.columns, "7")
    user.type(form.fields.rows, "5")
    user.type(form.fields.square, "30")
    user.press(form.calibrate)
    user.wait_for_rest()
    told = dialog.calibration.told.text() + dialog.calibration.problem.text()
    assert "8 pictures" in told
    assert "No board in 16 images, which are left out" in told
    assert dialog.editor.state.board.square_mm == 30.0


def test_what_would_be_written_is_worked_out_beside_the_windows_thread(
    begin: Begin, with_calibration: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    threads = []

    def noted(plan: object) -> str:
        threads.append(threading.current_thread())
        return setup_text(plan)  # type: ignore[arg-type]

    monkeypatch.setattr(trial, "setup_text", noted)
    user = begin(with_calibration)
    user.dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    assert "GX010035" in user.dialog.write.text.toPlainText()
    assert threads
    assert threading.main_thread() not in threads


def test_a_check_that_fails_is_told_where_it_keeps_from_writing(
    begin: Begin, with_calibration: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(plan: object) -> None:
        raise ArithmeticError("out of range")

    monkeypatch.setattr(trial, "check", fail)
    user = begin(with_calibration)
    user.dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    assert "out of range" in user.dialog.write.problem.text()
    assert not user.dialog.write.write.isEnabled()
    assert _mark(user, Step.WRITE) == "warning"


def test_a_recording_toml_that_came_meanwhile_is_not_replaced(
    begin: Begin, with_calibration: Path, window: MainWindow
) -> None:
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    (with_calibration / "recording.toml").write_text("# theirs\n")
    user.press(dialog.write.write)
    user.wait_for_rest()
    assert "exists" in dialog.write.problem.text()
    assert (with_calibration / "recording.toml").read_text() == "# theirs\n"
    assert window.files.setup.dialog is dialog


def test_the_floor_stands_on_the_picture_of_every_step_that_shows_the_left_image(
    begin: Begin, with_calibration: Path, tiny_recording: Path
) -> None:
    with open_recording(tiny_recording) as recording:
        truth = recording.ground
    assert truth is not None
    user = begin(with_calibration)
    dialog = user.dialog
    dialog.go_to(Step.FLOOR)
    for field, value in (
        (dialog.floor.height_m, truth.height_m),
        (dialog.floor.tilt_deg, truth.tilt_deg),
    ):
        user.type(field, f"{value:g}")
    user.wait_for_rest()
    for step in Step:
        dialog.go_to(step)
        user.wait_for_rest()
        user.hover_image(100, 200)
        first = dialog.picture.picture
        user.hover_image(220, 200)
        assert len(first.grid) > 10
        assert first.horizon is not None
        assert first.figure is not None
        assert dialog.picture.picture.figure != first.figure
        assert first.floor_size == (320.0, 240.0)


def test_fields_are_as_high_as_their_words_need(begin: Begin, with_calibration: Path) -> None:
    dialog = begin(with_calibration).dialog
    for step in Step:
        dialog.go_to(step)
        for box in (dialog.cameras.lag, dialog.floor.height_m, dialog.calibration.rough.fov):
            assert box.minimumHeight() >= box.fontMetrics().height() + 8


def test_a_folder_with_two_videos_is_set_up_however_it_is_opened(
    user: SetupUser, card: Path, qtbot: QtBot
) -> None:
    user.window.files.open_path(card)
    qtbot.waitUntil(lambda: user.window.files.setup.dialog is not None)
    user.wait_for_rest()
    assert user.dialog.cameras.left.text().startswith("GX010035")


def test_a_drop_while_a_recording_is_opened_is_taken_once_that_is_open(
    user: SetupUser, tiny_recording: Path, card: Path, qtbot: QtBot
) -> None:
    user.window.files.open_path(tiny_recording)
    user.drop([card])
    qtbot.waitUntil(lambda: user.window.files.setup.dialog is not None, timeout=20_000)
    assert user.window.controller is not None
    user.wait_for_rest()
    assert user.dialog.cameras.left.text().startswith("GX010035")


def test_methods_of_a_draft_that_are_not_known_any_more_begin_anew(
    begin: Begin, with_calibration: Path
) -> None:
    user = begin(with_calibration)
    plan = user.dialog.plan
    assert plan is not None
    drafts = user.dialog.editor._drafts
    drafts.save(user.dialog.editor.state)
    assert drafts.find(plan) == user.dialog.editor.state
    file = drafts._file(plan)
    file.write_text(file.read_text().replace('"measured"', '"guessed"'))
    assert drafts.find(plan) is None
    assert drafts.find(replace(plan, name="other")) is None


def test_the_floor_is_found_by_a_board_that_lies_on_it(user: SetupUser, tmp_path: Path) -> None:
    board = Board("chessboard", 9, 6, 0.1)
    for side in ("left", "right"):
        (tmp_path / side).mkdir()
        for number in range(3):
            cv2.imwrite(str(tmp_path / side / f"{number}.png"), lying(board))
    write_calibration(tmp_path / "rig.yaml", pair_of(CAMERA))
    user.drop([tmp_path / "left", tmp_path / "right"])
    user.wait(lambda: user.window.files.setup.dialog is not None)
    user.wait_for_rest()
    dialog = user.dialog
    user.type(dialog.cameras.fps, "10")
    dialog.calibration.take_files((tmp_path / "rig.yaml",))
    user.wait_for_rest()
    dialog.go_to(Step.FLOOR)
    user.choose(dialog.floor.method, "board")
    user.press(dialog.floor.find_board)
    user.wait_for_rest()
    assert "square in metres" in dialog.floor.problem.text()
    user.type(dialog.floor.board.square, "100")
    user.press(dialog.floor.find_board)
    user.wait_for_rest()
    assert dialog.floor.told.text().startswith("By the board")
    assert dialog.floor.height_m.value() == pytest.approx(GROUND.height_m, rel=0.01)
    assert dialog.floor.tilt_deg.value() == pytest.approx(GROUND.tilt_deg, abs=0.5)
    assert dialog.floor.doubt.text() == ""
    dialog.calibration.take_files((tmp_path / "rig.yaml",))
    user.wait_for_rest()
    assert "calibration has changed since" in dialog.floor.doubt.text()
    assert _mark(user, Step.FLOOR) == "unsure"


def test_cancel_at_the_question_about_unsaved_work_leaves_the_set_up_as_it_was(
    user: SetupUser,
    tiny_recording: Path,
    with_calibration: Path,
    qtbot: QtBot,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    window = user.window
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller is not None, timeout=PATIENCE_MS)
    unsaved = [True]
    changed = property(lambda _: unsaved[0])
    monkeypatch.setattr(type(window.files.saving), "changed_here", changed)
    user.drop(sorted(with_calibration.glob("GX*")))
    qtbot.waitUntil(lambda: window.files.setup.dialog is not None, timeout=PATIENCE_MS)
    user.wait_for_rest()
    dialog = user.dialog
    dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    entered = dialog.editor.state
    user.press(dialog.write.write)
    qtbot.waitUntil(lambda: window.findChild(QMessageBox, "unsaved") is not None)
    box = window.findChild(QMessageBox, "unsaved")
    user.press(box.button(QMessageBox.StandardButton.Cancel))
    qtbot.waitUntil(lambda: window.findChild(QMessageBox, "unsaved") is None)
    assert dialog.isVisible()
    assert dialog.editor.state == entered
    assert "Nothing is written yet" in dialog.write.problem.text()
    assert not (with_calibration / "recording.toml").exists()
    assert window.controller is not None
    unsaved[0] = False
    user.press(dialog.write.write)
    qtbot.waitUntil(lambda: window.files.setup.dialog is None, timeout=PATIENCE_MS)
    assert (with_calibration / "recording.toml").is_file()


def test_a_readme_that_is_dropped_is_told_what_can_be_dropped(
    begin: Begin, card: Path, tmp_path: Path
) -> None:
    readme = tmp_path / "README.md"
    readme.write_text("# Videos")
    user = begin(card)
    before = user.dialog.editor.state
    user.dialog.take_dropped([QUrl.fromLocalFile(str(readme))])
    assert "Drop videos of the cameras" in user.dialog.cameras.problem.text()
    assert user.dialog.editor.state == before
    user.dialog.reject()
    user.drop([readme])
    assert "README.md is a text to read. Drop videos" in user.window.notice.text
