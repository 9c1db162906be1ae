"""An open recording with what is known of its people: the model behind the whole window."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from app.presenters.comparing.differences import Comparison
from app.presenters.correcting import (
    EditFlow,
    Footing,
    Ground,
    PlannedEdit,
    PreviewedTracks,
    preview_trails,
    replaced_rows,
)
from app.presenters.correcting.correcting import Correcting
from app.presenters.correcting.planning import refuse_too_large
from app.presenters.document.live_tracks import ContinuedTracks, LiveTracks
from app.presenters.document.selection import Selection
from app.presenters.document.session_tracks import SessionTracks
from app.presenters.document.setting import Instant
from app.presenters.document.shown import ShownTracks
from app.presenters.panels import EditMarks, HistoryList, track_card
from app.presenters.parts.detector_choice import DetectorChoice, PartsAsked
from app.presenters.parts.part_curve import LaneScore
from app.presenters.pictures.overhead import OverheadPresenter
from app.presenters.pictures.pictures import PicturePresenter
from app.presenters.pictures.trails import floor_points
from app.presenters.scenes import HistoryItem, TimelineMark, TimelineScene, TrackCard
from app.presenters.timeline.lanes import TimelinePresenter
from app.presenters.words import tr
from tracking.editing import Change
from tracking.errors import EditError
from tracking.recording import Recording
from tracking.session import Session, author_named
from tracking.trackers import StepResult
from tracking.tracks import Labels, ReviewedRange, Run, TrackLabel, TrackTable

Settle = Callable[[Change, Labels], Change]
"""Adds to an edit that is confirmed what it settles."""


class Document:
    """One recording, its session once there is one, and the edit that is being put together.

    Until there is a session, the tracks of the tracker at work are shown. No Qt here: whoever
    calls something that changes the document shows its scenes again afterwards.
    """

    def __init__(self, recording: Recording, session: Session | None = None) -> None:
        self.recording = recording
        self.session = session
        self.selection = Selection()
        self._author = ""
        self._footing = Footing.of(recording)
        self.correcting = Correcting(self.selection, self._footing, self._ground)
        self.pictures = PicturePresenter(recording)
        self.overhead = OverheadPresenter(recording)
        self._timeline = TimelinePresenter(recording.frame_count, recording.fps)
        self._live, self._live_shown = LiveTracks(), session is None
        self._continues_at: int | None = None
        self.settle: Settle | None = None
        self.detector, self.detector_chosen = DetectorChoice(), False
        self.comparison: Comparison | None = None
        self._marks, self._history = EditMarks(), HistoryList()
        self._retake()

    @property
    def tracks(self) -> ShownTracks:
        """The tracks that are shown."""
        return self._tracks

    @property
    def is_live(self) -> bool:
        """Whether the tracks of a tracker at work are shown, not those of the session."""
        return self._live_shown

    @property
    def tracked_until(self) -> int:
        """One past the last frame a tracker at work has been through."""
        return self._live.frames[1]

    @property
    def busiest_frame(self) -> int:
        """The frame with the most people; the first where there are none."""
        return int(self._tracks.activity(self.recording.frame_count).argmax())

    # tracking

    @property
    def parts_asked(self) -> PartsAsked:
        """What trackers that follow parts are told: the detector in use, what is drawn."""
        occluders = self.session.labels.occluders if self.session is not None else ()
        return PartsAsked(self.detector, occluders)

    def begin_live(self, continues_at: int | None = None) -> None:
        """A tracker starts; what it finds is shown until it has come to its end.

        The corrected tracks of a session stay as they are; where the tracker goes on from them at
        a frame, they are shown before it.
        """
        self.correcting.leave()
        self.selection.choose(0)
        self._live, self._live_shown = LiveTracks(), True
        self._continues_at = continues_at
        self._retake()

    def take_live(self, results: Iterable[StepResult]) -> None:
        """Take further results of the tracker at work, in order."""
        self._live.extend(results)
        self._timeline.take(self._tracks, {})

    def sign(self, author: str) -> None:
        """Log edits made from now on under a name; "": under that of the account."""
        self._author = author
        if self.session is not None:
            self.session.author = author_named(author or None)

    def take_session(self, session: Session) -> None:
        """Show a session from now on."""
        self.session = session
        self.sign(self._author)
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
        if session is not None and self._live_shown and self._continues_at is not None:
            before = SessionTracks(session.tracks, self._adopted)
            self._tracks = ContinuedTracks(before, self._continues_at, self._live)
        marks: dict[int, tuple[TimelineMark, ...]] = {}
        reviewed: tuple[ReviewedRange, ...] = ()
        if session is not None and not self._live_shown:
            self._tracks = SessionTracks(session.tracks, self._adopted)
            marks, reviewed = self._marks.of(session.history), session.labels.reviewed
        self._timeline.take(self._tracks, marks)
        self._timeline.take_reviewed(reviewed)

    @property
    def _adopted(self) -> Run | None:
        """The run the corrected tracks began as."""
        return None if self.session is None else self.session.corrected_run

    # what the views show

    def instant(self, frame: int) -> Instant:
        """The frame as the pictures and the floor show it: with what is compared, too."""
        return self._compared(self._corrected(frame))

    def _corrected(self, frame: int) -> Instant:
        """The corrected tracks; with an edit that waits as they would be after it."""
        planned, flow = self.planned, self.flow
        change = planned.change if planned is not None else None
        shown = planned is not None and change is not None
        return Instant(
            frame=frame,
            tracks=PreviewedTracks(self._tracks, change) if change else self._tracks,
            names=self._names(),
            selected=self.selection.track,
            other=flow.other if flow is not None else 0,
            also=self._emphasised(change),
            preview=preview_trails(planned, floor_points) if planned and shown else (),
            picture_preview=(
                preview_trails(planned, self.pictures.left_foot_points) if planned and shown else ()
            ),
            replaced=replaced_rows(planned, frame),
            movable=self.correcting.can_place,
            drawing=flow is not None and flow.drawing,
        )

    def _compared(self, instant: Instant) -> Instant:
        """The instant with the ways of the people in question in both versions.

        Where two runs are compared, its people are those of the one that is drawn solid.
        """
        comparison, frame, planned = self.comparison, instant.frame, self.planned
        if comparison is None or (planned is not None and planned.change is not None):
            return instant
        if comparison.solid is not None:
            asked = comparison.current
            instant = Instant(
                frame,
                comparison.solid,
                selected=asked.track if asked is not None else 0,
                other=asked.other if asked is not None else 0,
            )
        return replace(
            instant,
            preview=comparison.trails(frame, floor_points),
            picture_preview=comparison.trails(frame, self.pictures.left_foot_points),
        )

    def _emphasised(self, change: Change | None) -> tuple[int, ...]:
        """Who is drawn like the selected person: others selected too, and who is being drawn."""
        new = change.tracks if change is not None and self.flow and not self.flow.track else ()
        return (*self.selection.also, *new)

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
        marked = self.correcting.range_shown
        return self._timeline.scene(playhead, self._corrected(frame), loaded, cut, no_lanes, marked)

    def take_suspicions(self, suspicions: Sequence[TimelineMark]) -> None:
        """Mark on the timeline what may be wrong, instead of what was marked before."""
        self._timeline.take_suspicions(suspicions)

    def take_score(self, score: LaneScore | None) -> None:
        """Show on the timeline how a part of the selected person went; None: nothing."""
        self._timeline.take_score(score)

    def card(self) -> TrackCard | None:
        """The selected track in words."""
        if not self.selection:
            return None
        track, others = self.selection.track, self.selection.also
        return track_card(self._tracks, track, self.label(track), others)

    def history(self) -> tuple[HistoryItem, ...]:
        """All edits, oldest first."""
        return self._history.of(self.session.history) if self.session is not None else ()

    def label(self, track: int) -> TrackLabel:
        """What people said of a track; nothing of those a tracker at work has numbered anew."""
        session = self.session
        if session is None or self._renumbered:
            return TrackLabel()
        return session.labels.of_track(track)

    @property
    def _renumbered(self) -> bool:
        """Whether the ids shown are a tracker's own, not those of the session."""
        return self._live_shown and self._continues_at is None

    def _names(self) -> dict[int, str]:
        if self.session is None or self._renumbered:
            return {}
        return {track: label.name for track, label in self.session.labels.tracks.items()}

    # correcting

    @property
    def flow(self) -> EditFlow | None:
        """The edit on its way."""
        return self.correcting.flow

    @property
    def planned(self) -> PlannedEdit | None:
        """What the edit on its way would do."""
        return self.correcting.planned

    def people_at(self, frame: int) -> list[int]:
        """Who stands in a frame; all there are where nobody does."""
        here: list[int] = self._tracks.of_frame(frame)["track"].tolist()
        return here or list(self._tracks.ids)

    def _ground(self) -> Ground | None:
        """What edits are planned on; nothing yet where there is no session; None: not now."""
        session = self.session
        if session is None:
            idle = not self._tracks.ids
            return Ground(TrackTable(), Labels(), self._footing) if idle else None
        if self._live_shown or session.read_only:
            return None
        run = session.corrected_run
        signals = run.signals if run is not None else None
        return Ground(session.tracks, session.labels, self._footing, signals)

    def confirm_edit(self) -> Change | None:
        """Do the edit that waits; None where it is not ready. Who was drawn is selected then.

        One that is refused, e.g. by a full disk, waits on, so that Enter tries again.
        """
        drawn = self.flow is not None and not self.flow.track
        change = self.planned.change if self.planned is not None else None
        if change is None:
            return None
        if self.settle is not None and self.session is not None:
            change = self.settle(change, self.session.labels)
        self.apply(change)
        self.correcting.finish()
        if drawn:
            self.selection.choose(change.tracks[0])
        return change

    def apply(self, change: Change) -> None:
        """Do a change: on disk first, then shown.

        Raises:
            EditError: the tracks shown are not the session's but those of a tracker at work, or
                more would change than the history can keep.
        """
        self._refuse_while_live()
        refuse_too_large(change)
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
        self._select_touched(change)
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
        self._select_touched(change)
        return change

    def undo_alone(self, edit: int) -> Change:
        """Take one older edit back and leave what was done after it; what was done.

        Raises:
            EditError: a later edit stands on it, or a tracker's people are shown.
        """
        if self.session is None:
            raise EditError(tr("Nothing to undo: there is no session yet"))
        self._refuse_while_live()
        change = self.session.undo_alone(edit).change
        self._take_changed(change)
        self._select_touched(change)
        return change

    def why_not_alone(self, edit: int) -> str:
        """Why an edit cannot be undone alone; "" where it can."""
        return "" if self.session is None else self.session.history.why_not_alone(edit)

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
        self.selection.keep(track for track in self.selection.all if track in table)

    def _select_touched(self, change: Change) -> None:
        """Select who an edit taken back or done again is about, where nobody of them is."""
        known = set(self._tracks.ids)
        there = [track for track in change.tracks if track in known]
        if there and not set(there) & set(self.selection.all):
            self.selection.choose_all(there)
