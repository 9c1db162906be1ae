"""Long work: one job at a time, with its progress and Cancel, the window alive."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.core.i18n import tr
from app.core.jobs.jobs import Job, Progress
from app.core.widgets.progress_strip import ProgressStrip

_TELL_LEFT_AFTER_S = 1.0


class Work(QObject):
    """Runs jobs and shows them on a strip.

    Signals: `changed()`, a job began or ended; `succeeded()`, one did what it should, and what
    comes of it is shown next; `failed(error)`; `said(text)`.
    """

    changed = Signal()
    succeeded = Signal()
    failed = Signal(object)
    said = Signal(str)

    def __init__(self, strip: ProgressStrip, parent: QObject) -> None:
        super().__init__(parent)
        self._strip = strip
        self._job: Job | None = None
        self._cancellable = True

    @property
    def busy(self) -> bool:
        """Whether a job runs."""
        return self._job is not None

    def refuses(self) -> bool:
        """Whether other work must end before any begins; if so, it is said."""
        if self.busy:
            self.said.emit(tr("Wait until the work in progress is done"))
        return self.busy

    def run(
        self,
        title: str,
        work: Callable[[Progress], Any],
        done: Callable[[Any], None],
        undone: Callable[[], None] | None = None,
        cancellable: bool = True,
    ) -> None:
        """Do `work(progress)` in the background, then `done(its result)` here.

        Where it fails or is cancelled, `undone()` is called instead; Cancel is offered where the
        work is `cancellable`. While another job runs nothing is begun; commands are disabled then.
        """
        if self.refuses():
            return
        job = Job(title, work, self)
        job.progressed.connect(self._show)
        job.done.connect(lambda result: self._end(self.succeeded.emit, lambda: done(result)))
        job.failed.connect(lambda error: self._end(undone, lambda: self.failed.emit(error)))
        stopped = tr("Stopped: {title}", title=title)
        job.cancelled.connect(lambda: self._end(undone, lambda: self.said.emit(stopped)))
        self._job, self._cancellable = job, cancellable
        # Other work that is stopping may still stand there, with buttons that cannot be pressed.
        self._strip.finish()
        self._strip.show_scene(title, None, cancellable=cancellable)
        job.start()
        self.changed.emit()

    def cancel(self) -> None:
        """Ask the job to stop."""
        if self._job is not None:
            self._job.cancel()

    def close(self) -> None:
        """Stop and wait; nothing is reported any more."""
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()
            self._strip.finish()

    def _show(self, done: int, total: int) -> None:
        if self._job is None or total <= 0:
            return
        passed_s = time.monotonic() - self._job.started_s
        left = passed_s * (total - done) / done if done and passed_s > _TELL_LEFT_AFTER_S else None
        self._strip.show_scene(self._job.title, done / total, left, self._cancellable)

    def _end(self, *then: Callable[[], object] | None) -> None:
        """Let the job go first: what comes then may begin another one."""
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
            self._strip.finish()
        for step in then:
            if step is not None:
                step()
        self.changed.emit()
