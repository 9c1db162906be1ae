"""Long work: with its progress and Cancel, the window alive; one at a time, or behind all else."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.jobs.job_list import JobList, JobState
from app.core.jobs.jobs import Job, Progress
from app.core.widgets.progress_strip import ProgressStrip

_TELL_LEFT_AFTER_S = 1.0


class Work(QObject):
    """Runs jobs and shows them on a strip; all of them stand in a list.

    Signals: `changed()`, a job began or ended; `succeeded()`, one did what it should, and what
    comes of it is shown next; `failed(error)`; `said(text)`; `ended(text, place)`, one that ran
    behind has come to its end, and the `Path` that came of it, or None.

    Attributes:
        jobs: all work, that of others too.
    """

    changed = Signal()
    succeeded = Signal()
    failed = Signal(object)
    said = Signal(str)
    ended = Signal(str, object)

    def __init__(self, strip: ProgressStrip, parent: QObject) -> None:
        super().__init__(parent)
        self._strip = strip
        self.jobs = JobList(parent)  # where whatever belongs to the window finds it
        self.jobs.told.connect(self.said)
        self._job: Job | None = None
        self._number = 0
        self._behind: dict[int, Job] = {}
        self._cancellable = True

    @property
    def busy(self) -> bool:
        """Whether a job runs that all else waits for."""
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
        place: Path | None = None,
    ) -> None:
        """Do `work(progress)` in the background, then `done(its result)` here.

        Where it fails or is cancelled, `undone()` is called instead; Cancel is offered where the
        work is `cancellable`. While another job runs nothing is begun; commands are disabled then.
        `place`: what comes of it, for the list.
        """
        if self.refuses():
            return
        job = Job(title, work, self, listed=False)
        number = self._number = self.jobs.begin(title, self.cancel if cancellable else None)
        self._list_end(job, number, place)
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

    def run_behind(
        self,
        title: str,
        work: Callable[[Progress], Any],
        told: str,
        place: Path | None = None,
    ) -> None:
        """Do `work(progress)` behind all else, which goes on; it stands in the list.

        What it works on must be its own. `told`: what is said at its end, with `place`, what came
        of it.
        """
        job = Job(title, work, self, listed=False)
        number = self.jobs.begin(title, job.cancel)
        self._behind[number] = job
        job.progressed.connect(lambda done, total: self.jobs.progress(number, done, total))
        self._list_end(job, number, place)
        job.done.connect(lambda _: self._end_behind(number, lambda: self.ended.emit(told, place)))
        job.failed.connect(lambda error: self._end_behind(number, lambda: self.failed.emit(error)))
        stopped = tr("Stopped: {title}", title=title)
        job.cancelled.connect(lambda: self._end_behind(number, lambda: self.said.emit(stopped)))
        job.start()
        self.changed.emit()

    def cancel(self) -> None:
        """Ask the job that all else waits for to stop."""
        if self._job is not None:
            self._job.cancel()

    def leave_behind(self) -> None:
        """Stop what runs behind, and wait: what it works on goes. It is said what was stopped."""
        for number, job in list(self._behind.items()):
            self._end_behind(number, job.end_untold, delete=False)
            self.jobs.end(number, JobState.STOPPED)
            self.said.emit(tr("Stopped: {title}", title=job.title))

    def close(self) -> None:
        """Stop and wait; nothing is reported any more."""
        self.blockSignals(True)
        self.leave_behind()
        self.blockSignals(False)
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()
            self.jobs.end(self._number, JobState.STOPPED)
            self._strip.finish()

    def _list_end(self, job: Job, number: int, place: Path | None) -> None:
        """Have the list know how it ended, before anybody else does."""
        jobs = self.jobs
        job.done.connect(lambda _: jobs.end(number, JobState.DONE, place))
        job.cancelled.connect(lambda: jobs.end(number, JobState.STOPPED))
        job.failed.connect(lambda error: jobs.end(number, JobState.FAILED, word=explain(error)))

    def _show(self, done: int, total: int) -> None:
        if self._job is None or total <= 0:
            return
        self.jobs.progress(self._number, done, total)
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

    def _end_behind(self, number: int, then: Callable[[], object], delete: bool = True) -> None:
        job = self._behind.pop(number, None)
        if job is not None and delete:
            job.deleteLater()
        then()
        self.changed.emit()
