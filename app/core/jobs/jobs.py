"""One piece of long work with progress and cancel."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from app.core.jobs.listed_job import ListedJob
from tracking.errors import CancelledError

_log = logging.getLogger(__name__)
_REPORT_EVERY_S = 0.05


class Progress:
    """What the work calls to say how far it is; raises `CancelledError` once cancelled."""

    def __init__(self, report: Callable[[int, int], None]) -> None:
        self._report = report
        self._cancelled = threading.Event()
        self._last_s = 0.0

    def __call__(self, done: int, total: int) -> None:
        """Report `done` of `total` steps.

        Raises:
            CancelledError: the user has cancelled.
        """
        if self._cancelled.is_set():
            raise CancelledError("stopped by the user")
        now_s = time.monotonic()
        if done >= total or now_s - self._last_s >= _REPORT_EVERY_S:
            self._last_s = now_s
            self._report(done, total)

    def cancel(self) -> None:
        """Make the next report raise."""
        self._cancelled.set()


class Job(QObject):
    """Runs `work(progress)` in a thread of its own.

    Signals: `progressed(done, total)`; at last exactly one of `done(result)`, `failed(error)` and
    `cancelled()`.

    A job goes with its parent at any moment: its work is then asked to stop, and nobody is told.
    It stands in the list of the window that its parent belongs to, by its title.
    """

    progressed = Signal(int, int)
    done = Signal(object)
    failed = Signal(object)
    cancelled = Signal()

    def __init__(
        self,
        title: str,
        work: Callable[[Progress], Any],
        parent: QObject,
        *,
        listed: bool = True,
        cancellable: bool = True,
    ) -> None:
        """A job at rest.

        Args:
            title: as people read it, if it is `listed`.
            listed: False where somebody else has the list show it, or it is work of a moment.
            cancellable: whether the list offers Cancel: the work must report how far it is.
        """
        super().__init__(parent)
        self.title = title
        self.started_s = time.monotonic()
        self._work = _Work(title, work)
        self._work.progressed.connect(self.progressed)
        self._work.ended.connect(self._report)
        cancel = self.cancel if cancellable else None
        self._listed = ListedJob(title, parent if listed else None, cancel)
        self.progressed.connect(self._listed.progress)
        self._listed.drop_with(self)
        self.destroyed.connect(partial(Progress.cancel, self._work.progress))  # as in `drop_with`

    def start(self) -> None:
        """Begin."""
        self._listed.begin()
        self._work.start()

    def cancel(self) -> None:
        """Ask the work to stop; `cancelled` follows once it has."""
        self._work.progress.cancel()

    def wait(self) -> None:
        """Block until the thread has ended; for the end of the program and for tests."""
        self._work.wait()

    def end_untold(self) -> None:
        """Stop, and block until the thread has ended; nobody is told anything."""
        self._go_untold()
        self.wait()

    def leave_untold(self) -> None:
        """Ask the work to stop, and let it end by itself; nobody is told anything."""
        self._go_untold()

    def _go_untold(self) -> None:
        self.blockSignals(True)
        self._listed.drop()
        self.cancel()
        self.deleteLater()

    def _report(self, result: object, error: Exception | None) -> None:
        if error is None:
            self._listed.done()
            self.done.emit(result)
        elif isinstance(error, CancelledError):
            self._listed.stopped()
            self.cancelled.emit()
        else:
            _log.info("%s failed: %s", self.title, error)
            self._listed.failed(error)
            self.failed.emit(error)


class _Work(QObject):
    """What the thread of a job talks to: it belongs to nobody, so nobody destroys it meanwhile.

    It stays until its thread has ended and that has been told, in the thread it was made in.
    """

    progressed = Signal(int, int)
    ended = Signal(object, object)
    _left = Signal(object, object)

    def __init__(self, title: str, work: Callable[[Progress], Any]) -> None:
        super().__init__()
        self.progress = Progress(self.progressed.emit)
        self._work = work
        self._thread = threading.Thread(target=self._run, name=f"job {title}", daemon=True)
        self._left.connect(self._tell, Qt.ConnectionType.QueuedConnection)

    def start(self) -> None:
        _at_work.add(self)
        self._thread.start()

    def wait(self) -> None:
        if self._thread.is_alive():
            self._thread.join()

    def _run(self) -> None:
        try:
            result, error = self._work(self.progress), None
        except Exception as problem:
            result, error = None, problem
        self._left.emit(result, error)

    def _tell(self, result: object, error: Exception | None) -> None:
        self._thread.join()
        _at_work.discard(self)
        self.ended.emit(result, error)


_at_work: set[_Work] = set()
"""Only touched in the thread of the window."""
