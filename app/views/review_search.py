"""Looking for suspicions off the GUI thread: a moment after the last edit, the newest wins."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from app.background import Job, Progress
from app.presenters.words import tr
from tracking.review import Suspicion
from tracking.review.searching import find_suspicions
from tracking.tracks import Labels, Run, TrackTable

Subject = Callable[[], tuple[TrackTable, Run | None, Labels]]
"""A copy of the tracks to look through, the run they come from, the labels."""

_QUIET_MS = 700


class ReviewSearch(QObject):
    """Finds suspicions in the background; asked for again meanwhile, it begins anew.

    Signals: `found(suspicions)`, a tuple; `changed()`, `doing` is another; `failed(error)`.
    """

    found = Signal(object)
    changed = Signal()
    failed = Signal(object)

    def __init__(self, subject: Subject, fps: float, view: Any, parent: QObject) -> None:
        """`subject` is asked when a search begins; `view` is the camera over its floor, or None."""
        super().__init__(parent)
        self.doing = ""
        self._subject = subject
        self._fps, self._view = fps, view
        self._job: Job | None = None
        self._again = False
        self._waiting = QTimer(self, singleShot=True, interval=_QUIET_MS)
        self._waiting.timeout.connect(self._begin)

    def look(self, at_once: bool = False) -> None:
        """Look through the tracks as they are by then, once nothing was asked for a moment."""
        if self._job is not None:
            self._again = True
            self._job.cancel()
        self._waiting.start(0 if at_once else _QUIET_MS)

    def stop(self) -> None:
        """Look no further; nothing is found any more of what was asked."""
        self._waiting.stop()
        self._again = False
        if self._job is not None:
            job, self._job = self._job, None
            job.blockSignals(True)
            job.cancel()
            job.wait()
            job.deleteLater()
        self._tell("")

    def _begin(self) -> None:
        if self._job is not None:
            return  # it begins when the one at work has let go
        self._again = False
        table, run, labels = self._subject()
        fps, view = self._fps, self._view

        def work(progress: Progress) -> tuple[Suspicion, ...]:
            return find_suspicions(table, run, fps, labels, view, progress)

        job = Job("suspicions", work, self)
        job.progressed.connect(self._show)
        job.done.connect(lambda found: self._end(lambda: self.found.emit(found)))
        job.failed.connect(lambda error: self._end(lambda: self.failed.emit(error)))
        job.cancelled.connect(lambda: self._end(lambda: None))
        self._job = job
        self._tell(tr("Looking for what may be wrong..."))
        job.start()

    def _show(self, done: int, total: int) -> None:
        if total > 0 and self._job is not None:
            share = 100 * done // total
            self._tell(tr("Looking for what may be wrong... {share} %", share=share))

    def _end(self, tell: Callable[[], None]) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        if self._again:
            if not self._waiting.isActive():
                self._begin()
            return
        self._tell("")
        tell()

    def _tell(self, doing: str) -> None:
        if doing != self.doing:
            self.doing = doing
            self.changed.emit()
