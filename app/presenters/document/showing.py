"""Which tracks are shown: those of a session, or what a tracker at work has found so far."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

import numpy as np

from app.presenters.correcting import Footing, Ground
from app.presenters.document.live_tracks import ContinuedTracks, LiveTracks
from app.presenters.document.session_tracks import SessionTracks
from app.presenters.document.shown import WholeTracks
from app.presenters.pictures.of_run import AtWork, MadeBy
from app.presenters.track_colours import TrackColours
from tracking.pipeline import KeptSteps
from tracking.session import Session
from tracking.trackers import StepResult
from tracking.tracks import Columns, Labels, TrackLabel, TrackTable

_LOOKS = 40
"""In so many of a new track's frames, evenly spread, it is looked who else is there."""
_AT_ONCE_ROWS = 50_000
"""Up to so many rows tracks are given their colours in a few milliseconds."""


@dataclass(frozen=True, slots=True, eq=False)
class Colours:
    """Colours that are due.

    Attributes:
        make: makes them, on any thread. met: ids that were edited meanwhile.
    """

    make: Callable[[], TrackColours]
    met: set[int] = field(default_factory=set)


class Showing:
    """The tracks of a session once there is one, but for the time a tracker is at work.

    Attributes:
        session: None: there is none yet.
        is_live: whether the tracks of a tracker at work are shown, not those of the session.
        at_work: whether there is one.
        tracks: the tracks that are shown.
        colours_due: the session's colours, where they are to be made still (see `take_colours`).
    """

    def __init__(self, session: Session | None) -> None:
        self.session = session
        self.is_live, self.at_work = session is None, False
        self._live = LiveTracks()
        self._continues_at: int | None = None
        self._at_work: AtWork | None = None
        self.tracks: WholeTracks = self._chosen()
        self._coloured_with: tuple[Session | None, int | None] = None, None
        self.colours_due: Colours | None = None
        self._own_colours, self._live_colours = TrackColours(), TrackColours()
        self._colour()

    @property
    def colours(self) -> TrackColours:
        """Of the tracks that are shown."""
        return self._live_colours if self._renumbered else self._own_colours

    @property
    def can_look_away(self) -> bool:
        """Whether the session's tracks can be shown while the tracker at work goes on."""
        return self.at_work and self.session is not None and self._continues_at is None

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

    def ground(self, footing: Footing) -> Ground | None:
        """What edits are planned on; nothing yet where there is no session; None: not now."""
        session = self.session
        if session is None:
            return None if self.tracks.ids else Ground(TrackTable(), Labels(), footing)
        if self.is_live or session.read_only:
            return None
        run = session.corrected_run
        signals = run.signals if run is not None else None
        return Ground(session.tracks, session.labels, footing, signals, self.colours)

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
        self._live_colours = TrackColours()
        self.tracks = self._chosen()

    def watch(self, on: bool) -> bool:
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
        colours = self._live_colours if self._continues_at is None else self._own_colours
        for result in found:
            colours.meet(result.tracks)

    def end_live(self) -> None:
        """No tracker is at work any more; what it found stays shown until a session is."""
        self.at_work = False

    def take_session(self, session: Session) -> None:
        """Show a session from now on."""
        self.session = session
        self._live, self.is_live, self.at_work = LiveTracks(), False, False
        self.tracks = self._chosen()
        self._colour()

    def meet(self, rows: Columns) -> None:
        """Take note of rows that an edit made: who is new among them has a colour from now on."""
        tracks = np.unique(rows["track"]).tolist()
        self._meet(self.colours, tracks)
        if self.colours_due is not None:
            self.colours_due.met.update(tracks)

    def _meet(self, colours: TrackColours, tracks: Iterable[int]) -> None:
        """Give colours to tracks of the session in view of all who are there when they are."""
        if self.session is None:
            return
        table = self.session.tracks
        for track in tracks:
            if track in table and not colours.has(track):
                frames = table.frames_of_track(track)
                looks = np.unique(np.linspace(0, len(frames) - 1, _LOOKS).astype(int))
                colours.meet_over(track, (table.of_frame(one) for one in frames[looks].tolist()))

    def take_colours(self, due: Colours, made: TrackColours) -> bool:
        """Show colours that were due; False where others are by now."""
        if due is not self.colours_due or self.session is None:
            return False
        self._meet(made, sorted(due.met))
        self._own_colours, self.colours_due = made, None
        return True

    def _colour(self) -> None:
        """Give the session's tracks colours, unless they have them; many have theirs later."""
        session = self.session
        if session is None or (session, session.adopted_run) == self._coloured_with:
            return
        self._coloured_with = session, session.adopted_run
        table, run = session.tracks.snapshot(), session.corrected_run
        due = Colours(lambda: TrackColours.of_session(table, run))
        self.colours_due = due
        rows = max(len(table), len(run.tracks["frame"]) if run is not None else 0)
        if rows <= _AT_ONCE_ROWS:
            self.take_colours(due, due.make())

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
