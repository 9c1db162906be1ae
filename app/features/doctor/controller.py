"""Examines a recording in the background, mends what is asked for, and takes it back."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.jobs.jobs import Job
from app.features.doctor import presenter
from app.features.doctor.dialog import DoctorDialog
from app.features.doctor.presenter import Place
from app.features.doctor.scene import DoctorScene
from tracking.doctor import Examination, Mended
from tracking.progress import Progress

_SOONEST_S = 0.5
"""Before that, what is left cannot be told from what was done."""


class DoctorController(QObject):
    """The page of one recording.

    Args:
        place: where the recording is opened. name: its name.

    Signals: `closed(changed, problem)`, the page has gone, and what it was writing is written;
    whether the recording's files are others now, and why the last mend failed ("": it did not).
    """

    closed = Signal(bool, str)

    def __init__(self, place: Place, name: str, window: QWidget) -> None:
        super().__init__(window)
        self._place = place
        self._job: Job | None = None
        self._is_writing = self._is_closed = False
        self._problem = ""
        self._examination: Examination | None = None
        self._mends: list[tuple[str, Mended]] = []
        self.dialog = DoctorDialog(name, window)
        self.dialog.check_asked.connect(self.check)
        self.dialog.cancel_asked.connect(self._cancel)
        self.dialog.mend_asked.connect(self._mend)
        self.dialog.undo_asked.connect(self._undo)
        self.dialog.finished.connect(self._close)

    def open(self) -> None:
        """Show the page, and begin."""
        self.dialog.open()
        self.check()

    def check(self) -> None:
        """Examine the recording as its files are now."""
        self._work(
            tr("Checking the recording"), lambda tell: presenter.examined(self._place, tell),
            self._take,
        )  # fmt: skip

    def end(self) -> None:
        """End with the window: what is being written is waited for, and nobody is told."""
        if self._job is None:
            return
        job, self._job = self._job, None
        if self._is_writing:
            job.end_untold()
        else:
            job.leave_untold()

    def _take(self, examination: Examination) -> None:
        self._examination = examination
        self._show(presenter.scene_of(examination, self._mended_last))

    @property
    def _mended_last(self) -> str:
        return tr("Mended: {title}", title=self._mends[-1][0]) if self._mends else ""

    def _mend(self, code: str) -> None:
        found = self._examination.findings if self._examination is not None else ()
        finding = next((one for one in found if one.code == code), None)
        if finding is None:
            return

        def done(files: Mended) -> None:
            self._mends.append((tr(finding.title), files))
            self.check()

        mend = partial(presenter.mended, self._place, finding)
        self._work(tr("Mending"), lambda _: mend(), done, writes=True)

    def _undo(self) -> None:
        if not self._mends:
            return

        def done(_: object) -> None:
            self._mends.pop()
            self.check()

        files = self._mends[-1][1]
        self._work(tr("Undoing the mend"), lambda _: presenter.undone(files), done, writes=True)

    def _work(
        self,
        title: str,
        work: Callable[[Progress], Any],
        done: Callable[[Any], None],
        *,
        writes: bool = False,
    ) -> None:
        """Do something beside the window; its progress is shown, and what it ends with."""
        if self._job is not None or self._is_closed:
            return
        self._is_writing = writes
        began_s = time.monotonic()
        self._show(presenter.working())
        self.dialog.show_progress(title, None, None)
        self._job = job = Job(title, work, self, cancellable=not writes)
        job.progressed.connect(lambda n, total: self._tell(title, n / max(total, 1), began_s))
        job.done.connect(lambda result: self._end(lambda: done(result)))
        job.failed.connect(lambda error: self._end(lambda: self._fail(error)))
        job.cancelled.connect(lambda: self._end(lambda: self._show(presenter.cancelled())))
        job.start()

    def _tell(self, title: str, share: float, began_s: float) -> None:
        if self._is_closed:
            return
        spent_s = time.monotonic() - began_s
        known = share > 0.0 and spent_s >= _SOONEST_S
        left_s = spent_s * (1.0 - share) / share if known else None
        self.dialog.show_progress(title, share, left_s)

    def _fail(self, error: Exception) -> None:
        self._problem = explain(error)
        self._show(presenter.failed(self._problem))

    def _end(self, then: Callable[[], None]) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        then()
        if self._is_closed:
            self._leave()

    def _show(self, scene: DoctorScene) -> None:
        if not self._is_closed:
            self.dialog.show_scene(scene)

    def _cancel(self) -> None:
        if self._job is not None:
            self._job.cancel()

    def _close(self) -> None:
        """A check is left to end by itself; a mend is to end first, as its files count."""
        self._is_closed, self._problem = True, ""
        if self._job is not None and self._is_writing:
            return
        self.end()
        self._leave()

    def _leave(self) -> None:
        self.closed.emit(bool(self._mends), self._problem)
        self.deleteLater()
