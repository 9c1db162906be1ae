"""Colours of a session's tracks: at once, or later where that takes long, and as edits go on."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from app.core.colours.co_occurrence import pairs_in
from app.core.colours.track_colours import TrackColours
from app.core.tracks.track_reader import TrackReader
from tracking.editing import Change
from tracking.session import Session
from tracking.tracks import Columns, Run, TrackTable, between

_LOOKS = 40
"""In so many of a new track's frames, evenly spread, it is looked who else is there."""
_FEW = 8
"""Up to so many new tracks have their colours at once."""
_MOST_GIVEN_AGAIN = 200
"""Of more new tracks than that nobody knows the colours."""
_QUICK_ROWS, _QUICK_TRACKS, _QUICK_PAIRS = 50_000, 100, 20_000
"""Up to here a session's colours are made within the time of one picture on the screen."""
_WHILE_OPENING = 40
"""So many times as much is no wait while a session is being opened, which another thread does."""

Frames = NDArray[np.int32]


@dataclass(frozen=True, slots=True, eq=False)
class PendingColours:
    """Pending colour assignments.

    Attributes:
        make: makes them, on any thread. met: ids that were edited meanwhile.
    """

    make: Callable[[], TrackColours]
    met: set[int] = field(default_factory=set)


class SessionColours:
    """Which colours the tracks of a session have.

    Each is kept from the moment it was given, in the session, too, so that everybody looks the same
    when it is opened again; but those given while others are due are chosen again with these.

    Attributes:
        now: the colours there are. due: those to come, see `take_made`; None: none.
    """

    def __init__(self) -> None:
        self.now = TrackColours()
        self.due: PendingColours | None = None
        self._of: tuple[Session | None, int | None] = None, None
        self._previewed: tuple[Change | None, TrackColours, TrackColours] = None, self.now, self.now

    def take(
        self, session: Session, opening: bool = False, seen: TrackColours | None = None
    ) -> None:
        """Give a session's tracks colours, unless they have them; many have theirs later.

        seen: those in which the same ids were watched while the tracker worked: they stay
            where nobody seen together looks alike.
        """
        if (session, session.adopted_run) == self._of:
            return
        self._of = session, session.adopted_run
        table, run = session.tracks.snapshot(), session.corrected_run
        kept = TrackColours.kept(session.colours)
        if session.colours:
            self.now, first = kept, partial(kept.copy)
        else:
            self.now = self.now if seen is None else seen.copy()
            first = partial(TrackColours.at_first, run, seen)
        make = partial(_as_given, first, session.history.touched_rows, table)
        all_kept = all(map(kept.has, table.track_ids))
        if all_kept or _is_quick(table, run, _WHILE_OPENING if opening else 1):
            self.now, self.due = make(), None
            session.colours = self.now.places
        else:
            self.due = PendingColours(make)

    def meet(self, table: TrackTable, tracks: Iterable[int]) -> None:
        """An edit has touched these: those new among them have colours, many a moment later."""
        touched = tuple(tracks)
        new = [one for one in touched if one in table and not self.now.has(one)]
        if self.due is not None:
            self.due.met.update(touched)
        elif len(new) > _FEW:
            given, known = self.now.copy(), table.snapshot()
            self.due = PendingColours(lambda: given.and_of(known))
        if len(new) <= _FEW:
            frames = {one: table.frames_of_track(one) for one in new}
            _give(self.now, frames, touched, table.of_frame)

    def preview(self, table: TrackTable, after: TrackReader, change: Change) -> TrackColours:
        """The colours as a change would leave them; it stays without trace in those there are.

        Args:
            table: as it is. after: the tracks as they would be.
        """
        known, before, colours = self._previewed
        if known is change and before is self.now:
            return colours
        new = [one for one in change.tracks if one not in table and not self.now.has(one)]
        colours = self.now
        if 0 < len(new) <= _FEW:
            colours = colours.copy()
            frames = {one: _frames_after(table, change, one) for one in new}
            _give(colours, frames, change.tracks, after.of_frame)
        self._previewed = change, self.now, colours
        return colours

    def take_made(self, due: PendingColours, made: TrackColours, table: TrackTable) -> bool:
        """Take colours that were due; False where others are by now."""
        if due is not self.due:
            return False
        self.now, self.due = made, None
        session = self._of[0]
        if session is not None:
            session.colours = made.places
        self.meet(table, sorted(due.met))
        return True

    def forget(self, due: PendingColours) -> None:
        """They could not be made: tracks without colours of their own have the usual ones."""
        if due is self.due:
            self.due = None


def _as_given(
    first: Callable[[], TrackColours], touched: NDArray[np.int64], table: TrackTable
) -> TrackColours:
    """Colours of all of a table; who came by an edit has theirs as when it was made.

    So people look as they did where a program ended before it saved their colours.

    Args:
        first: makes those that were there before any edit. touched: see `History.touched_rows`.
    """
    colours = first()
    new = [one for one in table.track_ids if not colours.has(one)]
    edits = np.unique(touched[np.isin(touched[:, 1], new), 0])
    for edit in edits if len(new) <= _MOST_GIVEN_AGAIN else ():
        boxes = touched[touched[:, 0] == edit, 1:]
        of_edit = tuple(np.unique(boxes[:, 0]).tolist())
        frames = {
            one: _between(table.frames_of_track(one), boxes[boxes[:, 0] == one, 1:])
            for one in of_edit
            if one in table and not colours.has(one)
        }
        _give(colours, frames, of_edit, table.of_frame)
    return colours.and_of(table)


def _between(frames: Frames, ranges: NDArray[np.int64]) -> Frames:
    """Those of the frames that are in any of (k, 2) half-open ranges."""
    inside = (frames[:, None] >= ranges[:, 0]) & (frames[:, None] < ranges[:, 1])
    return frames[inside.any(axis=1)]


def _is_quick(table: TrackTable, run: Run | None, patience: int) -> bool:
    rows = [table.columns() if run is None else run.tracks]
    if run is not None and len(table) <= patience * _QUICK_ROWS:
        rows.append(table.columns())
    few = max(len(table), len(rows[0]["frame"])) <= patience * _QUICK_ROWS
    few = few and len(np.unique(rows[0]["track"])) <= patience * _QUICK_TRACKS
    return few and max(map(pairs_in, rows)) <= patience * _QUICK_PAIRS


def _give(
    colours: TrackColours,
    frames_of: dict[int, Frames],
    touched: tuple[int, ...],
    of_frame: Callable[[int], Columns],
) -> None:
    """Give colours to new tracks in view of all who are there when they are.

    Who was touched by the same edit is what a new one was cut from, seldom there with it.
    """
    for track, frames in frames_of.items():
        if not len(frames):
            continue
        looks = np.unique(np.linspace(0, len(frames) - 1, _LOOKS).astype(int))
        beside = [one for one in touched if one != track] if len(touched) <= _FEW else []
        colours.meet_over(track, map(of_frame, frames[looks].tolist()), beside)


def _frames_after(table: TrackTable, change: Change, track: int) -> Frames:
    """The frames in which a track that is new by a change stands."""
    rows = change.after.rows
    parts = [rows["frame"][rows["track"] == track].astype(np.int32)]
    given = change.after.stretches[:, 0] == track
    for before, start, stop in change.before.stretches[given].tolist():
        frames = table.frames_of_track(before)
        parts.append(frames[between(frames, start, stop)])
    return np.unique(np.concatenate(parts))
