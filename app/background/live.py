"""A tracker at work while the footage plays."""

from __future__ import annotations

import logging
import threading
import time
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from tracking.pipeline import track
from tracking.recording import Recording
from tracking.trackers import StepResult
from tracking.tracks import Run

_log = logging.getLogger(__name__)
_BATCH_EVERY_S = 0.04


class LiveTracker(QObject):
    """Runs a tracker over a recording in a thread.

    Results come in order: `tracked(results)` carries a tuple of `StepResult`. At the end, or once
    stopped, `finished(run)` carries the run over the frames that were tracked (None where there
    were none); `failed(error)` comes instead where the tracker could not go on.
    """

    tracked = Signal(object)
    finished = Signal(object)
    failed = Signal(object)
    _ended = Signal(object, object)

    def __init__(
        self, recording: Recording, tracker: str, settings: Any, seed: int, parent: QObject
    ) -> None:
        super().__init__(parent)
        self.tracker = tracker
        self._recording = recording
        self._settings = settings
        self._seed = seed
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, name="live tracker", daemon=True)
        self._ended.connect(self._report, Qt.ConnectionType.QueuedConnection)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def stop(self) -> None:
        """Ask for the end after the frame in work; what was tracked comes with `finished`."""
        self._stop.set()

    def close(self) -> None:
        """Stop and wait for the thread; nothing is reported any more."""
        self._ended.disconnect(self._report)
        self.stop()
        if self._thread.is_alive():
            self._thread.join()

    def _run(self) -> None:
        run: Run | None = None
        problem: Exception | None = None
        try:
            run = self._track()
        except Exception as error:
            problem = error
        self._ended.emit(run, problem)

    def _track(self) -> Run | None:
        tracking = track(self._recording, self.tracker, self._settings, self._seed)
        batch: list[StepResult] = []
        sent_s = time.monotonic()
        anything = False
        try:
            for result in tracking:
                anything = True
                batch.append(result)
                if time.monotonic() - sent_s >= _BATCH_EVERY_S:
                    self.tracked.emit(tuple(batch))
                    batch, sent_s = [], time.monotonic()
                if self._stop.is_set():
                    break
            self.tracked.emit(tuple(batch))
            return tracking.run() if anything else None
        finally:
            tracking.close()

    def _report(self, run: Run | None, problem: Exception | None) -> None:
        self._thread.join()
        if problem is not None:
            _log.info("tracking failed: %s", problem)
            self.failed.emit(problem)
        else:
            self.finished.emit(run)
