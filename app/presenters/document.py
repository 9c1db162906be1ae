"""An open recording with what is known of its people: the model behind the whole window."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from app.presenters.edit_flow import EditFlow, EditKind
from app.presenters.edit_preview import PlannedEdit, planned_edit, preview_trails
from app.presenters.live_tracks import LiveTracks
from app.presenters.overhead import OverheadPresenter
from app.presenters.panels import EditMarks, HistoryList, track_card
from app.presenters.pictures import PicturePresenter
from app.presenters.scenes import HistoryItem, TimelineMark, TimelineScene, TrackCard
from app.presenters.selection import Selection
from app.presenters.session_tracks import SessionTracks
from app.presenters.setting import Instant
from app.presenters.shown import ShownTracks
from app.presenters.timeline import TimelinePresenter
from app.presenters.trails import floor_points
from app.presenters.words import tr
from tracking.editing import Change
from tracking.errors import EditError
from tracking.recording import Recording
from tracking.session import Session
from tracking.trackers import StepResult
from tracking.tracks import ReviewedRange, TrackLabel


class Document:
    """One recording, its session once there is one, and the edit that is being put together.

    Until there is a session, the tracks of the tracker at work are shown. No Qt here: whoever
    calls something that changes the document shows its scenes again afterwards.
    """

    def __init__(self, recording: Recording, session: Session | None = None) -> None:
        self.recording = recording
        self.session = session
        self.selection = Selection()
        self.flow: EditFlow | None = None
        self.planned: PlannedEdit | None = None
        self.pictures = PicturePresenter(recording)
        self.overhead = OverheadPresenter(recording)
        self._timeline = TimelinePresenter(recording.frame_count, recording.fps)
        self._live, self._live_shown = LiveTracks(), session is None
        self._marks, self._history = EditMarks(), HistoryList()
        self._retake()

    @property
    def tracks(self) -> ShownTracks:
        """The tracks that are shown."""
        return self._tracks

    @property
    def tracked_until(self) -> int:
        """One past the last frame a tracker at work has been through."""
        return self._live.frames[1]

    @property
    def busiest_frame(self) -> int:
        """The frame with the most people; the first where there are none."""
        return int(self._tracks.activity(self.recording.frame_count).argmax())

    # tracking

    def begin_live(self) -> None:
        """A tracker starts anew; what it finds is shown until it has come to its end.

        The corrected tracks of a session stay as they are.
        """
        self.leave_edit()
        self.selection.choose(0)
        self._live, self._live_shown = LiveTracks(), True
        self._retake()

    def take_live(self, results: Iterable[StepResult]) -> None:
        """Take further results of the tracker at work, in order."""
        self._live.extend(results)
        self._timeline.take(self._live, {})

    def take_session(self, session: Session) -> None:
        """Show a session from now on."""
        self.session = session
        self._live, self._live_shown = LiveTracks(), False
        self._marks, self._history = EditMarks(), HistoryList()
        self._retake()

    def end_live(self) -> None:
        """The tracker is done, or failed: show the session again, if there is one."""
        if self.session is not None:
            self.take_session(self.session)

    def _retake(self) -> None:
        """Show the tracks of the tracker at work, or those of the session."""
        session = self.session
        self._tracks: ShownTracks = self._live
        marks: dict[int, tuple[TimelineMark, ...]] = {}
        reviewed: tuple[ReviewedRange, ...] = ()
        if session is not None and not self._live_shown:
            adopted = session.adopted_run
            run = session.runs[adopted] if adopted is not None else None
            self._tracks = SessionTracks(session.tracks, run)
            marks, reviewed = self._marks.of(session.history), session.labels.reviewed
        self._timeline.take(self._tracks, marks)
        self._timeline.take_reviewed(reviewed)

    # what the views show

    def instant(self, frame: int) -> Instant:
        """The frame as all views show it."""
        planned = self.planned
        shown = planned is not None and planned.change is not None
        return Instant(
            frame=frame,
            tracks=self._tracks,
            names=self._names(),
            selected=self.selection.track,
            other=self.flow.other if self.flow is not None else 0,
            preview=preview_trails(planned, floor_points) if planned and shown else (),
            picture_preview=(
                preview_trails(planned, self.pictures.left_foot_points) if planned and shown else ()
            ),
        )

    def timeline(
        self,
        playhead: int,
        frame: int,
        loaded: tuple[tuple[int, int], ...] = (),
        no_lanes: str = "",
    ) -> TimelineScene:
        """The timeline with its playhead; lanes are those of `frame`'s instant.

        `loaded` are the half-open ranges of frames at hand; `no_lanes` is said without lanes.
        """
        cut = self.flow.cut if self.flow is not None and self.flow.has_cut else None
        return self._timeline.scene(playhead, self.instant(frame), loaded, cut, no_lanes)

    def take_suspicions(self, suspicions: Sequence[TimelineMark]) -> None:
        """Mark on the timeline what may be wrong, instead of what was marked before."""
        self._timeline.take_suspicions(suspicions)

    def card(self) -> TrackCard | None:
        """The selected track in words."""
        if not self.selection:
            return None
        return track_card(self._tracks, self.selection.track, self.label(self.selection.track))

    def history(self) -> tuple[HistoryItem, ...]:
        """All edits, oldest first."""
        return self._history.of(self.session.history) if self.session is not None else ()

    def label(self, track: int) -> TrackLabel:
        """What people said of a track; nothing of those a tracker at work has numbered anew."""
        session = self.session
        if session is None or self._live_shown:
            return TrackLabel()
        return session.labels.of_track(track)

    def _names(self) -> dict[int, str]:
        if self.session is None or self._live_shown:
            return {}
        return {track: label.name for track, label in self.session.labels.tracks.items()}

    # selecting

    def pick(self, track: int) -> None:
        """A person was clicked: select them, or give them to the edit that waits for one."""
        if self.flow is not None and self.flow.needs_other:
            if track and self.session is not None:
                self._put(self.flow.with_other(track, self.session.tracks))
        elif self.flow is None:
            self.selection.choose(track)

    def pick_typed(self, track: int) -> None:
        """An id was typed for the other person of the edit; one that is not there is told."""
        flow, session = self.flow, self.session
        if flow is None or session is None or not flow.takes_other:
            return
        if track == flow.track:
            self._put(flow, tr("{track} is the selected person: type another id", track=track))
        elif track not in session.tracks:
            self._put(flow, tr("There is no track {track}", track=track))
        else:
            self._put(flow.with_other(track, session.tracks))

    def pick_next(self, frame: int, step: int) -> None:
        """Tab: the next person of the frame, or of all where nobody stands in it."""
        here = self._tracks.of_frame(frame)["track"].tolist() or list(self._tracks.ids)
        if self.flow is None:
            self.selection.choose(self.selection.cycle(here, step))
        elif self.session is not None and self.flow.kind in (EditKind.SWAP, EditKind.MERGE):
            along = Selection()
            along.choose(self.flow.other or self.flow.track)
            other = along.cycle(here, step, skip=self.flow.track)
            if other:
                self._put(self.flow.with_other(other, self.session.tracks))

    # correcting

    def begin_edit(self, kind: EditKind, frame: int) -> None:
        """Begin an edit of the selected track at a frame."""
        if self.selection and self.session is not None:
            self._put(EditFlow.begin(kind, self.selection.track, frame, self.recording.fps))

    def change_edit(self, flow: EditFlow) -> None:
        """Put another state of the edit in place of the one there is."""
        self._put(flow)

    def leave_edit(self) -> None:
        """Leave the edit; everything stays as it is."""
        self.flow = self.planned = None

    def _put(self, flow: EditFlow, problem: str = "") -> None:
        if self.session is not None:
            self.flow = flow
            tracks, labels = self.session.tracks, self.session.labels
            self.planned = planned_edit(flow, tracks, labels, self.recording.fps, problem)

    def confirm_edit(self) -> Change | None:
        """Do the edit that waits; None where it is not ready."""
        change = self.planned.change if self.planned is not None else None
        if change is None:
            return None
        self.leave_edit()
        self.apply(change)
        return change

    def apply(self, change: Change) -> None:
        """Do a change: on disk first, then shown.

        Raises:
            EditError: the tracks shown are not the session's but those of a tracker at work.
        """
        self._refuse_while_live()
        if self.session is not None:
            self.session.apply(change)
            self._take_changed(change)

    def undo(self) -> Change | None:
        """Take the last edit back; what it was, or None where there is none."""
        entry = self.session.history.next_undo if self.session is not None else None
        if self.session is None or entry is None:
            return None
        self._refuse_while_live()
        change = entry.change
        self.session.undo()
        self._take_changed(change.inverse)
        return change

    def redo(self) -> Change | None:
        """Do the edit again that was taken back last."""
        entry = self.session.history.next_redo if self.session is not None else None
        if self.session is None or entry is None:
            return None
        self._refuse_while_live()
        change = entry.change
        self.session.redo()
        self._take_changed(change)
        return change

    def _refuse_while_live(self) -> None:
        if self._live_shown and self.session is not None:
            raise EditError(tr("Not changed: stop tracking first, then correct"))

    def _take_changed(self, change: Change) -> None:
        """Make only the lanes of the tracks anew that the change touched."""
        if self.session is None:
            return
        table = self.session.tracks
        frames = change.before.rows["frame"], change.after.rows["frame"]
        marks = self._marks.of(self.session.history)
        self._timeline.take_changed(change.tracks, self._tracks, frames, marks)
        self._timeline.take_reviewed(self.session.labels.reviewed)
        if self.selection and self.selection.track not in table:
            self.selection.choose(0)
