"""The set-up's steps, as they are after a person's answers to the ones before."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from app.features.setup import floor_presenter, region_presenter
from app.features.setup.board_form import BoardPanel
from app.features.setup.calibration_page import CalibrationPage
from app.features.setup.calibration_presenter import with_board, with_method, with_rough
from app.features.setup.cameras_page import CamerasPage
from app.features.setup.dialog import SetupDialog
from app.features.setup.floor_page import FloorPage
from app.features.setup.region_page import RegionPage
from app.features.setup.rough_form import RoughPanel
from app.features.setup.scene import BoardForm, Step
from app.features.setup.write_page import WritePage
from tests.pictures.snapshots.snapshot import On, snapshot
from tests.pictures.snapshots.stage import Stage

SETUP = "setup"
_FLOOR_METHODS = 6


def _begun(stage: Stage) -> SetupDialog:
    """The set-up with the videos of a pair."""
    stage.window.files.setup.ask()
    dialog = stage.window.files.setup.dialog
    assert dialog is not None
    dialog.editor.forget_draft()
    dialog.editor.take_paths(sorted(stage.material.card.iterdir()))
    _rest(stage, dialog)
    return dialog


def _rest(stage: Stage, dialog: SetupDialog) -> None:
    stage.wait(lambda: not dialog.editor.busy and not dialog.calibration.busy)
    stage.rest(200)
    stage.wait(lambda: not dialog.editor.busy and not dialog.calibration.busy)


def _shown(stage: Stage, dialog: SetupDialog) -> Iterator[QWidget]:
    _rest(stage, dialog)
    yield dialog
    dialog.editor.forget_draft()
    dialog.reject()
    stage.rest()


def _calibrated(stage: Stage) -> SetupDialog:
    """With a rough calibration; a dialog that closed has deleted the file of its own."""
    dialog = _begun(stage)
    dialog.go_to(Step.CALIBRATION)
    editor = dialog.editor
    editor.change(with_method(editor.state, "rough"))
    editor.change(with_rough(editor.state, 64.0, 120.0))
    dialog.calibration.calibrate_rough()
    _rest(stage, dialog)
    return dialog


@snapshot(SETUP, On.NOTHING, SetupDialog, CamerasPage)
def step_1_without_files(stage: Stage) -> Iterator[QWidget]:
    stage.window.files.setup.ask()
    dialog = stage.window.files.setup.dialog
    assert dialog is not None
    yield from _shown(stage, dialog)


@snapshot(SETUP, On.NOTHING, SetupDialog, CamerasPage)
def step_1_cameras(stage: Stage) -> Iterator[QWidget]:
    yield from _shown(stage, _begun(stage))


@snapshot(SETUP, On.NOTHING, CalibrationPage)
def step_2_calibration_file(stage: Stage) -> Iterator[QWidget]:
    dialog = _begun(stage)
    dialog.go_to(Step.CALIBRATION)
    yield from _shown(stage, dialog)


@snapshot(SETUP, On.NOTHING, CalibrationPage, BoardPanel)
def step_2_calibration_board(stage: Stage) -> Iterator[QWidget]:
    dialog = _begun(stage)
    dialog.go_to(Step.CALIBRATION)
    editor = dialog.editor
    editor.change(with_method(editor.state, "board"))
    editor.change(with_board(editor.state, BoardForm(left="left*.png", right="right*.png")))
    dialog.calibration.calibrate_board()
    yield from _shown(stage, dialog)


@snapshot(SETUP, On.NOTHING, CalibrationPage, RoughPanel)
def step_2_calibration_rough(stage: Stage) -> Iterator[QWidget]:
    yield from _shown(stage, _calibrated(stage))


@snapshot(SETUP, On.NOTHING, CalibrationPage)
def step_2_rectified(stage: Stage) -> Iterator[QWidget]:
    dialog = _calibrated(stage)
    dialog.go_to(Step.CALIBRATION)
    dialog.calibration.shown.setCurrentIndex(1)
    yield from _shown(stage, dialog)


def _floor(method: int, stage: Stage) -> Iterator[QWidget]:
    dialog = _calibrated(stage)
    dialog.go_to(Step.FLOOR)
    if method < dialog.floor.method.count():
        dialog.floor.method.setCurrentIndex(method)
    yield from _shown(stage, dialog)


for _method in range(_FLOOR_METHODS):
    snapshot(SETUP, On.NOTHING, FloorPage, name=f"step 3 floor {_method + 1}")(
        partial(_floor, _method)
    )


@snapshot(SETUP, On.NOTHING, FloorPage)
def step_3_floor_measured(stage: Stage) -> Iterator[QWidget]:
    dialog = _calibrated(stage)
    dialog.go_to(Step.FLOOR)
    dialog.floor.measure.click()
    yield from _shown(stage, dialog)


@snapshot(SETUP, On.NOTHING, FloorPage)
def step_3_floor_points(stage: Stage) -> Iterator[QWidget]:
    yield from _shown(stage, _with_points(stage))


def _with_points(stage: Stage) -> SetupDialog:
    dialog = _calibrated(stage)
    dialog.go_to(Step.FLOOR)
    dialog.floor.measure.click()
    _rest(stage, dialog)
    dialog.floor.method.setCurrentIndex(2)
    for u, v in ((120, 300), (500, 310), (560, 440), (60, 430)):
        dialog.editor.change(floor_presenter.with_point(dialog.editor.state, u, v))
    _rest(stage, dialog)
    return dialog


def _with_region(stage: Stage) -> SetupDialog:
    dialog = _with_points(stage)
    dialog.go_to(Step.REGION)
    outline = ((40.0, 120.0), (600.0, 120.0), (600.0, 470.0), (40.0, 470.0))
    state = region_presenter.with_outline(dialog.editor.state, "look", outline)
    mask = tuple((float(x), float(y)) for x, y in np.array([(300, 200), (400, 200), (350, 300)]))
    dialog.editor.change(region_presenter.with_outline(state, "mask", mask))
    dialog.region.choose_handle(1)
    return dialog


@snapshot(SETUP, On.NOTHING, RegionPage)
def step_4_region(stage: Stage) -> Iterator[QWidget]:
    yield from _shown(stage, _with_region(stage))


@snapshot(SETUP, On.NOTHING, WritePage)
def step_5_write(stage: Stage) -> Iterator[QWidget]:
    dialog = _with_region(stage)
    dialog.go_to(Step.WRITE)
    yield from _shown(stage, dialog)


@snapshot(SETUP, On.SESSION, SetupDialog)
def recording_set_up_again(stage: Stage) -> Iterator[QWidget]:
    yield from _shown(stage, _again(stage))


def _again(stage: Stage) -> SetupDialog:
    stage.run("file.setup_again")
    dialog = stage.window.files.setup.dialog
    assert dialog is not None
    _rest(stage, dialog)
    return dialog


@snapshot(SETUP, On.SESSION, "app.shell.setup_controller:_write")
def replace_what_is_there(stage: Stage) -> Iterator[QWidget]:
    """The question before recording.toml is written anew."""
    dialog = _again(stage)
    dialog.go_to(Step.WRITE)
    _rest(stage, dialog)
    dialog.write.write_asked.emit()
    box = stage.seen(QMessageBox)
    yield box
    box.reject()
    dialog.editor.forget_draft()
    dialog.reject()


@snapshot(SETUP, On.NOTHING, "app.features.setup.cameras_page:_ask_files")
def videos_to_choose(stage: Stage) -> Iterator[QWidget]:
    stage.window.files.setup.ask()
    dialog = stage.window.files.setup.dialog
    assert dialog is not None
    dialog.cameras._ask_files()
    yield from _chosen(stage, dialog)


@snapshot(SETUP, On.NOTHING, "app.features.setup.calibration_page:_ask_file")
def calibration_to_choose(stage: Stage) -> Iterator[QWidget]:
    dialog = _begun(stage)
    dialog.go_to(Step.CALIBRATION)
    dialog.calibration._ask_file()
    yield from _chosen(stage, dialog)


def _chosen(stage: Stage, dialog: SetupDialog) -> Iterator[QWidget]:
    files = stage.seen(QFileDialog)
    yield files
    files.reject()
    dialog.editor.forget_draft()
    dialog.reject()
