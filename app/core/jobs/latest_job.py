"""Working out what is shown off the GUI thread, a moment after the last change: newest wins."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from app.core.jobs.jobs import Job
from app.core.jobs.listed_job import ListedJob, cancelled_error
from tracking.progress import Progress

Work = Callable[[Progress], Any]
_QUIET_MS = 80


class LatestJob(QObject):
    """Works one subject out at a time; asked for another meanwhile, it goes on with the newest.

    A subject is a value: two that are equal come to the same. One line in the list of the window's
    work stands for it, however often it begins anew. What the user cancels there is not begun
    again by asking for the same: the list offers that.

    Signals: `found(result)`; `failed(subject, error)`; `cancelled(subject, error)`, with the words
    to show in place of a result; `changed()`, it is busy or at rest by now;
    `progressed(done, total)`.
    """

    found = Signal(object)
    failed = Signal(object, object)
    cancelled = Signal(object, object)
    changed = Signal()
    progressed = Signal(int, int)

    def __init__(
        self,
        title: str,
        prepare: Callable[[Any], Work],
        parent: QObject,
        *,
        listed: bool = True,
        cancellable: bool = True,
    ) -> None:
        """One at rest.

        Args:
            title: as people read it, if it is `listed`.
            prepare: takes hold of the tracks on this thread; what it gives runs on another.
            listed: False for work of a moment. cancellable: see `Job`.
        """
        super().__init__(parent)
        cancel = self._cancel if cancellable else None
        self._listed = ListedJob(title, self if listed else None, cancel)
        self._listed.drop_with(self)
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

    def again(self) -> None:
        """Work out once more what was asked for last."""
        if not self.busy and self._asked is not None:
            self._waiting.start()
            self.changed.emit()

    def stop(self) -> None:
        """Go on no further; what is in work ends by itself, and nobody is told."""
        self._waiting.stop()
        self._asked = None
        if self._job is not None:
            job, self._job = self._job, None
            job.leave_untold()
        self._listed.drop()

    def _cancel(self) -> None:
        self._waiting.stop()
        if self._job is not None:
            self._job.cancel()
        else:
            self._end_cancelled()

    def _begin(self) -> None:
        subject = self._asked
        if subject is None or self._job is not None:
            return
        self._begun = subject
        work = self._prepare(subject)
        self._listed.begin()
        self._job = job = Job(self._title, work, self, listed=False)
        job.progressed.connect(self._progress)
        job.done.connect(lambda result: self._end(lambda: self.found.emit(result)))
        job.failed.connect(lambda error: self._end(lambda: self.failed.emit(subject, error), error))
        job.cancelled.connect(self._end_cancelled)
        job.start()

    def _progress(self, done: int, total: int) -> None:
        self._listed.progress(done, total)
        self.progressed.emit(done, total)

    def _end(self, tell: Callable[[], None], error: Exception | None = None) -> None:
        """Tell also what is out of date by now: while people are tracked everything always is."""
        self._forget_job()
        if self._asked != self._begun:
            self._waiting.start()
        elif error is None:
            self._listed.done()
        else:
            self._listed.failed(error)
        tell()
        self.changed.emit()

    def _end_cancelled(self) -> None:
        """The user cancelled it, and with it what was asked for meanwhile."""
        self._forget_job()
        self._listed.stopped(self.again)
        self.cancelled.emit(self._asked, cancelled_error())
        self.changed.emit()

    def _forget_job(self) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
