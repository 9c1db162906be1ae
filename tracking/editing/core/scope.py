"""Which frames and tracks an edit is about: as a value, checked, and put into words."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from tracking.errors import EditError
from tracking.tracks import LARGEST_NUMBER, TrackTable, check_known
from tracking.translation import all_of, msg, some_of

_SCOPE = re.compile(r"(\d{1,10}):(\d{1,10})?", re.ASCII)
_NAMED = 4
"""So many tracks are named one by one in an edit's text."""
FARTHEST_NEW = 1_000_000
"""How far above the highest id ever used a new one may be: ids in between are never given out."""


@dataclass(frozen=True, slots=True)
class Scope:
    """The frames an edit was made for, whatever of them it found rows in.

    Attributes:
        start: the first frame.
        end: one past the last; None: from there on, with all that comes.
    """

    start: int
    end: int | None = None

    @property
    def as_text(self) -> str:
        """As the log keeps it: "834:900", "834:" from there on."""
        return f"{self.start}:{'' if self.end is None else self.end}"

    @classmethod
    def of_text(cls, text: str) -> Scope | None:
        """The scope of a text of the log; None for an empty one.

        Raises EditError where it is none.
        """
        if not text:
            return None
        found = _SCOPE.fullmatch(text)
        scope = found and cls(int(found[1]), int(found[2]) if found[2] else None)
        if not scope or not scope.start < (scope.end or LARGEST_NUMBER + 1) <= LARGEST_NUMBER + 1:
            raise EditError(
                "an edit in the log was made for {text!r}, which are no frames", text=text
            )
        return scope


def scope_text(start: int, end: int | None) -> str:
    """The frames of an edit in words, the last one named, not the one after."""
    if end is None:
        return msg("from frame {start} on", start=start)
    if end == start + 1:
        return msg("in frame {start}", start=start)
    return msg("in frames {start} to {last}", start=start, last=end - 1)


def tracks_text(tracks: Sequence[int]) -> str:
    """Tracks in words: "4", "4 and 7", "1, 2, 4, 7 and 8 more"."""
    if len(tracks) > _NAMED + 1:
        return some_of(tracks, _NAMED)
    return all_of(tracks)


def frames_text(count: int) -> str:
    """A number of frames in words."""
    return msg("{count} frame", count=count) if count == 1 else msg("{count} frames", count=count)


def check_scope(start: int, end: int | None) -> None:
    """Raise EditError for a range that is empty or begins before frame 0; end None: no end."""
    if start < 0 or (end is not None and end <= start):
        raise EditError(
            "frames {start} to {end}: the range is empty or begins before frame 0",
            start=start,
            end=end,
        )


def check_tracks(table: TrackTable, tracks: Iterable[int]) -> tuple[int, ...]:
    """The tracks, each once, ascending. Raises EditError for none at all and for unknown ones."""
    chosen = tuple(sorted(set(tracks)))
    if not chosen:
        raise EditError("no track is chosen; select at least one")
    check_known(table, *chosen)
    return chosen


def check_id(table: TrackTable, track: int) -> None:
    """Raise EditError for an id that is none, and for one far above all that were ever used.

    New tracks are numbered on from the highest id: one slip of a finger would use up all the rest.
    """
    if not 1 <= track <= LARGEST_NUMBER:
        raise EditError(
            "track {track}: ids are 1 to {largest}; choose one of those",
            track=track,
            largest=LARGEST_NUMBER,
        )
    if track > table.highest_track + FARTHEST_NEW:
        raise EditError(
            "track {track} is far above {highest}, the highest id so far; choose one up to "
            "{farthest}",
            track=track,
            highest=table.highest_track,
            farthest=table.highest_track + FARTHEST_NEW,
        )
