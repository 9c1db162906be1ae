"""An open recording with what is known of its people: the model behind the whole window."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from app.core.colours.track_colours import TrackColours
from app.core.document.detector_choice import DetectorChoice, PartSettings
from app.core.document.document_listener import DocumentListener, Marks
from app.core.document.edit_history import EditMarks, HistoryList, track_card
from app.core.document.frame_state_builder import FrameStateBuilder
from app.core.editing import EditFlow, PlannedEdit
from app.core.editing.correction import CorrectionPresenter
from app.core.editing.edit_planner import refuse_too_large
from app.core.i18n import tr
from app.core.scenes import Colour, HistoryItem, TimelineMark, TrackCard
from app.core.tracks.edit_context import EditContext
from app.core.tracks.frame_state import FrameState
from app.core.tracks.made_by import AtWork, MadeBy
from app.core.tracks.recording_geometry import RecordingGeometry
from app.core.tracks.selection import Selection
from app.core.tracks.session_colours import PendingColours
from app.core.tracks.track_reader import WholeTracks
from app.core.tracks.track_source import TrackSource
from app.core.tracks.two_versions import TwoVersions
from tracking.editing import Change, StoredChange
from tracking.errors import EditError, SessionError
from tracking.pipeline import KeptSteps
from tracking.recording import Recording
from tracking.session import Session, resolve_author
from tracking.trackers import StepResult
from tracking.tracks import Labels, ReviewedRange, TrackLabel

Settle = Callable[[Change, Labels], Change]
"""Adds to an edit that is confirmed what it settles."""


class Document:
    """One recording, its session once there is one, and the edit that is being put together.

    Until there is a session, the tracks of the tracker at work are shown. No Qt here: whoever
    calls something that changes the document shows its scenes again afterwards.

    Attributes:
        edited: the tracks that the last edit, undo or redo touched.
        annotate_edits: adds what is known of edits to the list of them.
    """

    def __init__(self, recording: Recording, session: Session | None = None) -> None:
        self.recording = recording
        self.selection = Selection()
        self._track_source = TrackSource(session)
        self._author = ""
        self._geometry = RecordingGeometry.of(recording)
        self.correcting = CorrectionPresenter(self.selection, self._geometry, self._edit_context)
        self._frame_states = FrameStateBuilder(
            self._track_source, self.selection, self.correcting, recording
        )
        self.settle: Settle | None = None
        self.edited: tuple[int, ...] = ()
        self.detector, self.detector_chosen = DetectorChoice(), False
        self.comparison: TwoVersions | None = None
        self._listeners: list[DocumentListener] = []
        self._marks, self._history = EditMarks(), HistoryList()
        self.annotate_edits: Callable[[tuple[HistoryItem, ...]], tuple[HistoryItem, ...]] = tuple

    def tell(self, listener: DocumentListener) -> None:
        """Tell a listener of the tracks as they are, and of every change from now on."""
        self._listeners.append(listener)
        listener.take_tracks(self.tracks, *self._marked())

    @property
    def session(self) -> Session | None:
        """None: nothing has been tracked yet."""
        return self._track_source.session

    @property
    def is_untouched(self) -> bool:
        """Whether nothing was tracked or edited; a session may hold what was drawn at first."""
        return self.session is None or self.session.is_untouched

    @property
    def tracks(self) -> WholeTracks:
        """The tracks that are shown."""
        return self._track_source.tracks

    @property
    def is_live(self) -> bool:
        """Whether the tracks of a tracker at work are shown, not those of the session."""
        return self._track_source.is_live

    @property
    def at_work(self) -> bool:
        """Whether a tracker is at work, whoever is shown."""
        return self._track_source.at_work

    def made_by(self, frame: int) -> MadeBy | None:
        """What made the tracks that are shown in a frame."""
        return self._track_source.made_by(frame)

    @property
    def unread(self) -> SessionError | None:
        """Why particles of the session are not shown; None: they are, or it has none."""
        return self._track_source.unread

    @property
    def tracked_until(self) -> int:
        """One past the last frame a tracker at work has been through."""
        return self._track_source.tracked_until

    @property
    def busiest_frame(self) -> int:
        """The frame with the most people; the first where there are none."""
        return int(self.tracks.activity(self.recording.frame_count).argmax())

    # tracking

    @property
    def parts_asked(self) -> PartSettings:
        """What trackers that follow parts are told: the detector in use, what is drawn."""
        occluders = self.session.labels.occluders if self.session is not None else ()
        return PartSettings(self.detector, occluders)

    def begin_live(
        self,
        continues_at: int | None = None,
        at_work: AtWork | None = None,
        kept: KeptSteps | None = None,
    ) -> None:
        """A tracker starts; what it finds is shown until it has come to its end.

        The corrected tracks of a session stay as they are; where the tracker goes on from them at
        a frame, they are shown before it. `at_work` is the tracker with its settings, `kept`
        where its steps are kept (see `LiveTracks`).
        """
        self.correcting.leave()
        self.selection.choose(0)
        self._track_source.begin_live(continues_at, at_work, kept)
        self._retake()

    def take_live(self, results: Iterable[StepResult]) -> None:
        """Take further results of the tracker at work, in order."""
        found = tuple(results)
        self._track_source.extend(found)
        if self.is_live:
            for listener in self._listeners:
                listener.take_live(self.tracks, found)

    @property
    def shows_further_run(self) -> bool:
        """Whether people of a run beside the session are shown, until somebody looks away."""
        return self.is_live and self._track_source.can_look_away

    def show_live(self, on: bool) -> bool:
        """Show what a further run finds, or the session's tracks meanwhile; whether that changes.

        The session's can be corrected while they are shown, and stay so while an edit waits.
        """
        changed = (self.flow is None or not on) and self._track_source.show_live(on)
        if changed:
            self.correcting.leave()
            self.selection.choose(0)
            self._retake()
        return changed

    def sign(self, author: str) -> None:
        """Log edits made from now on under a name; "": under that of the account."""
        self._author = author
        if self.session is not None:
            self.session.author = resolve_author(author or None)

    def take_session(self, session: Session) -> None:
        """Show a session from now on."""
        self._track_source.take_session(session)
        self.sign(self._author)
        self._marks, self._history = EditMarks(), HistoryList()
        self._retake()

    def rest(self) -> None:
        """The tracker is done; what it found stays shown until it is kept."""
        self._track_source.end_live()

    def end_live(self) -> None:
        """The tracker is done, or failed: show the session again, if there is one."""
        self.rest()
        if self.session is not None:
            self.take_session(self.session)

    def _retake(self) -> None:
        """Other tracks are shown by now."""
        marks, reviewed = self._marked()
        for listener in self._listeners:
            listener.take_tracks(self.tracks, marks, reviewed)

    def _marked(self) -> tuple[Marks, tuple[ReviewedRange, ...]]:
        """Where the tracks that are shown were edited, and what of them was reviewed."""
        if self.session is None or self.is_live:
            return {}, ()
        return self._marks.of(self.session.history), self.session.labels.reviewed

    # what the views show

    def frame_state(self, frame: int) -> FrameState:
        """The frame as the pictures and the floor show it: with what is compared, too."""
        return self._frame_states.build_compared(frame, self.comparison)

    def corrected_state(self, frame: int) -> FrameState:
        """The frame without what is compared: its people are those of the timeline."""
        return self._frame_states.build_corrected(frame)

    def take_review_items(self, review_items: Sequence[TimelineMark]) -> None:
        """Mark what may be wrong, instead of what was marked before."""
        for listener in self._listeners:
            listener.take_review_items(review_items)

    def card(self) -> TrackCard | None:
        """The selected track in words."""
        if not self.selection:
            return None
        track, others = self.selection.track, self.selection.also
        return track_card(self.tracks, track, self.label(track), self.colour_of(track), others)

    def history(self) -> tuple[HistoryItem, ...]:
        """All edits, oldest first."""
        if self.session is None:
            return ()
        return self.annotate_edits(self._history.of(self.session.history))

    def label(self, track: int) -> TrackLabel:
        """What people said of a track; nothing of those a tracker at work has numbered anew."""
        return self._track_source.label(track)

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
        here: list[int] = self.tracks.of_frame(frame)["track"].tolist()
        return here or list(self.tracks.ids)

    def _edit_context(self) -> EditContext | None:
        """What edits are planned on; None: they cannot be planned now."""
        return self._track_source.edit_context(self._geometry)

    def confirm_edit(self) -> Change | None:
        """Do the edit that waits; None where it is not ready. Who is new by it is selected then.

        One that is refused, e.g. by a full disk, waits on, so that Enter tries again.
        """
        change = self.planned.change if self.planned is not None else None
        if change is None:
            return None
        if self.settle is not None and self.session is not None:
            change = self.settle(change, self.session.labels)
        known = set(self.tracks.ids)
        self.apply(change)
        self.correcting.finish()
        new = [track for track in change.tracks if track not in known]
        if len(new) == 1:
            self.selection.choose(new[0])
        return change

    def apply(self, change: Change, written: StoredChange | None = None) -> None:
        """Do a change: on disk first, then shown. written: it, where that is at hand.

        Raises:
            EditError: the tracks shown are not the session's but those of a tracker at work, or
                more would change than the history can keep.
        """
        self.refuse_while_live()
        refuse_too_large(change)
        if self.session is not None:
            self.session.apply(change, written)
            self._take_changed(change)

    def undo(self) -> Change | None:
        """Take the last edit back; what it was, or None where there is none."""
        entry = self.session.history.next_undo if self.session is not None else None
        if self.session is None or entry is None:
            return None
        self.refuse_while_live()
        change = entry.change
        self.session.undo()
        return self._shown(change, change.inverse)

    def redo(self) -> Change | None:
        """Do the edit again that was taken back last."""
        entry = self.session.history.next_redo if self.session is not None else None
        if self.session is None or entry is None:
            return None
        self.refuse_while_live()
        change = entry.change
        self.session.redo()
        return self._shown(change, change)

    def undo_alone(self, edit: int) -> Change:
        """Take one older edit back and leave what was done after it; what was done.

        Raises:
            EditError: a later edit stands on it, or a tracker's people are shown.
        """
        if self.session is None:
            raise EditError("Nothing to undo: there is no session yet")
        self.refuse_while_live()
        change = self.session.undo_alone(edit).change
        return self._shown(change, change)

    def why_not_alone(self, edit: int) -> str:
        """Why an edit cannot be undone alone; "" where it can."""
        return "" if self.session is None else self.session.history.why_not_alone(edit)

    def colour_of(self, track: int) -> Colour:
        """The colour a track has in all views."""
        return self._track_source.colours.of(track)

    @property
    def colours_watched(self) -> TrackColours | None:
        """Colours in which the people of a tracker were seen, until its run is kept."""
        return self._track_source.colours_watched

    @property
    def colours_due(self) -> PendingColours | None:
        """Colours of tracks that are to be made still; None: all are there."""
        return self._track_source.session_colours.due

    def forget_colours(self, due: PendingColours) -> None:
        """They could not be made, and are due no more."""
        self._track_source.session_colours.forget(due)

    def take_colours(self, due: PendingColours, made: TrackColours) -> bool:
        """Show colours that were due; False where others are by now."""
        taken = self._track_source.take_colours(due, made)
        if taken:
            for listener in self._listeners:
                listener.colour_anew()
        return taken

    @property
    def in_the_way(self) -> str:
        """What is to be done before tracks can be corrected, as a tracker's are shown; "" none."""
        if not (self.is_live and self._track_source.at_work):
            return ""
        if self._track_source.can_look_away:
            return tr("move the playhead to your own tracks, or stop tracking first, then correct")
        return tr("stop tracking first, then correct")

    def refuse_while_live(self) -> None:
        """Raises EditError while the tracks of a tracker at work are shown."""
        if self.session is not None and self.in_the_way:
            raise EditError("Not changed: {why}", why=self.in_the_way)

    def refuse_at_work(self) -> None:
        """Raises EditError while a tracker is at work, whoever is shown."""
        if self._track_source.at_work:
            raise EditError("Not changed: stop tracking first")

    def _take_changed(self, change: Change) -> None:
        """Tell of the tracks that the change touched."""
        if self.session is None:
            return
        table = self.session.tracks
        marks, reviewed = self._marks.of(self.session.history), self.session.labels.reviewed
        self._track_source.meet(change)
        self.edited = change.tracks
        for listener in self._listeners:
            listener.take_change(change, self.tracks, marks, reviewed)
        self.selection.keep(track for track in self.selection.all if track in table)

    def _shown(self, change: Change, made: Change) -> Change:
        """The change, once what was made of it is shown; where nobody of it is selected, they are.

        Of an import nobody is.

        made: the change itself where it was done, its inverse where it was taken back.
        """
        self._take_changed(made)
        known = set(self.tracks.ids)
        there = [track for track in change.tracks if track in known]
        imported = change.kind == "import"  # of whole files: about nobody in particular
        if there and not imported and not set(there) & set(self.selection.all):
            self.selection.choose_all(there)
        return change
