"""Long work: what, how far, how long still, Stop where that leaves a result, Cancel."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal, SignalInstance
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QProgressBar, QPushButton, QWidget

from app.core.i18n import tr

_STEPS = 1000
_UNLIMITED = 2**24 - 1


class ProgressStrip(QFrame):
    """A line at the window's lower edge, hidden while nothing runs.

    Signals:
        cancelled(): Cancel was pressed: nothing of it is kept.
        stopped(): it is to end, and what there is by now to be kept.
    """

    cancelled = Signal()
    stopped = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("bar", True)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 0, 12, 0)  # the window's line has margins of its own
        row.setSpacing(12)
        self._text = QLabel(self)
        self._bar = QProgressBar(self)
        self._bar.setTextVisible(False)
        self._bar.setAccessibleName(tr("Progress"))
        self._left = QLabel(self)
        self._left.setProperty("role", "muted")
        self._stop = QPushButton(tr("Stop, keep the result"), self)
        self._stop.setAccessibleName(tr("Stop the running work and keep the result so far"))
        self._stop.clicked.connect(lambda: self._end(self.stopped))
        self._cancel = QPushButton(tr("Cancel"), self)
        self._cancel.setAccessibleName(tr("Cancel the running work and keep nothing"))
        self._cancel.clicked.connect(lambda: self._end(self.cancelled))
        for button in (self._stop, self._cancel):
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        for widget, share in ((self._text, 0), (self._bar, 1), (self._left, 0)):
            row.addWidget(widget, share)
        row.addWidget(self._stop)
        row.addWidget(self._cancel)
        self._stopping = False
        self.hide()

    def give_way(self, words_px: int, line_px: int) -> None:
        """Leave so much of a line to words, but keep a third of it; 0: there are no words."""
        room = max(line_px - words_px, line_px // 3)
        self.setMaximumWidth(room if words_px else _UNLIMITED)

    def show_scene(
        self,
        text: str,
        share: float | None,
        seconds_left: float | None = None,
        cancellable: bool = True,
        stoppable: bool = False,
        stopping: bool = False,
    ) -> None:
        """Show work; `share` done is 0..1, None where the end is not known.

        What is `stoppable` can end early with a result, what is `cancellable` without. What is
        `stopping` was asked to end, here or elsewhere, and is shown so until it has ended.
        """
        if self.isHidden():
            self._let_end(True)
        if stopping:
            self._let_end(False)
        self._cancel.setVisible(cancellable)
        self._stop.setVisible(stoppable)
        self._text.setText(text)
        self._bar.setRange(0, 0 if share is None else _STEPS)
        if share is not None:
            self._bar.setValue(round(share * _STEPS))
        self._left.setText(self._said(seconds_left))
        self.show()

    def finish(self) -> None:
        """Nothing runs any more."""
        self.hide()

    def _let_end(self, may: bool) -> None:
        self._stopping = not may
        for button in (self._stop, self._cancel):
            button.setEnabled(may)

    def _end(self, how: SignalInstance) -> None:
        self._let_end(False)
        self._left.setText(self._said(None))
        how.emit()

    def _said(self, seconds: float | None) -> str:
        if self._stopping:
            return tr("Stopping...")
        return time_left_text(seconds)


def time_left_text(seconds: float | None) -> str:
    """How long it will still take, in words; "" where that is not known."""
    if seconds is None:
        return ""
    minutes, rest = divmod(max(0, round(seconds)), 60)
    if minutes:
        return tr("{0} min {1:02d} s left").format(minutes, rest)
    return tr("{0} s left").format(rest)
