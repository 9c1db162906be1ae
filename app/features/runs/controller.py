"""The tracker at work on the open recording: how far it is and how fast."""

from __future__ import annotations

import time
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.core.i18n import tr
from app.features.runs.live_tracker import LiveTracker
from app.features.runs.run_summary import RunSummary
from tracking.pipeline import KeptSteps
from tracking.recording import Recording
from tracking.trackers import Resume, StepResult
from tracking.translation import Message

_SPEED_OVER_S = 2.0


class LiveTracking(QObject):
    """Starts and stops a `LiveTracker` and tells how it gets on.

    Signals: `learning()`, more of the background is learnt; `tracked(results)`, a tuple of
    `StepResult` in order; `finished(run)`, the run over what was tracked, None where that is
    nothing; `failed(error)`.

    Attributes:
        tracker: at work, or that was last. done: one past the last frame it has been through.
        notes: what the user should be told of what was tracked last, a line each.
        run_summary: what became of it; None while it is not known.
        stopping: it was asked to end, and its result is about to come.
    """

    learning = Signal()
    tracked = Signal(object)
    finished = Signal(object)
    failed = Signal(object)

    def __init__(self, recording: Recording, parent: QObject) -> None:
        super().__init__(parent)
        self.tracker = ""
        self.done = 0
        self.stopping = False
        self.notes: tuple[Message, ...] = ()
        self.run_summary: RunSummary | None = None
        self._recording = recording
        self._frames = (0, recording.frame_count)
        self._worker: LiveTracker | None = None
        self._recent: list[tuple[float, int]] = []
        self._learnt = 0.0

    @property
    def running(self) -> bool:
        """Whether a tracker is at work."""
        return self._worker is not None

    def start(
        self,
        tracker: str,
        settings: Any = None,
        seed: int = 0,
        frames: tuple[int, int] | None = None,
        resume: Resume | None = None,
    ) -> KeptSteps:
        """Put a tracker to work on a half-open range of frames; None: on all of them.

        With `resume` it goes on from corrected tracks; the range begins where they end then.
        Gives where its steps are kept before `tracked` tells of them.
        """
        self.close()
        first = resume.frame if resume is not None else 0
        self._frames = frames or (first, self._recording.frame_count)
        self.tracker, self.done, self.notes, self._recent = tracker, 0, (), []
        self.run_summary, self.stopping, self._learnt = None, False, 0.0
        worker = LiveTracker(self._recording, tracker, settings, seed, self, self._frames, resume)
        worker.learning.connect(self._learn)
        worker.tracked.connect(self._take)
        worker.finished.connect(self._finish)
        worker.failed.connect(self._fail)
        self._worker = worker
        worker.start()
        return worker.kept

    def stop(self) -> None:
        """Stop after the frame in work and keep what was tracked."""
        if self._worker is not None:
            self.stopping = True
            self._worker.stop()

    def close(self) -> None:
        """End the thread, dropping what it still would have reported."""
        if self._worker is not None:
            worker, self._worker, self.stopping = self._worker, None, False
            for signal in (worker.learning, worker.tracked, worker.finished, worker.failed):
                signal.disconnect()
            worker.close()
            worker.deleteLater()

    @property
    def first(self) -> int:
        """The first frame that is tracked."""
        return self._frames[0]

    @property
    def share(self) -> float | None:
        """How much is done, 0 to 1; None while the background is learnt, and once all is seen."""
        first, stop = self._frames
        return (self.done - first) / (stop - first) if 0 < self.done < stop else None

    @property
    def fps(self) -> float:
        """Frames a second over the last moments; 0 before the first."""
        if len(self._recent) < 2:
            return 0.0
        (then_s, before), (now_s, now) = self._recent[0], self._recent[-1]
        return (now - before) / max(now_s - then_s, 1e-6)

    @property
    def seconds_left(self) -> float | None:
        """Time until the end at this pace; None while that is not known."""
        fps, frames = self.fps, self._frames[1] - self.done
        return frames / fps if fps > 0 and frames else None

    @property
    def status(self) -> str:
        """In a few words."""
        if not self.done:
            return self._learning_words()
        if self.done >= self._frames[1]:
            return tr("looking over the whole recording")
        return tr("live {fps:.0f} fps", fps=self.fps) if self.fps else tr("live")

    def _learning_words(self) -> str:
        if not self._learnt:
            return tr("learning the background")
        return tr("learning the background, {share:.0%}", share=self._learnt)

    def _learn(self, done: int, total: int) -> None:
        self._learnt = done / max(total, 1)
        self.learning.emit()

    def _take(self, results: tuple[StepResult, ...]) -> None:
        if results:
            now_s = time.monotonic()
            self.done = results[-1].frame + 1
            self._recent.append((now_s, self.done))
            while now_s - self._recent[0][0] > _SPEED_OVER_S:
                self._recent.pop(0)
            self.tracked.emit(results)

    def _finish(self, run: object) -> None:
        if self._worker is not None:
            self.notes, self.run_summary = self._worker.notes, self._worker.run_summary
        self._drop()
        self.finished.emit(run)

    def _fail(self, error: Exception) -> None:
        self._drop()
        self.failed.emit(error)

    def _drop(self) -> None:
        self.stopping = False
        if self._worker is not None:
            self._worker.deleteLater()
            self._worker = None
