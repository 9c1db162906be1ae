"""The doctor's page: findings beside what each of them means, and a button that mends it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.widgets.fitted_image import FittedImage
from app.core.widgets.parts import heading, quiet
from app.core.widgets.progress_strip import ProgressStrip
from app.features.doctor.scene import DoctorScene, FindingScene, State

_SIZE_PX = (960, 600)
_LIST_LETTERS = 44
_PICTURE_HEIGHT_PX = 180
_MIDDLE_ROW, _MIDDLE_STRETCH = 1, 100
"""Findings take all the room there is; without any the words stand in the middle of it."""


class DoctorDialog(QDialog):
    """Shows a `DoctorScene`.

    Signals: `check_asked()`, `cancel_asked()`, `mend_asked(code)`, `undo_asked()`.
    """

    check_asked = Signal()
    cancel_asked = Signal()
    mend_asked = Signal(str)
    undo_asked = Signal()

    def __init__(self, name: str, parent: QWidget) -> None:
        """`name`: of the recording."""
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Check of {recording}", recording=name))
        self.resize(*_SIZE_PX)
        self._findings: tuple[FindingScene, ...] = ()
        self.text = _wrapped(self)
        self.unchecked = _wrapped(self)
        self.list = QListWidget(self)
        self.list.setAccessibleName(tr("Findings"))
        self.list.setWordWrap(True)
        self.list.setFixedWidth(_LIST_LETTERS * self.fontMetrics().averageCharWidth())
        self.list.currentRowChanged.connect(self._show_finding)
        self.detail = _FindingView(self)
        self.detail.mend.clicked.connect(self._ask_mend)
        self.progress = ProgressStrip(self)
        self.progress.cancelled.connect(self.cancel_asked)
        middle = QHBoxLayout()
        middle.setSpacing(16)
        middle.addWidget(self.list)
        middle.addWidget(self.detail, 1)
        self._rows = rows = QVBoxLayout(self)
        rows.setContentsMargins(16, 12, 16, 12)
        rows.setSpacing(10)
        rows.addWidget(self.text, 1)
        rows.addLayout(middle)
        rows.addWidget(self.unchecked)
        rows.addWidget(self.progress)
        rows.addLayout(self._buttons())

    def _buttons(self) -> QHBoxLayout:
        self.again = self._button(tr("Check again"), self.check_asked.emit)
        self.undo = self._button(tr("Undo the mend"), self.undo_asked.emit)
        self.mended = _wrapped(self)
        self.close_button = self._button(tr("Close"), self.accept)
        row = QHBoxLayout()
        row.addWidget(self.again)
        row.addWidget(self.undo)
        row.addWidget(self.mended, 1)
        row.addWidget(self.close_button)
        return row

    def _button(self, text: str, pressed: Callable[[], None]) -> QPushButton:
        button = QPushButton(text, self)
        button.setAutoDefault(False)
        button.clicked.connect(pressed)
        return button

    def show_scene(self, scene: DoctorScene) -> None:
        """Show what is known now."""
        works = scene.state is State.WORKING
        self.text.setText(scene.text)
        self.unchecked.setText(scene.unchecked)
        self.unchecked.setVisible(bool(scene.unchecked))
        self.again.setEnabled(not works)
        self.mended.setText(scene.mended)
        self.undo.setVisible(bool(scene.mended))
        self.undo.setEnabled(not works)
        if not works:
            self.progress.finish()
        self._list_findings(scene.findings)

    def show_progress(self, text: str, share: float | None, seconds_left: float | None) -> None:
        """Show how far the work is."""
        self.progress.show_scene(text, share, seconds_left)

    def _list_findings(self, findings: tuple[FindingScene, ...]) -> None:
        self._findings = findings
        self.list.clear()
        for finding in findings:
            self.list.addItem(QListWidgetItem(f"{finding.title}\n{finding.cost}"))
        for widget in (self.list, self.detail):
            widget.setVisible(bool(findings))
        self._rows.setStretch(_MIDDLE_ROW, _MIDDLE_STRETCH if findings else 0)
        centre, left = Qt.AlignmentFlag.AlignCenter, Qt.AlignmentFlag.AlignLeft
        self.text.setAlignment(left if findings else centre)
        if findings:
            self.list.setCurrentRow(0)
            self.list.setFocus()

    def _show_finding(self, row: int) -> None:
        if 0 <= row < len(self._findings):
            self.detail.show_finding(self._findings[row])

    def _ask_mend(self) -> None:
        row = self.list.currentRow()
        if 0 <= row < len(self._findings):
            self.mend_asked.emit(self._findings[row].code)


class _FindingView(QWidget):
    """One finding: what it means, the picture that shows it, figures, and Mend."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.title = heading("", self)
        self.title.setWordWrap(True)
        self.title.setTextFormat(Qt.TextFormat.PlainText)
        self.meaning, self.fix, self.figures, self.alike = (_wrapped(self) for _ in range(4))
        self.picture = FittedImage(tr("The image that shows the finding"), self)
        self.picture.setMinimumHeight(_PICTURE_HEIGHT_PX)
        self.mend = QPushButton(tr("Mend"), self)
        self.mend.setToolTip(
            tr("Writes what is right into the recording's files. Undo the mend takes it back.")
        )
        self.mend.setAutoDefault(False)
        self._form = QFormLayout()
        self._form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft)
        for name, label in (
            (tr("What it costs"), self.meaning),
            (tr("What to do"), self.fix),
            (tr("Measured"), self.figures),
            (tr("Looks the same"), self.alike),
        ):
            self._form.addRow(name, label)
        last = QHBoxLayout()
        last.addWidget(self.mend)
        last.addStretch(1)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(8)
        rows.addWidget(self.title)
        rows.addWidget(self.picture, 1)
        rows.addLayout(self._form)
        rows.addLayout(last)

    def show_finding(self, finding: FindingScene) -> None:
        """Show another one."""
        self.title.setText(finding.title)
        self.meaning.setText(finding.meaning)
        self.fix.setText(finding.fix)
        self.figures.setText("\n".join(f"{name}: {value}" for name, value in finding.figures))
        self.alike.setText(finding.alike)
        self._form.setRowVisible(self.figures, bool(finding.figures))
        self._form.setRowVisible(self.alike, bool(finding.alike))
        self.picture.show_image(finding.picture)
        self.picture.setVisible(finding.picture is not None)
        self.mend.setVisible(finding.mendable)


def _wrapped(parent: QWidget) -> QLabel:
    label = quiet("", parent)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setWordWrap(True)
    return label
