"""The set-up's form: cameras, calibration and floor beside a live picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QImage, QPixmap, QResizeEvent
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.jobs.jobs import Job
from app.core.widgets.number_boxes import NumberBox, tell_beside
from app.core.widgets.parts import quiet
from app.core.widgets.questions import choose_file
from app.core.widgets.user_settings import UserSettings
from app.features.setup import presenter
from app.features.setup.presenter import SetupScene
from tracking.calibration.floor import FloorEstimate
from tracking.errors import CalibrationError
from tracking.geometry import Ground
from tracking.progress import Progress
from tracking.recording.frame import Image
from tracking.setup import SetupPlan

_FORM_LETTERS, _PICTURE_PX = 58, (420, 320)


class SetupDialog(QDialog):
    """Shows a :class:`SetupScene` and changes it; what it takes long for is done beside.

    Signals: `planned(plan)`, the plan is to be written and opened. Whoever has written it accepts
    the form; until then nothing that was typed is lost.
    """

    planned = Signal(object)

    def __init__(self, scene: SetupScene, remembered: UserSettings, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Set up a recording"))
        self._remembered = remembered
        self._job: Job | None = None
        self._fills = False
        self.scene = scene
        self.picture = _Picture(self)
        across = QHBoxLayout(self)
        across.addWidget(self._form())
        across.addWidget(self.picture, 1)
        self.show_scene(scene)

    def _form(self) -> QWidget:
        panel = QWidget(self)
        panel.setFixedWidth(_FORM_LETTERS * self.fontMetrics().averageCharWidth())
        rows, form = QVBoxLayout(panel), QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        rows.addLayout(form)
        self.name = QLineEdit(panel)
        form.addRow(tr("Name"), self.name)
        self.left, self.right = (_plain(panel) for _ in range(2))
        form.addRow(tr("Left camera"), self.left)
        form.addRow(tr("Right camera"), self.right)
        self.swap = self._button(tr("Swap left and right"), self._swap)
        form.addRow("", self.swap)
        self.cameras = _plain(panel)
        form.addRow("", self.cameras)
        self.calibration = _plain(panel)
        form.addRow(tr("Calibration"), self.calibration)
        self.read = self._button(tr("Read a file..."), self._choose_calibration)
        form.addRow("", self.read)
        self.height_m, self.tilt_deg, self.roll_deg = self._floor_fields(form)
        self.measure = self._button(tr("Measure the floor"), self._measure)
        form.addRow("", self.measure)
        self.floor = _plain(panel)
        form.addRow("", self.floor)
        self.problem = _plain(panel)
        rows.addStretch(1)
        rows.addWidget(self.problem)
        kinds = QDialogButtonBox.StandardButton
        self.buttons = QDialogButtonBox(kinds.Ok | kinds.Cancel, panel)
        self.buttons.button(kinds.Ok).setText(tr("Write and open"))
        self.buttons.accepted.connect(self._write)
        self.buttons.rejected.connect(self.reject)
        rows.addWidget(self.buttons)
        return panel

    def _floor_fields(self, form: QFormLayout) -> tuple[NumberBox, NumberBox, NumberBox]:
        made = []
        for text, low, high, unit in (
            (tr("Camera height"), 0.0, 60.0, " m"),
            (tr("Tilt"), -45.0, 90.0, "\N{DEGREE SIGN}"),
            (tr("Roll"), -90.0, 90.0, "\N{DEGREE SIGN}"),
        ):
            box = NumberBox(self)
            box.setRange(low, high)
            box.setDecimals(3 if unit == " m" else 2)
            box.setSingleStep(0.1)
            box.setSuffix(unit)
            box.setKeyboardTracking(False)
            tell_beside(box)
            box.valueChanged.connect(self._type_floor)
            form.addRow(text, box)
            made.append(box)
        height, tilt, roll = made
        height.setSpecialValueText(tr("not known"))
        height.setToolTip(tr("Of the left camera above the floor."))
        tilt.setToolTip(tr("Of the optical axis below the horizon; 90 looks straight down."))
        roll.setToolTip(tr("About the optical axis, clockwise as the camera sees the world."))
        return height, tilt, roll

    def _button(self, text: str, pressed: Callable[[], None]) -> QPushButton:
        button = QPushButton(text, self)
        button.setAutoDefault(False)
        button.clicked.connect(pressed)
        return button

    def show_scene(self, scene: SetupScene) -> None:
        """Show what is known now."""
        self.scene, plan = scene, scene.plan
        self._fills = True
        if not self.name.isModified():
            self.name.setText(plan.name or plan.folder.name)
        self.left.setText(plan.left.name)
        both = tr("in the same image ({layout})", layout=_layout_text(plan))
        self.right.setText(
            plan.right.name if plan.right else both if plan.layout else tr("none: one camera")
        )
        self.cameras.setText("\n".join(filter(None, (scene.found, scene.doubts))))
        names = ", ".join(path.name for path in plan.calibration)
        self.calibration.setText(names or tr("none: boxes only, no metres"))
        ground = plan.ground
        for box, value in zip(
            (self.height_m, self.tilt_deg, self.roll_deg),
            (ground.height_m, ground.tilt_deg, ground.roll_deg) if ground else (0.0, 0.0, 0.0),
            strict=True,
        ):
            if ground is not None or box is self.height_m:
                box.setValue(value)
        self._fills = False
        self.floor.setText(scene.floor_told)
        self.problem.setText(scene.problem)
        self.swap.setEnabled(scene.stereo)
        self.measure.setEnabled(bool(plan.calibration) and self._job is None)
        ok = self.buttons.button(QDialogButtonBox.StandardButton.Ok)
        ok.setEnabled(not scene.problem and self._job is None)
        self.picture.show_image(presenter.picture_of(scene))

    def _swap(self) -> None:
        self._beside(lambda _: presenter.swapped(self.scene), self.show_scene)

    def _choose_calibration(self) -> None:
        last = self._remembered.last_folder("calibration")
        choose_file(self, tr("The calibration file"), "", self.take_calibration, last)

    def take_calibration(self, path: Path) -> None:
        """Take a calibration file that was chosen."""
        self.show_scene(presenter.with_calibration(self.scene, (path,)))

    def _type_floor(self) -> None:
        if self._fills:
            return
        ground = None
        if self.height_m.value() > 0.0:
            try:
                ground = Ground(self.height_m.value(), self.tilt_deg.value(), self.roll_deg.value())
            except CalibrationError as error:
                self.problem.setText(tr(error.message))
                return
        self.show_scene(presenter.with_ground(self.scene, ground))

    def _measure(self) -> None:
        self.floor.setText(tr("Measuring the floor..."))
        scene = self.scene

        def show(found: FloorEstimate) -> None:
            self.show_scene(presenter.with_estimate(self.scene, found))

        self._beside(lambda progress: presenter.measured(scene, progress), show)

    def _beside(self, work: Callable[[Progress], Any], done: Callable[[Any], None]) -> None:
        """Do what takes long beside the window; what it ends with is shown."""
        self._end_job()
        self._job = job = Job(self.windowTitle(), work, self)
        job.done.connect(lambda result: self._finish(lambda: done(result)))
        job.failed.connect(lambda error: self._finish(lambda: self._tell(error)))
        job.start()
        for button in (self.measure, self.buttons.button(QDialogButtonBox.StandardButton.Ok)):
            button.setEnabled(False)

    def _finish(self, then: Callable[[], None]) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        self.show_scene(self.scene)
        then()

    def _tell(self, error: Exception) -> None:
        self.floor.setText(explain(error))

    def _end_job(self) -> None:
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()

    def done(self, result: int) -> None:
        """Close; what still works is ended."""
        self._end_job()
        super().done(result)

    def _write(self) -> None:
        self.planned.emit(self.plan)

    @property
    def plan(self) -> SetupPlan:
        """What is to be written."""
        return replace(self.scene.plan, name=self.name.text().strip() or self.scene.plan.name)


def _layout_text(plan: SetupPlan) -> str:
    return tr("side by side") if plan.layout == "side-by-side" else tr("one above the other")


def _plain(parent: QWidget) -> QLabel:
    label = quiet("", parent)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setWordWrap(True)
    return label


class _Picture(QLabel):
    """An image as large as there is room."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setMinimumSize(*_PICTURE_PX)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setAccessibleName(tr("Left camera with the floor's grid"))
        self._whole = QPixmap()

    def show_image(self, image: Image | None) -> None:
        """Show another image, (height, width, 3) BGR; None: nothing."""
        self._whole = QPixmap()
        if image is not None:
            packed = np.ascontiguousarray(image)
            height, width = packed.shape[:2]
            kind = QImage.Format.Format_BGR888
            self._whole = QPixmap.fromImage(
                QImage(packed.data, width, height, 3 * width, kind).copy()
            )
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Fit the image anew."""
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        if self._whole.isNull():
            self.clear()
            return
        keep = Qt.AspectRatioMode.KeepAspectRatio
        smooth = Qt.TransformationMode.SmoothTransformation
        self.setPixmap(self._whole.scaled(self.size(), keep, smooth))
