"""The tracker at work on an open recording: begun, shown as it goes on, kept when it is done."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QObject, Signal

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.i18n import tr
from app.core.playback.playback import Playback
from app.core.tracks.made_by import AtWork
from app.features.comparison.controller import ComparisonController
from app.features.runs.controller import LiveTracking
from app.features.runs.run_summary import (
    describe_added_first_run,
    describe_compared_run,
    describe_first_run,
    describe_further_run,
    describe_replacement,
    meanwhile,
)
from app.features.runs.tracker_state import TrackerState, TrackerWords
from app.shell.follow_mode import FollowMode
from tracking.session import Session
from tracking.trackers import Resume, StepResult, tracker_named
from tracking.tracks import Run

TrackingOrder = tuple[str, Any, int, tuple[int, int] | None]
"""Tracker, settings, seed and the half-open range of frames; None: all of them."""


class TrackerAtWork(Controller):
    """Puts trackers to work and what they find into the document.

    Signals: `found(first, last)`, it went through these frames, both included; `changed()`, all
    is to be drawn; `people_found()`, there are tracks where there were none; `began()`, one is put
    to work; `tracked(run)`, it came to its end with a `Run`; `noted(lines, passes)`, what the user
    should be told, and whether that is good news, which may go by itself.

    Attributes:
        live: the tracker. following: whether the playhead goes with it.
        failed_order: tracker, settings, seed and frames of the last one, where it failed.
    """

    found = Signal(int, int)
    people_found = Signal()
    began = Signal()
    tracked = Signal(object)
    noted = Signal(object, bool)

    def __init__(
        self,
        document: Document,
        playback: Playback,
        comparing: ComparisonController,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._playback, self._comparing = document, playback, comparing
        self._words = TrackerWords(document.recording)
        self.failed_order: TrackingOrder | None = None
        self._order: TrackingOrder | None = None
        self._again = False  # it is to put right what was corrected before
        self.live = LiveTracking(document.recording, self)
        self.live.tracked.connect(self._take)
        self.live.finished.connect(self._end)
        self.live.failed.connect(self._fail)
        self.following = FollowMode(document, playback, self.live, self)
        self.following.changed.connect(self._look_away)
        playback.wait_at = self._last_tracked

    @property
    def best(self) -> str:
        """The tracker that play starts; "" where none can work on the recording."""
        return self._words.best

    @property
    def why_not(self) -> str:
        """Why none can."""
        return self._words.why_not

    @property
    def propose_tracker(self) -> str:
        """The tracker that is asked about first."""
        document = self._document
        return self._words.propose_tracker(document.session, in_parts=document.detector_chosen)

    @property
    def state(self) -> TrackerState:
        """What made the tracks that are shown, told beside the transport.

        That is not the tracker at work while somebody looks at the session's tracks.
        """
        if self.live.running and (self._document.is_live or self._document.is_untouched):
            status = tr("stopping") if self.live.stopping else self.live.status
            return self._words.describe_work(self.live.tracker, status)
        document = self._document
        return self._words.describe_rest(None if document.is_untouched else document.session)

    def begin_first(self) -> None:
        """Put the best tracker to work where none was yet, not even on the way into a session."""
        untouched = self._document.is_untouched and not self._document.tracked_until
        if self.best and untouched and not self.live.running:
            self.track(self.best)

    def track(
        self,
        tracker: str,
        settings: Any = None,
        seed: int = 0,
        frames: tuple[int, int] | None = None,
        resume: Resume | None = None,
    ) -> None:
        """Put a tracker to work on some frames; what it finds is shown as it comes.

        The playhead goes with it until somebody moves it (see `FollowMode`).
        With `resume` it goes on from the corrected tracks, which stay shown before its frames.
        """
        self._again = False
        if settings is None:
            settings = self._document.parts_asked.filled(tracker_named(tracker).settings_type)
        self._order, self.failed_order = (tracker, settings, seed, frames), None
        at_work = AtWork.of(tracker, settings)
        kept = self.live.start(tracker, settings, seed, frames, resume)
        first = resume.frame if resume is not None else None
        self._document.begin_live(first, at_work, kept)
        self.following.begin()
        self.began.emit()
        self.changed.emit()
        session = self._document.session
        if session is not None and not self._document.is_untouched and resume is None:
            self.noted.emit((meanwhile(session),), True)

    def track_again(
        self,
        tracker: str,
        settings: Any = None,
        seed: int = 0,
        frames: tuple[int, int] | None = None,
    ) -> None:
        """Track some frames again, from the corrected tracks on; what would change is shown then.

        Raises:
            SettingsError: the tracker cannot go on from there.
        """
        session, first = self._document.session, frames[0] if frames is not None else 0
        resume = None
        if session is not None and first > 0:
            resume = Resume.of(
                session.tracks,
                first,
                self._document.recording.fps,
                detections_input=session.detections_input,
            )
        self.track(tracker, settings, seed, frames, resume)
        self._again = True

    def stop(self) -> None:
        """Stop after the frame in work and keep the result; that it stops is shown at once."""
        self.live.stop()
        self.changed.emit()

    def drop(self) -> None:
        """End the tracker at work; what it found is forgotten."""
        self.live.close()
        self.following.end()
        if self._document.is_live:
            self._document.begin_live()
        self._document.end_live()
        self.changed.emit()

    def take_session(self, session: Session) -> None:
        """Show a session made of what was tracked, or of other tracks."""
        self._document.take_session(session)
        self._tell(describe_first_run())
        self.changed.emit()

    def add_run(self, run: Run) -> None:
        """Keep a further result in the session; corrected tracks stay as they are.

        Whoever looks at the tracks there are, or has begun an edit of them, keeps them as well.

        Raises:
            EditError: the session cannot take it; its own tracks are shown again all the same.
        """
        document, session = self._document, self._document.session
        if session is None:
            return
        before = session.adopted_run
        free = document.flow is None and (document.is_live or before is None)
        if document.is_live and not self._again:
            document.selection.choose(0)  # by the tracker's numbers
        try:
            number = session.add_run(run, adopt=free)
        finally:
            document.end_live()
        if session.adopted_run == number:
            document.selection.choose(0)  # the same number is somebody else by now
        if self._again and document.flow is None:
            self._comparing.open(number)
        if session.adopted_run != number:
            compared = self._again and document.flow is None
            self._tell(describe_compared_run(number) if compared else describe_further_run(number))
        else:
            self._tell(
                describe_added_first_run(number)
                if before is None
                else describe_replacement(number, before)
            )
        self.changed.emit()

    def _tell(self, kept: str) -> None:
        """Emit the summary of the tracker that is done, once; nothing where none is."""
        summary, self.live.run_summary = self.live.run_summary, None
        if summary is not None:
            passes = not (self.live.notes or summary.why)
            self.noted.emit((summary.words(kept), *map(tr, self.live.notes)), passes)

    def _look_away(self) -> None:
        """Whoever looks elsewhere while a further run is made sees, and corrects, what there is."""
        if self.live.running and self._document.show_live(self.following.on):
            self.changed.emit()

    def _last_tracked(self) -> int | None:
        """Where playing waits for the tracker, so that people are seen with their picture."""
        if not self._document.is_live:
            return None
        first = self.live.first
        until = max(self._document.tracked_until, first)
        if self.live.running and self._playback.clock.frame <= until:
            return max(until - 1, first)
        return None

    def _take(self, results: tuple[StepResult, ...]) -> None:
        nobody_before = not self._document.tracks.ids
        self._document.take_live(results)
        self.following.take()
        self.found.emit(results[0].frame, results[-1].frame)
        if nobody_before and self._document.tracks.ids:
            self.people_found.emit()

    def _end(self, run: object) -> None:
        self.following.end()
        if self.live.notes:
            self.noted.emit(tuple(map(tr, self.live.notes)), False)
        self._document.rest()
        if run is None:
            self._document.end_live()
        self.tracked.emit(run)
        self.changed.emit()

    def _fail(self, error: Exception) -> None:
        """Nothing is kept of it, so nothing of it stays in view; play begins anew."""
        self.failed_order = self._order
        self.drop()
        self.failed.emit(error)
