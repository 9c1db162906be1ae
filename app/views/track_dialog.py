"""The question before tracking: which tracker, with which settings."""

from __future__ import annotations

from typing import Any

from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QFrame,
    QLabel,
    QScrollArea,
    QSpinBox,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.views.parts import quiet
from app.views.settings_form import SettingsForm
from tracking.errors import TrackwrightError
from tracking.recording import Recording
from tracking.trackers import TRACKERS, require


class TrackDialog(QDialog):
    """Chooses a tracker that can work on the recording, its settings and the seed.

    `warning` is said above where tracking would replace something.
    """

    def __init__(
        self, recording: Recording, chosen: str, warning: str = "", parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Track"))
        self._names = [name for name in TRACKERS if _fits(name, recording)]
        self._choice = QComboBox(self)
        self._choice.setAccessibleName(self.tr("Tracker"))
        self._title = quiet("", self)
        self._title.setWordWrap(True)
        self._seed = QSpinBox(self)
        self._seed.setRange(0, 2**31 - 1)
        self._seed.setAccessibleName(self.tr("Seed of the random numbers"))
        self._seed.setToolTip(self.tr("The same seed gives the same tracks"))
        self._forms = QStackedWidget(self)
        for name in self._names:
            self._choice.addItem(name)
            self._forms.addWidget(_scrolled(SettingsForm(TRACKERS[name], self)))
        self._choice.currentIndexChanged.connect(self._show_tracker)
        self._choice.setCurrentIndex(self._names.index(chosen) if chosen in self._names else 0)
        self._lay_out(warning)
        self._show_tracker(self._choice.currentIndex())

    def _lay_out(self, warning: str) -> None:
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        if warning:
            said = QLabel(warning, self)
            said.setWordWrap(True)
            rows.addWidget(said)
        form = QFormLayout()
        form.addRow(self.tr("Tracker"), self._choice)
        form.addRow("", self._title)
        form.addRow(self.tr("Seed"), self._seed)
        rows.addLayout(form)
        rows.addWidget(self._forms, 1)
        buttons = QDialogButtonBox(self)
        start = buttons.addButton(self.tr("Track"), QDialogButtonBox.ButtonRole.AcceptRole)
        start.setProperty("primary", True)
        start.setDefault(True)
        reset = buttons.addButton(self.tr("Defaults"), QDialogButtonBox.ButtonRole.ResetRole)
        reset.clicked.connect(lambda: self.form.reset())
        buttons.addButton(QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        rows.addWidget(buttons)
        line = self.fontMetrics().height()
        self.resize(34 * line, 40 * line)

    @property
    def form(self) -> SettingsForm:
        """The chosen tracker's settings."""
        area = self._forms.currentWidget()
        assert isinstance(area, QScrollArea)
        form = area.widget()
        assert isinstance(form, SettingsForm)
        return form

    def answer(self) -> tuple[str, Any, int]:
        """Tracker, settings and seed."""
        return self._names[self._choice.currentIndex()], self.form.settings(), self._seed.value()

    def _show_tracker(self, index: int) -> None:
        if self._names:
            spec = TRACKERS[self._names[index]]
            self._title.setText(f"{spec.title} ({spec.paper})")
            self._forms.setCurrentIndex(index)


def _fits(name: str, recording: Recording) -> bool:
    try:
        require(TRACKERS[name], recording)
    except TrackwrightError:
        return False
    return True


def _scrolled(form: SettingsForm) -> QScrollArea:
    area = QScrollArea()
    area.setWidget(form)
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    return area
