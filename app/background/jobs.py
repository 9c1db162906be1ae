"""One piece of long work with progress and cancel."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

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
    """

    progressed = Signal(int, int)
    done = Signal(object)
    failed = Signal(object)
    cancelled = Signal()
    _finished = Signal(object, object)

    def __init__(self, title: str, work: Callable[[Progress], Any], parent: QObject) -> None:
        super().__init__(parent)
        self.title = title
        self.started_s = time.monotonic()
        self._work = work
        self._progress = Progress(self.progressed.emit)
        self._thread = threading.Thread(target=self._run, name=f"job {title}", daemon=True)
        self._finished.connect(self._report, Qt.ConnectionType.QueuedConnection)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def cancel(self) -> None:
        """Ask the work to stop; `cancelled` follows once it has."""
        self._progress.cancel()

    def wait(self) -> None:
        """Block until the thread has ended; for the end of the program and for tests."""
        if self._thread.is_alive():
            self._thread.join()

    def _run(self) -> None:
        try:
            result, error = self._work(self._progress), None
        except Exception as problem:
            result, error = None, problem
        self._finished.emit(result, error)

    def _report(self, result: object, error: Exception | None) -> None:
        self._thread.join()
        if error is None:
            self.done.emit(result)
        elif isinstance(error, CancelledError):
            self.cancelled.emit()
        else:
            _log.info("%s failed: %s", self.title, error)
            self.failed.emit(error)
