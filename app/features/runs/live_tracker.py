"""A tracker at work while the footage plays."""

from __future__ import annotations

import logging
import threading
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from app.core.error_messages import explain
from app.core.i18n import strip_full_stop
from app.core.tracking_process import TrackerProcess, TrackingRequest
from app.features.runs.run_summary import RunSummary
from tracking.pipeline import KeptSteps
from tracking.pipeline.nobody_found import why_nobody
from tracking.recording import Recording
from tracking.trackers import Resume
from tracking.tracks import Run
from tracking.translation import Message

_log = logging.getLogger(__name__)
_MOST_AHEAD = 50
"""Batches on their way to a window that is busy: then the tracker waits, so that they stay few."""
_LOOK_EVERY_S = 0.1
"""How soon a tracker that waits notices that it is closed."""


class LiveTracker(QObject):
    """Runs a tracker over a recording in a process of its own.

    A thread here only waits for what it says: the interpreter belongs to the window. First
    `learning(done, total)` tells how much of the background is read. Results come
    in order: `tracked(results)` carries a tuple of `StepResult`. At the end, or once stopped,
    `finished(run)` carries the run over the frames that were tracked (None where there were none),
    the very same as `pipeline.track` makes. Where the tracker could not go on it comes, too, and
    `run_summary` tells why; `failed(error)` comes instead where nothing can be kept.

    Attributes:
        kept: the steps so far, those not told of yet among them; may be read on any thread.
        run_summary: of the run, once it is made; None before, and where there is none.
    """

    learning = Signal(int, int)
    tracked = Signal(object)
    finished = Signal(object)
    failed = Signal(object)
    _ended = Signal(object, object)

    def __init__(
        self,
        recording: Recording,
        tracker: str,
        settings: Any,
        seed: int,
        parent: QObject,
        frames: tuple[int, int],
        resume: Resume | None = None,
    ) -> None:
        """The arguments of `pipeline.track`; nothing is begun before `start`."""
        super().__init__(parent)
        self.tracker = tracker
        self._recording = recording
        self._request = TrackingRequest.of(recording, tracker, settings, seed, frames, resume)
        self._asked = frames
        self.kept = KeptSteps()
        self.run_summary: RunSummary | None = None
        self._process = TrackerProcess(self._request, self.learning.emit)
        self._room = threading.Semaphore(_MOST_AHEAD)
        self._closed = threading.Event()
        self.tracked.connect(self._make_room, Qt.ConnectionType.QueuedConnection)
        self._thread = threading.Thread(target=self._run, name="live tracker", daemon=True)
        self._ended.connect(self._report, Qt.ConnectionType.QueuedConnection)

    @property
    def notes(self) -> tuple[Message, ...]:
        """What the user should be told of the tracking, a line each; known at its end."""
        return self._process.notes

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def stop(self) -> None:
        """Ask for the end after the frame in work; what was tracked comes with `finished`."""
        self._process.stop()

    def close(self) -> None:
        """End the process and the thread; nothing is reported any more."""
        self._ended.disconnect(self._report)
        self._closed.set()
        self._process.kill()
        if self._thread.is_alive():
            self._thread.join()

    def _run(self) -> None:
        run: Run | None = None
        problem: Exception | None = None
        try:
            run = self._track()
        except Exception as error:
            problem = error
            run = None if self._closed.is_set() else self._run_so_far(error)
        self._ended.emit(run, None if run is not None else problem)

    def _track(self) -> Run | None:
        for batch in self._process.batches():
            while not self._room.acquire(timeout=_LOOK_EVERY_S):
                if self._closed.is_set():
                    return None
            self.kept.add(batch)
            self.tracked.emit(batch)
        first, stop = self.kept.frames
        if first == stop:
            return None
        return self._told_of(self.kept.run(*self._run_asked()), "")

    def _run_so_far(self, error: Exception) -> Run | None:
        """What is kept of a tracker that could not go on; None: nothing."""
        run = self.kept.run_so_far(*self._run_asked())
        if run is None:
            return None
        why = strip_full_stop(explain(error))
        try:
            return self._told_of(run, why)
        except Exception:  # telling of it must neither lose the run nor hide why it ended
            _log.warning("what came of the tracking cannot be told", exc_info=True)
            tracks = len(set(run.tracks["track"].tolist()))
            self.run_summary = RunSummary(
                run.tracker, run.frames, self._asked, tracks, tracks, 0, why
            )
            return replace(run, notes=(*self.notes, self.run_summary.early))

    def _run_asked(self) -> tuple[str, Mapping[str, Any], int, Recording, Resume | None]:
        asked = self._request
        return asked.tracker, asked.settings, asked.seed, self._recording, asked.resume

    def _told_of(self, run: Run, why: str) -> Run:
        """The run with what it was given and what is told; why: it ended early, "": it did not."""
        run = replace(run, detections_input=self._process.detections_input)
        on_the_way = self.kept.parts("tracks", *self.kept.frames)
        summary = RunSummary.of(run, on_the_way, self._asked, why)
        nobody = None if summary.tracks else why_nobody(self._recording, run.tracker)
        self.run_summary = replace(summary, nobody=nobody)
        return replace(run, notes=(*self.notes, *([self.run_summary.early] if why else [])))

    def _make_room(self, _batch: object) -> None:
        """The window has taken a batch."""
        self._room.release()

    def _report(self, run: Run | None, problem: Exception | None) -> None:
        self._thread.join()
        if problem is not None:
            _log.info("tracking failed: %s", problem)
            self.failed.emit(problem)
        else:
            self.finished.emit(run)
