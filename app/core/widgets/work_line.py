"""Work of a panel's own: what, how far, Cancel."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QProgressBar, QPushButton, QVBoxLayout, QWidget

from app.core.i18n import tr
from app.core.widgets.parts import quiet

_STEPS = 1000


class WorkLine(QWidget):
    """Two lines in a panel, hidden while nothing runs.

    Signals:
        cancelled(): Cancel was pressed.
    """

    cancelled = Signal()

    def __init__(self, cancel_name: str, parent: QWidget | None = None) -> None:
        """`cancel_name`: of the button, for screen readers."""
        super().__init__(parent)
        self._text = quiet("", self)
        self._bar = QProgressBar(self)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(tr("Progress"))
        self._cancel = QPushButton(tr("Cancel"), self)
        self._cancel.setAccessibleName(cancel_name)
        self._cancel.clicked.connect(self._stop)
        line = QHBoxLayout()
        line.setSpacing(12)
        line.addWidget(self._bar, 1)
        line.addWidget(self._cancel)
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(4)
        rows.addWidget(self._text)
        rows.addLayout(line)
        self.hide()

    def show_work(self, text: str, share: float | None = None) -> None:
        """Show work; "" where none runs; `share` done is 0..1, None where that is not known."""
        if self.isHidden():
            self._cancel.setEnabled(True)
        self.setVisible(bool(text))
        self._text.setText(text)
        self._bar.setRange(0, 0 if share is None else _STEPS)
        if share is not None:
            self._bar.setValue(round(share * _STEPS))

    def _stop(self) -> None:
        self._cancel.setEnabled(False)
        self.cancelled.emit()
