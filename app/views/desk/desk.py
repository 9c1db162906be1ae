"""One open recording on the workspace: draws what is due and passes gestures on."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QObject, Signal

from app.presenters.commands import Situation
from app.presenters.document.document import Document
from app.presenters.document.setting import Pictured
from app.presenters.labelling.labelling_scene import Tool
from app.presenters.runs.tracker_state import TrackerState, TrackerWords, kept_beside
from app.presenters.scenes import Eye, TransportScene
from app.views.comparing.comparing import Comparing
from app.views.correcting.dragging import Dragging
from app.views.correcting.editing import Editing
from app.views.counting.counting import Counting
from app.views.desk.gestures import connect_gestures
from app.views.desk.workspace import Workspace
from app.views.history.history import HistoryWalk
from app.views.labelling.labelling import Labelling
from app.views.parts.parts import Parts
from app.views.pictures.overlaying import Overlaying
from app.views.playing.playback import Playback
from app.views.reviewing.reviewing import Reviewing
from app.views.runs.live import LiveTracking
from tracking.session import Session
from tracking.trackers import Resume, StepResult, tracker_named
from tracking.tracks import Run


class Desk(QObject):
    """Holds the document, the playback and the tracker at work of one open recording.

    Signals: `drawn()`, another instant is shown; `changed()`, commands may be enabled or disabled
    by now; `progressed()`, the tracker at work is further; `failed(error)`; `said(text)`;
    `tracked(run)`, it came to its end with a `Run`; `noted(lines)`, what the user should be told.
    """

    changed = Signal()
    drawn = Signal()
    progressed = Signal()
    failed = Signal(object)
    said = Signal(str)
    tracked = Signal(object)
    noted = Signal(object)

    def __init__(self, document: Document, workspace: Workspace, parent: QObject) -> None:
        super().__init__(parent)
        self.document = document
        self.playback = Playback(document.recording, self)
        self.editing = Editing(document, self.playback, self)
        self.dragging = Dragging(document, self.playback, self.editing)
        self.overlaying = Overlaying(document, self.playback, self)
        self.walk = HistoryWalk(document, self.playback, workspace.history, self)
        self.labelling = Labelling(document, self.playback, workspace, self)
        self.parts = Parts(document, self.playback, workspace, self.labelling, self)
        self.counting = Counting(document, self.playback, workspace, self)
        self.live = LiveTracking(document.recording, self)
        self.comparing = Comparing(document, self.playback, self.editing, workspace, self)
        panel = workspace.review
        self.reviewing = Reviewing(document, self.playback, self.editing, panel, self)
        self.pictured = Pictured()
        self.eyes = "left"
        self._workspace = workspace
        self._again = False  # the tracker at work is to put right what was corrected before
        self._words = TrackerWords(document.recording)
        self._connect_parts()
        connect_gestures(self, workspace)

    def _connect_parts(self) -> None:
        self.playback.wait_at = self._last_tracked
        self.playback.shown.connect(self.draw_instant)
        self.playback.moved.connect(self.draw_playhead)
        self.playback.failed.connect(self.failed)
        self.editing.changed.connect(self.labelling.follow_edits)
        self.editing.changed.connect(self.draw)
        self.editing.previewed.connect(self.draw_preview)
        self.editing.failed.connect(self.failed)
        self.editing.said.connect(self.said)
        for part in (self.reviewing, self.comparing):
            part.changed.connect(self.changed)
            part.failed.connect(self.failed)
            part.said.connect(self.said)
        self.reviewing.changed.connect(self.draw_playhead)  # whose marks stand on the timeline
        self.overlaying.changed.connect(self.draw_instant)
        for one in (self.labelling, self.walk):
            one.changed.connect(self.draw)
            one.failed.connect(self.failed)
            one.said.connect(self.said)
        self.overlaying.failed.connect(self.failed)
        self.parts.changed.connect(self.draw)
        self.counting.changed.connect(self.draw_instant)
        self.counting.said.connect(self.said)
        self.parts.said.connect(self.said)
        self.live.tracked.connect(self._take_live)
        self.live.finished.connect(self._end_live)
        self.live.failed.connect(self._fail_live)

    def close(self) -> None:
        """End all threads and let the recording go."""
        self.live.close()
        self.reviewing.close()
        self.comparing.end()
        self.overlaying.close()
        self.labelling.close()
        self.parts.close()
        self.counting.close()
        self.playback.close()
        if self.document.session is not None:
            self.document.session.close()
        self.document.recording.close()

    @property
    def window_page(self) -> Workspace:
        """What dialogs stand before."""
        return self._workspace

    # what can be done

    @property
    def situation(self) -> Situation:
        """What commands depend on."""
        document, session = self.document, self.document.session
        recording = document.recording
        return Situation(
            recording=True,
            session=session is not None,
            tracks=bool(document.tracks.ids),
            selected=bool(document.selection),
            editing=document.flow is not None,
            labelling=self.labelling.tool is not None,
            saying=self.labelling.tool is Tool.PARTS,
            suggesting=self.labelling.suggests,
            parts=self.parts.presenter.any_tracked,
            part_truth=self.parts.presenter.truth_known,
            placing=document.flow is not None and document.flow.places,
            live=self.live.running,
            can_undo=session is not None and session.history.next_undo is not None,
            can_redo=session is not None and session.history.next_redo is not None,
            stereo=recording.is_stereo,
            truth=recording.truth_path is not None,
            calibrated=recording.view is not None,
            can_track=bool(self._words.best),
            why_no_tracking=self._words.why_not,
            read_only=session is not None and session.read_only,
            comparing=self.comparing.shown,
            **self.reviewing.situation,
        )

    @property
    def best_tracker(self) -> str:
        """The tracker that play starts; "" where none can work on the recording."""
        return self._words.best

    @property
    def proposed_tracker(self) -> str:
        """The tracker that is asked about first."""
        document = self.document
        return self._words.proposed(document.session, in_parts=document.detector_chosen)

    def leave(self) -> None:
        """Esc: leave the labelling, else the edit that waits, else let the person go."""
        if self.labelling.tool is not None:
            self.labelling.leave()
        else:
            self.editing.leave()

    # playing and tracking

    def toggle(self) -> None:
        """Play or pause; the first play puts the best tracker to work."""
        if self._never_tracked and self.best_tracker and not self.playback.clock.playing:
            self.track(self.best_tracker)
        self.playback.toggle()

    def shuttle(self, direction: int) -> None:
        """J (-1), K (0), L (1); playing on puts the best tracker to work like the first play."""
        if direction > 0 and self._never_tracked and self.best_tracker:
            self.track(self.best_tracker)
        self.playback.shuttle(direction)

    @property
    def _never_tracked(self) -> bool:
        """Nothing was tracked, also nothing that is on its way into a session."""
        document = self.document
        return document.session is None and not self.live.running and not document.tracked_until

    def track(
        self,
        tracker: str,
        settings: Any = None,
        seed: int = 0,
        frames: tuple[int, int] | None = None,
        resume: Resume | None = None,
    ) -> None:
        """Put a tracker to work on some frames; what it finds is shown as it comes.

        With `resume` it goes on from the corrected tracks, which stay shown before its frames.
        """
        self._again = False
        if settings is None:
            settings = self.document.parts_asked.filled(tracker_named(tracker).settings_type)
        self.document.begin_live(resume.frame if resume is not None else None)
        self.live.start(tracker, settings, seed, frames, resume)
        if frames is not None and not frames[0] <= self.playback.clock.frame < frames[1]:
            self.playback.go(frames[0])
        self.draw()

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
        session, first = self.document.session, frames[0] if frames is not None else 0
        resume = None
        if session is not None and first > 0:
            resume = Resume.of(session.tracks, first, self.document.recording.fps)
        self.track(tracker, settings, seed, frames, resume)
        self._again = True

    def drop_live(self) -> None:
        """End the tracker at work; what it found is forgotten."""
        self.live.close()
        self.document.begin_live()
        self.document.end_live()
        self.draw()

    def take_session(self, session: Session) -> None:
        """Show a session made of what was tracked."""
        self.document.take_session(session)
        self.draw()

    def add_run(self, run: Run) -> None:
        """Keep a further result in the session; corrected tracks stay as they are."""
        session = self.document.session
        if session is None:
            return
        number = session.add_run(run)
        self.document.end_live()
        if self._again:
            self.comparing.open(number)
        if session.adopted_run != number:
            self.noted.emit((kept_beside(number), *self.live.notes))
        self.draw()

    def _last_tracked(self) -> int | None:
        """Where playing waits for the tracker, so that people are seen with their picture."""
        first = self.live.first
        until = max(self.document.tracked_until, first)
        if self.live.running and self.playback.clock.frame <= until:
            return max(until - 1, first)
        return None

    def _take_live(self, results: tuple[StepResult, ...]) -> None:
        nobody_before = not self.document.tracks.ids
        self.document.take_live(results)
        if results[0].frame <= self.playback.number <= results[-1].frame:
            self.draw_instant()
        self.draw_playhead()
        self.progressed.emit()
        if nobody_before and self.document.tracks.ids:
            self.changed.emit()

    def _end_live(self, run: object) -> None:
        if self.live.notes:
            self.noted.emit(self.live.notes)
        self.tracked.emit(run)
        self.draw()

    def _fail_live(self, error: Exception) -> None:
        """Nothing is kept of it, so nothing of it stays in view; play begins anew."""
        self.drop_live()
        self.failed.emit(error)

    # drawing

    def set_eyes(self, mode: str) -> None:
        """Show "left", "both" or "anaglyph"."""
        self.eyes = mode if self.document.recording.is_stereo else "left"
        self._workspace.show_eyes(self.eyes, self.document.recording.is_stereo)
        self.draw_instant()
        self.changed.emit()

    def set_pictured(self, pictured: Pictured) -> None:
        """Lay other things over the pictures."""
        self.pictured = pictured
        self.draw_instant()
        self.draw_playhead()
        self.changed.emit()

    def draw(self) -> None:
        """Draw everything."""
        view, document = self._workspace, self.document
        self.reviewing.refresh()  # first: it may select who a suspicion is about
        self.draw_instant()
        self.draw_playhead()
        view.card.show_scene(document.card())
        view.history.show_scene(document.history())
        view.preview.show_scene(document.planned.scene if document.planned else None)
        self.comparing.refresh()
        self.changed.emit()

    def draw_preview(self) -> None:
        """Draw only what an edit that waits would do: often, while something is dragged."""
        planned = self.document.planned
        self.draw_instant()
        self._workspace.preview.show_scene(planned.scene if planned is not None else None)

    def draw_instant(self) -> None:
        """Draw the pictures and the floor: the same frame in all of them."""
        view, document, frame = self._workspace, self.document, self.playback.frame
        instant = document.instant(self.playback.number)
        pictures, laid = document.pictures, self.overlaying.laid(self.pictured.kinds)
        if self.eyes == "anaglyph":
            view.left.show_scene(pictures.anaglyph(frame, instant, self.pictured, laid))
        else:
            view.left.show_scene(pictures.scene(Eye.LEFT, frame, instant, self.pictured, laid))
        if self.eyes == "both":
            view.right.show_scene(pictures.scene(Eye.RIGHT, frame, instant, self.pictured))
        view.overhead.show_scene(document.overhead.scene(instant))
        counted = self.counting.draw(instant, self.pictured)
        self.labelling.draw(self.eyes == "both", self.pictured.labels, counted)
        self.parts.draw(instant, self.pictured)
        self.drawn.emit()

    def draw_playhead(self) -> None:
        """Draw the timeline and the transport line."""
        clock, document, tracker = self.playback.clock, self.document, self._tracker_state()
        frame, loaded = self.playback.number, self.playback.loaded
        document.take_score(self.parts.presenter.score() if self.pictured.parts else None)
        self._workspace.timeline.show_scene(
            document.timeline(clock.frame, frame, loaded, tracker.no_lanes)
        )
        self._workspace.transport.show_scene(
            TransportScene(
                playing=clock.playing,
                speed=abs(clock.rate) if clock.playing else clock.speed,
                frame=clock.frame,
                frame_count=clock.frame_count,
                time_s=document.recording.time_s(clock.frame),
                tracker=tracker.name,
                status=tracker.status,
                live=self.live.running and self.live.done > 0,
            )
        )

    def _tracker_state(self) -> TrackerState:
        if self.live.running:
            return self._words.working(self.live.tracker, self.live.status)
        return self._words.resting(self.document.session)
