"""Work of a panel's own: what, how far, how long still, Cancel."""

from __future__ import annotations

import time

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QProgressBar, QPushButton, QVBoxLayout, QWidget

from app.core.i18n import tr
from app.core.widgets.parts import quiet
from app.core.widgets.progress_strip import time_left_text

_STEPS = 1000
_TELL_LEFT_AFTER_S = 1.0


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
        self._left = quiet("", self)
        self._begun: tuple[str, float] = ("", 0.0)
        line = QHBoxLayout()
        line.setSpacing(12)
        line.addWidget(self._bar, 1)
        line.addWidget(self._left)
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
        if not text:
            self._begun = ("", 0.0)
        self._text.setText(text)
        self._left.setText(time_left_text(self._seconds_left(text, share)))
        self._bar.setRange(0, 0 if share is None else _STEPS)
        if share is not None:
            self._bar.setValue(round(share * _STEPS))

    def _seconds_left(self, text: str, share: float | None) -> float | None:
        """As long as it took so far for each part; None where that tells nothing yet."""
        now_s = time.monotonic()
        if text != self._begun[0]:
            self._begun = (text, now_s)
        passed_s = now_s - self._begun[1]
        if not share or passed_s < _TELL_LEFT_AFTER_S:
            return None
        return passed_s * (1.0 - share) / share

    def _stop(self) -> None:
        self._cancel.setEnabled(False)
        self.cancelled.emit()
