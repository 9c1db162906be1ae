"""Working out what is shown off the GUI thread, a moment after the last change: newest wins."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from app.core.jobs.jobs import Job
from tracking.progress import Progress

Work = Callable[[Progress], Any]
_QUIET_MS = 80


class LatestJob(QObject):
    """Works one subject out at a time; asked for another meanwhile, it goes on with the newest.

    A subject is a value: two that are equal come to the same.

    Signals: `found(result)`; `failed(subject, error)`; `changed()`, it is busy or at rest by now;
    `progressed(done, total)`.
    """

    found = Signal(object)
    failed = Signal(object, object)
    changed = Signal()
    progressed = Signal(int, int)

    def __init__(self, title: str, prepare: Callable[[Any], Work], parent: QObject) -> None:
        """`prepare` takes hold of the tracks on this thread; what it gives runs on another."""
        super().__init__(parent)
        self._title, self._prepare = title, prepare
        self._asked: object = None
        self._begun: object = None
        self._job: Job | None = None
        self._waiting = QTimer(self, singleShot=True, interval=_QUIET_MS)
        self._waiting.timeout.connect(self._begin)

    @property
    def busy(self) -> bool:
        """Whether it works, or is about to."""
        return self._job is not None or self._waiting.isActive()

    def ask(self, subject: object) -> None:
        """Work this out; nothing happens where it was asked for last."""
        if subject == self._asked:
            return
        self._asked = subject
        if self._job is None and not self._waiting.isActive():
            self._waiting.start()
            self.changed.emit()

    def stop(self) -> None:
        """Go on no further; what is in work ends by itself, and nobody is told."""
        self._waiting.stop()
        self._asked = None
        if self._job is not None:
            job, self._job = self._job, None
            job.leave_untold()

    def _begin(self) -> None:
        subject = self._asked
        if subject is None or self._job is not None:
            return
        self._begun = subject
        work = self._prepare(subject)
        self._job = job = Job(self._title, work, self)
        job.progressed.connect(self.progressed)
        job.done.connect(lambda result: self._end(lambda: self.found.emit(result)))
        job.failed.connect(lambda error: self._end(lambda: self.failed.emit(subject, error)))
        job.start()

    def _end(self, tell: Callable[[], None]) -> None:
        """Tell also what is out of date by now: while people are tracked everything always is."""
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        if self._asked != self._begun:
            self._waiting.start()
        tell()
        self.changed.emit()
