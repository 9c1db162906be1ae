"""Which tracks are shown: those of a session, or what a tracker at work has found so far."""

from __future__ import annotations

from collections.abc import Iterable

from app.core.colours.track_colours import TrackColours
from app.core.tracks.edit_context import EditContext
from app.core.tracks.live_tracks import ContinuedTracks, LiveTracks
from app.core.tracks.made_by import AtWork, MadeBy
from app.core.tracks.recording_geometry import RecordingGeometry
from app.core.tracks.session_colours import PendingColours, SessionColours
from app.core.tracks.session_tracks import SessionTracks
from app.core.tracks.track_reader import TrackReader, WholeTracks
from tracking.editing import Change
from tracking.errors import SessionError
from tracking.pipeline import KeptSteps
from tracking.session import Session
from tracking.trackers import StepResult
from tracking.tracks import Labels, TrackLabel, TrackTable


class TrackSource:
    """The tracks of a session once there is one, but for the time a tracker is at work.

    Attributes:
        session: None: there is none yet.
        is_live: whether the tracks of a tracker at work are shown, not those of the session.
        at_work: whether there is one.
        tracks: the tracks that are shown.
        session_colours: the colours of the session's tracks.
    """

    def __init__(self, session: Session | None) -> None:
        self.session = session
        self.is_live, self.at_work = session is None, False
        self._live = LiveTracks()
        self._continues_at: int | None = None
        self._at_work: AtWork | None = None
        self.tracks: WholeTracks = self._chosen()
        self.session_colours, self._live_colours = SessionColours(), TrackColours()
        self._watched: TrackColours | None = None  # a tracker's ids, until its run is kept
        if session is not None:
            self.session_colours.take(session, opening=True)

    @property
    def colours(self) -> TrackColours:
        """Of the tracks that are shown."""
        return self._live_colours if self.is_live else self.session_colours.now

    @property
    def colours_watched(self) -> TrackColours | None:
        """Those in which the people of a tracker were seen, until its run is kept; a copy."""
        return None if self._watched is None else self._watched.copy()

    @property
    def can_look_away(self) -> bool:
        """Whether the session's tracks can be shown while the tracker at work goes on."""
        shows_some = self.session is not None and not self.session.is_untouched
        return self.at_work and shows_some and self._continues_at is None

    @property
    def unread(self) -> SessionError | None:
        """Why the session's particles could not be read last; None: they could."""
        return self.tracks.unread if isinstance(self.tracks, SessionTracks) else None

    @property
    def tracked_until(self) -> int:
        """One past the last frame a tracker at work has been through."""
        return self._live.frames[1]

    @property
    def names(self) -> dict[int, str]:
        """What people called the tracks; nothing where they are numbered anew."""
        if self.session is None or self._renumbered:
            return {}
        return {track: label.name for track, label in self.session.labels.tracks.items()}

    def label(self, track: int) -> TrackLabel:
        """What people said of a track; nothing of those a tracker at work has numbered anew."""
        if self.session is None or self._renumbered:
            return TrackLabel()
        return self.session.labels.of_track(track)

    def edit_context(self, geometry: RecordingGeometry) -> EditContext | None:
        """What edits are planned on; nothing yet where there is no session; None: not now."""
        session = self.session
        if session is None:
            return None if self.tracks.ids else EditContext(TrackTable(), Labels(), geometry)
        if self.is_live or session.read_only:
            return None
        run = session.corrected_run
        signals = run.signals if run is not None else None
        return EditContext(session.tracks, session.labels, geometry, signals, self.colours)

    def made_by(self, frame: int) -> MadeBy | None:
        """What made the tracks that are shown in a frame; None: nothing is known of that."""
        if self.is_live and frame >= (self._continues_at or 0):
            return self._at_work
        return None if self.session is None else self.session.corrected_run

    def begin_live(
        self, continues_at: int | None, at_work: AtWork | None = None, kept: KeptSteps | None = None
    ) -> None:
        """Show what a tracker finds from now on; before `continues_at`, if any, the session.

        kept: see `LiveTracks`.
        """
        self._live, self.is_live, self.at_work = LiveTracks(kept), True, True
        self._at_work = at_work
        self._continues_at = continues_at
        # What is kept of a run that goes on from tracks is decided later: its ids leave no trace.
        self._live_colours = (
            TrackColours() if continues_at is None else self.session_colours.now.copy()
        )
        self._watched = self._live_colours if continues_at is None else None
        self.tracks = self._chosen()

    def show_live(self, on: bool) -> bool:
        """Show what the tracker at work finds, or the session's tracks; whether that changes."""
        if not self.can_look_away or on is self.is_live:
            return False
        self.is_live = on
        self.tracks = self._chosen()
        return True

    def extend(self, results: Iterable[StepResult]) -> None:
        """Take further results of the tracker at work, in order."""
        found = tuple(results)
        self._live.extend(found)
        for result in found:
            self._live_colours.meet(result.tracks)

    def end_live(self) -> None:
        """No tracker is at work any more; what it found stays shown until a session is."""
        self.at_work = False

    def take_session(self, session: Session) -> None:
        """Show a session from now on."""
        self.session = session
        self._live, self.is_live, self.at_work = LiveTracks(), False, False
        self.tracks = self._chosen()
        seen, self._watched = self._watched, None
        self.session_colours.take(session, seen=seen)

    def meet(self, change: Change) -> None:
        """Take note of an edit: who is new by it has a colour from now on."""
        if self.session is not None:
            self.session_colours.meet(self.session.tracks, change.tracks)

    def colours_after(self, change: Change, tracks: TrackReader) -> TrackColours:
        """The colours as an edit that waits would leave them; `tracks`, as they would be."""
        table = self.session.tracks if self.session is not None else TrackTable()
        return self.session_colours.preview(table, tracks, change)

    def take_colours(self, due: PendingColours, made: TrackColours) -> bool:
        """Show colours that were due; False where others are by now."""
        return self.session is not None and self.session_colours.take_made(
            due, made, self.session.tracks
        )

    def _chosen(self) -> WholeTracks:
        if self.session is None:
            return self._live
        if not self.is_live:
            return SessionTracks(self.session.tracks, self.session.corrected_run)
        if self._continues_at is None:
            return self._live
        before = SessionTracks(self.session.tracks, self.session.corrected_run)
        return ContinuedTracks(before, self._continues_at, self._live)

    @property
    def _renumbered(self) -> bool:
        """Whether the ids shown are a tracker's own, not those of the session."""
        return self.is_live and self._continues_at is None
