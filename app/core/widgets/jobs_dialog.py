"""The list of jobs, and the button in the line at the window's lower edge that opens it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QGridLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import count_text, tr
from app.core.jobs.job_list import JobLine, JobList, JobState
from app.core.keymap import in_brackets
from app.core.widgets.parts import quiet
from app.core.widgets.progress_strip import time_left_text

_STEPS = 1000
_LETTERS, _LINES = 80, 26
_DRAW_EVERY_MS = 200


class JobsButton(QToolButton):
    """Says how many jobs run; hidden until the first one has.

    Signals: `drawn()`, it may be wider by now.
    """

    drawn = Signal()

    def __init__(self, jobs: JobList, parent: QWidget) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setProperty("outlined", True)
        self.setAccessibleName(tr("List of jobs"))
        self._drawing = QTimer(self, singleShot=True, interval=_DRAW_EVERY_MS)
        self._drawing.timeout.connect(self._draw)
        jobs.changed.connect(lambda: self._drawing.isActive() or self._drawing.start())
        self.hide()

    def _draw(self) -> None:
        running, lines = self._jobs.running, self._jobs.lines
        self.setVisible(bool(lines))
        self.setToolTip(
            tr("List what runs, and what came of what ended") + in_brackets("view.jobs")
        )
        self.setText(_running_text(running) if running else tr("Jobs"))
        self.drawn.emit()


def _running_text(running: Sequence[JobLine]) -> str:
    """How many run, and how far the one is that has most before it."""
    text = count_text(len(running), "{n} job running", "{n} jobs running")
    shares = [one.share for one in running if one.share is not None]
    return f"{text}, {round(100 * min(shares))} %" if shares else text


class JobsDialog(QDialog):
    """Lists what runs and what ended, with Cancel and Open.

    Signals:
        open_asked(object): the file or folder that came of a job.
    """

    open_asked = Signal(object)

    def __init__(self, jobs: JobList, parent: QWidget) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._rows: dict[int, _Row] = {}
        self.setWindowTitle(tr("List of jobs"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        letters = self.fontMetrics()
        self.resize(_LETTERS * letters.averageCharWidth(), _LINES * letters.lineSpacing())
        column = QVBoxLayout(self)
        self._nothing = quiet(tr("No jobs yet: work of more than a second stands here"), self)
        column.addWidget(self._nothing)
        column.addWidget(self._scrolled(), 1)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        self._clear = QPushButton(tr("Clear finished"), self)
        self._clear.clicked.connect(jobs.forget)
        buttons.addButton(self._clear, QDialogButtonBox.ButtonRole.ActionRole)
        buttons.rejected.connect(self.reject)
        column.addWidget(buttons)
        self._drawing = QTimer(self, singleShot=True, interval=_DRAW_EVERY_MS)
        self._drawing.timeout.connect(self._draw)
        jobs.changed.connect(self._draw_soon)
        self._draw()

    def _scrolled(self) -> QScrollArea:
        area, held = QScrollArea(self), QWidget(self)
        area.setWidgetResizable(True)
        area.setFrameShape(QScrollArea.Shape.NoFrame)
        area.setAccessibleName(tr("List of jobs"))
        area.setWidget(held)
        self._list = QVBoxLayout(held)
        self._list.setContentsMargins(0, 0, 0, 0)
        self._list.addStretch(1)
        return area

    def _draw_soon(self) -> None:
        if not self._drawing.isActive():
            self._drawing.start()

    def _draw(self) -> None:
        lines = self._jobs.lines
        self._nothing.setVisible(not lines)
        self._clear.setEnabled(any(not one.runs for one in lines))
        for number in self._rows.keys() - {one.number for one in lines}:
            self._rows.pop(number).deleteLater()
        for at, line in enumerate(lines):
            if line.number not in self._rows:
                self._rows[line.number] = _Row(self.open_asked.emit, self)
            row = self._rows[line.number]
            row.show_line(line)
            if self._list.indexOf(row) != at:
                self._list.insertWidget(at, row)


class _Row(QWidget):
    """One job: what, how far, Cancel while it runs, Open where something came of it."""

    def __init__(self, open_place: Callable[[Path], object], parent: QWidget) -> None:
        super().__init__(parent)
        self._open_place = open_place
        self._line: JobLine | None = None
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 4, 0, 4)
        self._title, self._word = QLabel(self), quiet("", self)
        for label in (self._title, self._word):
            label.setTextFormat(Qt.TextFormat.PlainText)
            label.setWordWrap(True)
        self._bar = QProgressBar(self)
        self._bar.setTextVisible(False)
        self._cancel, self._open = QPushButton(tr("Cancel"), self), QPushButton(tr("Open"), self)
        self._again = QPushButton(tr("Start again"), self)
        self._again.clicked.connect(self._start_again)
        self._cancel.clicked.connect(self._stop)
        self._keep = QPushButton(tr("Stop, keep the result"), self)
        self._keep.clicked.connect(self._stop_and_keep)
        self._open.clicked.connect(self._show_place)
        grid.addWidget(self._title, 0, 0)
        grid.addWidget(self._bar, 1, 0)
        grid.addWidget(self._word, 2, 0)
        grid.addWidget(self._cancel, 0, 1, 3, 1)
        grid.addWidget(self._again, 0, 1, 3, 1)
        grid.addWidget(self._open, 0, 2, 3, 1)
        grid.addWidget(self._keep, 0, 2, 3, 1)
        grid.setColumnStretch(0, 1)

    def show_line(self, line: JobLine) -> None:
        """Show how far it is, or how it ended."""
        before, self._line = self._line, line
        if before is None:
            self._title.setText(line.title)
            self._bar.setAccessibleName(tr("Progress of: {title}", title=line.title))
            self._cancel.setAccessibleName(tr("Cancel: {title}", title=line.title))
            self._keep.setAccessibleName(tr("Stop, keep the result of: {title}", title=line.title))
            self._open.setAccessibleName(tr("Open what came of: {title}", title=line.title))
            self._again.setAccessibleName(tr("Start again: {title}", title=line.title))
        self._bar.setVisible(line.runs)
        self._bar.setRange(0, 0 if line.share is None else _STEPS)
        if line.share is not None:
            self._bar.setValue(round(line.share * _STEPS))
        self._cancel.setVisible(line.cancel is not None)
        self._keep.setVisible(line.keep is not None)
        self._open.setVisible(line.place is not None)
        self._again.setVisible(line.again is not None)
        self._word.setText(_word_of(line))

    def _stop(self) -> None:
        self._cancel.setEnabled(False)
        if self._line is not None and self._line.cancel is not None:
            self._line.cancel()

    def _stop_and_keep(self) -> None:
        self._keep.setEnabled(False)  # Cancel stays, should stopping take long
        if self._line is not None and self._line.keep is not None:
            self._line.keep()

    def _start_again(self) -> None:
        self._again.setEnabled(False)
        if self._line is not None and self._line.again is not None:
            self._line.again()

    def _show_place(self) -> None:
        if self._line is not None and self._line.place is not None:
            self._open_place(self._line.place)


def _word_of(line: JobLine) -> str:
    if line.runs:
        return time_left_text(line.seconds_left) or tr("Running")
    if line.state is JobState.STOPPED:
        return tr("Stopped")
    if line.state is JobState.FAILED:
        return tr("Failed: {why}", why=line.word)
    return tr("Done: {path}", path=line.place) if line.place is not None else tr("Done")
