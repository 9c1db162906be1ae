"""A rough calibration: field of view and distance of the cameras."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.core.i18n import tr
from app.features.setup.calibration_presenter import with_rough
from app.features.setup.scene import SetupScene
from app.features.setup.step_page import named, plain

if TYPE_CHECKING:
    from app.features.setup.calibration_page import CalibrationPage

_MM = 1000.0
"""In a metre, in which this distance is told everywhere."""
_DEGREE = "\N{DEGREE SIGN}"


class RoughPanel(QWidget):
    """What has to be known where there is no board and no file."""

    def __init__(self, page: CalibrationPage) -> None:
        super().__init__(page)
        self._page = page
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        said = tr("Metres will be marked as rough: errors here are errors of metres.")
        rows.addWidget(plain(said, self))
        form = page.form()
        self.fov = page.number(f" {_DEGREE}", 5.0, 150.0, 1, self._change)
        self.fov.setToolTip(tr("Horizontal; the camera's data sheet has it."))
        form.addRow(tr("Field of view"), named(self.fov, tr("Horizontal field of view")))
        self.baseline = page.number(" m", 0.0, 20.0, 4, self._change)
        self.baseline.setSpecialValueText(tr("not known"))
        self.baseline.setToolTip(tr("Between the lenses' middles."))
        form.addRow(tr("Camera distance"), named(self.baseline, tr("Distance of the cameras")))
        self._form = form
        rows.addLayout(form)
        self.calibrate = page.button(tr("Calibrate roughly"), page.calibrate_rough)
        rows.addWidget(self.calibrate)

    def fill(self, scene: SetupScene) -> None:
        """What was entered."""
        plan, rough = scene.state.plan, scene.state.rough
        self.fov.setValue(rough.fov_deg)
        self.baseline.setValue(rough.baseline_mm / _MM)
        self._form.setRowVisible(1, plan is not None and plan.is_stereo)
        self.calibrate.setEnabled(plan is not None and not scene.busy)

    def _change(self) -> None:
        editor = self._page.editor
        editor.change(with_rough(editor.state, self.fov.value(), _MM * self.baseline.value()))
