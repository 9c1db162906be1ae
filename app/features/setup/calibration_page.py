"""The step of the calibration."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QHBoxLayout, QStackedWidget, QVBoxLayout, QWidget

from app.core.i18n import tr
from app.core.jobs.latest_job import LatestJob
from app.core.widgets.user_settings import UserSettings
from app.features.setup import calibration_presenter
from app.features.setup.board_form import BoardPanel
from app.features.setup.calibration_presenter import MadeCalibration, rows_told, with_files
from app.features.setup.controller import SetupEditor
from app.features.setup.rough_form import RoughPanel
from app.features.setup.scene import (
    CalibrationMethod,
    CameraImages,
    SetupPicture,
    SetupScene,
    Shown,
    Step,
)
from app.features.setup.step_page import StepPage, choose, fit_stack, named, plain
from tracking.calibration.boards import FoundBoards
from tracking.calibration.rectified_preview import RectifiedPreview
from tracking.geometry import StereoCalibration
from tracking.progress import Progress

_METHODS: tuple[CalibrationMethod, ...] = ("file", "board", "rough")


class CalibrationPage(StepPage):
    """A file of any kind, a board, or rough from the images; with the rectified pair."""

    step = Step.CALIBRATION

    def __init__(self, editor: SetupEditor, remembered: UserSettings, parent: QWidget) -> None:
        said = tr(
            "Lenses, and how the cameras stand to each other. Without it there are no metres."
        )
        super().__init__(editor, tr("Calibration"), said, parent)
        self._remembered = remembered
        self._found: FoundBoards | None = None
        self._rectified: RectifiedPreview | None = None
        self._previews = LatestJob("rectified preview", _preview, self, listed=False)
        self._previews.found.connect(self._take_preview)
        self._previews.failed.connect(lambda *_: self._take_preview(None))
        form = self.form()
        methods = (
            ("file", tr("From a file")),
            ("board", tr("From pictures of a board")),
            ("rough", tr("Rough, from the images")),
        )
        self.method = self.choice(methods, self._choose_method)
        form.addRow(tr("Method"), named(self.method, tr("Method of calibration")))
        self.rows.addLayout(form)
        self.misfit = plain("", self, "warning")  # above the form of a method, which may be high
        self.misfit.hide()
        self.rows.addWidget(self.misfit)
        self._warned: tuple[Path, ...] = ()
        self.pages = QStackedWidget(self.widget())
        self.board = BoardPanel(self, remembered)
        self.rough = RoughPanel(self)
        for page in (self._file_panel(), self.board, self.rough):
            self.pages.addWidget(page)
        self.rows.addWidget(self.pages)
        self.told, self.read_told = plain("", self, ""), plain("", self)
        self.missing = plain("", self, "warning")
        for label in (self.problem, self.told, self.read_told, self.missing):
            self.rows.addWidget(label)
        self._build_shown()
        self.rows_told = plain("", self)
        self.rows.addWidget(self.rows_told)
        self.rows.addStretch(1)

    def _file_panel(self) -> QWidget:
        panel = QWidget(self)
        rows = QVBoxLayout(panel)
        rows.setContentsMargins(0, 0, 0, 0)
        self.file = plain("", panel, "")
        rows.addWidget(self.file)
        buttons = QHBoxLayout()
        self.read = self.button(tr("Read a file..."), self._ask_file)
        self.read.setToolTip(
            tr(
                "Of OpenCV, KITTI, ROS, EuRoC, Kalibr, COLMAP, MATLAB, ZED, OAK, or JSON or TOML; "
                "one file, or the two of a pair"
            )
        )
        self.without = self.button(
            tr("Use none"), self._take_none, tr("Go on without a calibration")
        )
        self.without.setToolTip(tr("Without a calibration there are boxes, and no metres."))
        buttons.addWidget(self.read)
        buttons.addWidget(self.without)
        rows.addLayout(buttons)
        return panel

    def _build_shown(self) -> None:
        form = self.form()
        shown = (
            ("cameras", tr("As recorded")),
            ("rectified", tr("Rectified, with level lines")),
            ("coverage", tr("Coverage by boards")),
        )
        self.shown = self.choice(shown, lambda _: self.redrawn.emit())
        form.addRow(tr("Picture"), named(self.shown, tr("What the picture shows")))
        self._shown_form = form
        self.rows.addLayout(form)

    def fill(self, scene: SetupScene) -> None:
        """The form of the method that is chosen, and what is known of the calibration."""
        state, plan = scene.state, scene.state.plan
        choose(self.method, state.calibration_method)
        self.pages.setCurrentIndex(_METHODS.index(state.calibration_method))
        files = plan.calibration if plan is not None else ()
        names = ", ".join(path.name for path in files)
        if files and state.calibration_told:  # its file is kept here, under a name of no meaning
            known = scene.checked.calibration
            rough = known is not None and known.rough
            names = tr("Rough calibration") if rough else tr("Calibration from the board")
        self.file.setText(names or tr("No calibration yet."))
        self.board.fill(scene)
        self.rough.fill(scene)
        for button in (self.read, self.without):
            button.setEnabled(plan is not None and not scene.busy)
        self.without.setVisible(bool(files))
        current = scene.checked.plan is not None and scene.checked.plan.calibration == files
        self.told.setText(state.calibration_told)
        self.told.setVisible(bool(state.calibration_told))
        self.read_told.setText("\n".join(_bulleted(scene.checked.read)) if current else "")
        self.missing.setText("\n".join(_bulleted(scene.checked.missing)) if current else "")
        self.missing.setVisible(bool(self.missing.text()))
        fit_stack(self.pages)
        pair = scene.checked.calibration is not None and plan is not None and plan.is_stereo
        self._shown_form.setRowVisible(self.shown, pair or scene.boards is not None)
        self._ask_preview(scene)

    def _ask_preview(self, scene: SetupScene) -> None:
        calibration, images = scene.checked.calibration, scene.images
        if calibration is None or images is None or images.right is None:
            self._rectified = None
            self._show_rows(scene)
            return
        if self.isVisible():
            self._previews.ask((calibration, images))

    def _take_preview(self, found: RectifiedPreview | None) -> None:
        self._rectified = found
        plan = self.editor.scene.checked.plan
        if found is not None and found.row_error_px is not None and plan is not None:
            self.editor.take_row_error(plan.calibration, found.row_error_px)
        self._show_rows(self.editor.scene)
        self.redrawn.emit()

    def _show_rows(self, scene: SetupScene) -> None:
        """How well rows lie level: quietly where they do, else as a warning above the form."""
        told = rows_told(self._rectified) if self._rectified is not None else ""
        misfit = scene.misfit_px is not None
        self.rows_told.setText("" if misfit else told)
        self.misfit.setText(told if misfit else "")
        self.misfit.setVisible(bool(self.misfit.text()))

    def holds_back(self) -> bool:
        """Whether the next step waits for another press: a calibration that does not fit, once."""
        plan = self.editor.state.plan
        if plan is None or self.editor.scene.misfit_px is None or plan.calibration == self._warned:
            return False
        self._warned = plan.calibration
        self.misfit.setText(
            f"{self.misfit.text()} {tr('Calibrate again, or press Next again to go on with it.')}"
        )
        self.ensureVisible(0, 0)
        return True

    def picture(self, scene: SetupScene) -> SetupPicture:
        """As recorded, rectified, or covered."""
        shown: Shown = self.shown.currentData()
        return calibration_presenter.calibration_picture(
            scene, shown, self._rectified, self.pointer
        )

    @property
    def busy(self) -> bool:
        """Whether the preview is worked out."""
        return self._previews.busy

    def stop(self) -> None:
        """The window closes."""
        self._previews.stop()

    # gestures

    def _choose_method(self, method: CalibrationMethod) -> None:
        self.editor.tell(self.step, "")
        self.editor.change(calibration_presenter.with_method(self.editor.state, method))

    def _ask_file(self) -> None:
        dialog = QFileDialog(self, tr("The calibration file, or the two of a pair"))
        dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
        last = self._remembered.last_folder("calibration")
        plan = self.editor.state.plan
        start = last.folder or (plan.left.parent if plan is not None else Path.home())
        dialog.setDirectory(str(start))

        def take(names: list[str]) -> None:
            last.note(Path(names[0]))
            self.take_files(tuple(Path(name) for name in sorted(names)))

        dialog.filesSelected.connect(take)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def take_files(self, files: tuple[Path, ...]) -> None:
        """Take calibration files that were chosen."""
        self.editor.change(with_files(self.editor.state, files))

    def _take_none(self) -> None:
        self.editor.change(with_files(self.editor.state, ()))

    def calibrate_board(self) -> None:
        """Look for the board, and fit the cameras."""
        state = self.editor.state
        plan, form = state.plan, state.board
        if plan is None:
            return
        stereo = plan.is_stereo

        def done(made: MadeCalibration) -> None:
            self._found = made.found
            self.editor.take_calibration(made)

        self.editor.run(
            self.step,
            tr("Looking for the board"),
            lambda progress: calibration_presenter.calibrate_board(form, stereo, progress),
            done,
        )

    def fit_again(self, left_out: frozenset[str]) -> None:
        """Leave pictures out, or take them in again."""
        found = self._found
        if found is None:
            return

        def done(made: MadeCalibration) -> None:
            self.editor.take_calibration(made)

        self.editor.run(
            self.step,
            tr("Fitting the cameras"),
            lambda _: calibration_presenter.fit_again(found, left_out),
            done,
        )

    def calibrate_rough(self) -> None:
        """A rough calibration from the cameras' own images."""
        plan, form = self.editor.state.plan, self.editor.state.rough
        if plan is None:
            return
        self.editor.run(
            self.step,
            tr("Comparing the cameras"),
            lambda progress: calibration_presenter.calibrate_rough(
                plan, form.fov_deg, form.baseline_mm, progress
            ),
            self.editor.take_calibration,
        )


def _preview(
    subject: tuple[StereoCalibration, CameraImages],
) -> Callable[[Progress], RectifiedPreview | None]:
    return lambda _: calibration_presenter.preview(*subject)


def _bulleted(lines: tuple[str, ...]) -> list[str]:
    return [f"\N{BULLET} {line}" for line in lines]
