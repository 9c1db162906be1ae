"""Looking for review items off the GUI thread: a moment after the last edit, the newest wins."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QTimer, Signal

from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.jobs.jobs import Job, Progress
from app.core.jobs.listed_job import ListedJob, cancelled_error
from app.features.review.review_meter import measure_queue, measures_text
from tracking.recording import Recording
from tracking.review import ReviewFinding, ReviewItemFinder
from tracking.tracks import Labels, Run, TrackTable
from tracking.translation import message_of

Subject = tuple[TrackTable, Run | None, Labels]
"""The tracks to look through, the run they come from, the labels."""

_QUIET_MS = 200


def _looking() -> str:
    return tr("Looking for review items...")


class ReviewSearch(QObject):
    """Finds review items in the background; asked for again meanwhile, it begins anew.

    Signals: `found(finding)`, a `ReviewFinding`; `changed()`, `doing` or `measures` is another;
    `failed(error)`.

    Attributes:
        doing: what goes on, in words; "" at rest.
        problem: why nothing could be found, in words; "" where there is no such thing.
        measuring: whether what is found is measured against the truth, where there is one.
        measures: how good it is, in words; "" where that is not asked, or without a truth.
        hand_made: what shows nothing but boxes that a person made is flagged, too.
    """

    found = Signal(object)
    changed = Signal()
    failed = Signal(object)

    def __init__(
        self, subject: Callable[[], Subject], recording: Recording, parent: QObject
    ) -> None:
        """`subject` is asked when a search begins, for a copy that nobody changes."""
        super().__init__(parent)
        self.doing = self.measures = self.problem = ""
        self.measuring = self.hand_made = False
        self._subject = subject
        self._recording = recording
        self._finder = ReviewItemFinder()
        self._job: Job | None = None
        self._listed = ListedJob(tr("Looking for review items"), self, self._cancel)
        self._listed.drop_with(self)
        self._again = False
        self._found: tuple[object, TrackTable] | None = None
        self._waiting = QTimer(self, singleShot=True, interval=_QUIET_MS)
        self._waiting.timeout.connect(self._begin)

    @property
    def busy(self) -> bool:
        """Whether it looks, or is about to."""
        return self._job is not None or self._waiting.isActive()

    def look(self, at_once: bool = False) -> None:
        """Look through the tracks as they are by then, once nothing was asked for a moment."""
        self.problem = ""
        if self._job is not None:
            self._again = True
            self._job.cancel()
        self._waiting.start(0 if at_once else _QUIET_MS)
        self._tell(_looking(), self.measures)

    def measure(self, asked: bool) -> None:
        """Measure what is found from now on, and what was found last; or no more."""
        self.measuring = asked
        if not asked:
            self._tell(self.doing, "")
        elif self._job is None and self._found is not None:
            self._measure(*self._found)

    def stop(self) -> None:
        """Look no further; nothing is found any more of what was asked."""
        self._waiting.stop()
        self._again = False
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()
        self._listed.drop()
        self._found, self._finder, self.problem = None, ReviewItemFinder(), ""
        self._tell("", "")

    def _cancel(self) -> None:
        """The user wants no more of it."""
        self._again = False
        self._waiting.stop()
        if self._job is not None:
            self._job.cancel()
        else:
            self._end(self._give_up)

    def _begin(self) -> None:
        if self._job is not None:
            return  # it begins when the one at work has let go
        self._again = False
        table, run, labels = self._subject()
        recording, lookout, hand_made = self._recording, self._finder, self.hand_made

        def find(progress: Progress) -> object:
            view, size = recording.view, recording.size
            return lookout.find(
                table, run, recording.fps, labels, view, progress, size=size, hand_made=hand_made
            )

        self._tell(_looking(), self.measures)
        self._start(find, lambda found: self._take(found, table))

    def _start(self, work: Callable[[Progress], object], done: Callable[[Any], None]) -> None:
        job = Job("review_items", work, self, listed=False)
        job.progressed.connect(self._show)
        job.done.connect(lambda result: self._end(lambda: done(result)))
        job.failed.connect(lambda error: self._end(lambda: self._fail(error)))
        job.cancelled.connect(lambda: self._end(self._give_up))
        job.progressed.connect(self._listed.progress)
        self._job = job
        self._listed.begin()
        job.start()

    def _take(self, finding: ReviewFinding, table: TrackTable) -> None:
        """Tell what was found; then, where that is asked, measure how good it is."""
        self._found = finding.items, table
        self.found.emit(finding)
        if self.measuring:
            self._measure(finding.items, table)

    def _measure(self, found: Any, table: TrackTable) -> None:
        """Measure what was found against the truth beside the recording, if there is one."""
        recording = self._recording
        if recording.truth_path is not None:
            self._start(
                lambda _: measures_text(measure_queue(found, table, recording)),
                lambda text: self._tell("", text if self.measuring else ""),
            )

    def _give_up(self) -> None:
        """It was cancelled, and nobody asked for it again."""
        self.problem = explain(cancelled_error())
        self._listed.stopped(lambda: self.look(at_once=True))
        self.changed.emit()

    def _fail(self, error: Exception) -> None:
        self._listed.failed(error)
        self.problem = tr(message_of(error))
        self.failed.emit(error)

    def _show(self, done: int, total: int) -> None:
        if total > 0 and self._job is not None:
            share = 100 * done // total
            words = tr("Looking for review items... {share} %", share=share)
            self._tell(words, self.measures)

    def _end(self, tell: Callable[[], None]) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None
        if self._again:
            if not self._waiting.isActive():
                self._begin()
            return
        self._tell("", self.measures)
        tell()
        if self._job is None:
            self._listed.done()

    def _tell(self, doing: str, measures: str) -> None:
        if (doing, measures) != (self.doing, self.measures):
            self.doing, self.measures = doing, measures
            self.changed.emit()
