"""Long work: what, how far, how long still, Cancel."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QProgressBar, QPushButton, QWidget

_STEPS = 1000


class ProgressStrip(QFrame):
    """A line at the window's lower edge, hidden while nothing runs.

    Signals:
        cancelled(): Cancel was pressed.
    """

    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("bar", True)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 2, 12, 2)
        row.setSpacing(12)
        self._text = QLabel(self)
        self._bar = QProgressBar(self)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(self.tr("Progress"))
        self._left = QLabel(self)
        self._left.setProperty("role", "muted")
        self._cancel = QPushButton(self.tr("Cancel"), self)
        self._cancel.setAccessibleName(self.tr("Cancel the running work"))
        self._cancel.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._cancel.clicked.connect(self._stop)
        for widget, share in ((self._text, 0), (self._bar, 1), (self._left, 0), (self._cancel, 0)):
            row.addWidget(widget, share)
        self.hide()

    def show_scene(
        self,
        text: str,
        share: float | None,
        seconds_left: float | None = None,
        cancellable: bool = True,
    ) -> None:
        """Show work; `share` done is 0..1, None where the end is not known."""
        if self.isHidden():
            self._cancel.setEnabled(True)
        self._cancel.setVisible(cancellable)
        self._text.setText(text)
        self._bar.setRange(0, 0 if share is None else _STEPS)
        if share is not None:
            self._bar.setValue(round(share * _STEPS))
        self._left.setText("" if seconds_left is None else self._said(seconds_left))
        self.show()

    def finish(self) -> None:
        """Nothing runs any more."""
        self.hide()

    def _stop(self) -> None:
        self._cancel.setEnabled(False)
        self._left.setText(self.tr("stopping"))
        self.cancelled.emit()

    def _said(self, seconds: float) -> str:
        minutes, rest = divmod(max(0, round(seconds)), 60)
        if minutes:
            return self.tr("{0} min {1:02d} s left").format(minutes, rest)
        return self.tr("{0} s left").format(rest)
