"""Work that runs in processes of its own, in the list of all long work."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from app.core.i18n import tr
from app.core.jobs.job_list import JobList, JobState
from app.features.runs.controller import LiveTracking

if TYPE_CHECKING:  # most windows open no project
    from app.features.project.batch_watch import BatchWatch


class ListedWork:
    """Keeps the lines of the tracker at work and of the batch at work up to date."""

    def __init__(self, jobs: JobList) -> None:
        self._jobs = jobs
        self._tracking = self._batch = 0

    def take_tracking(
        self,
        live: LiveTracking | None,
        drop: Callable[[], object],
        keep: Callable[[], object] | None,
    ) -> None:
        """How far the tracker is, where one is at work; `drop` ends it, `keep` with its result."""
        if live is None or not live.running:
            kept = live is not None and live.run_summary is not None
            state = JobState.DONE if kept else JobState.STOPPED
            self._tracking = self._ended(self._tracking, state)
            return
        if not self._tracking:
            title = tr("Tracking with {tracker}", tracker=live.tracker)
            self._tracking = self._jobs.begin(title, drop)
        self._jobs.show(self._tracking, live.share, live.seconds_left, keep)

    def take_batch(self, batches: BatchWatch) -> None:
        """How far a project's batch is, where one is at work."""
        if batches.watched is None:
            self._batch = self._ended(self._batch)
            return
        if not self._batch:
            self._batch = self._jobs.begin(tr("Batch of recordings"), batches.cancel)
        self._jobs.show(self._batch, batches.share, batches.watched.seconds_left)

    def _ended(self, number: int, state: JobState = JobState.DONE) -> int:
        """No such work is under way any more; what came of it is said by whoever began it."""
        if number:
            self._jobs.end(number, state)
        return 0
