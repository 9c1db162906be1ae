"""A difference between a run and the corrected tracks in words."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.editing.core.scope import frames_text, scope_text
from tracking.tracks import TrackTable
from tracking.translation import msg

_NO_METRES = 1e-9


@dataclass(frozen=True, slots=True)
class Stretch:
    """Frames in which one kind of difference holds.

    Attributes:
        kind, track, other, start, end, protected, rows: of the `Difference`.
        metres: how far somebody moved at most; 0 where unknown.
        mutual: the two tracks change over.
    """

    kind: str
    track: int
    other: int
    start: int
    end: int
    protected: bool
    rows: int
    metres: float = 0.0
    mutual: bool = False


@dataclass(frozen=True, slots=True)
class Ends:
    """What a text is told against.

    Attributes:
        table: the corrected tracks. frames: the range that was compared. fps: frames a second.
    """

    table: TrackTable
    frames: tuple[int, int]
    fps: float | None

    def time(self, frames: int) -> str:
        """A number of frames in words: seconds where they can be told."""
        if self.fps is None or frames < self.fps / 10:
            return frames_text(frames)
        return msg("{seconds:.1f} s", seconds=frames / self.fps)


def text_of(stretch: Stretch, ends: Ends) -> str:
    """One line, e.g. "7 is tracked 3.2 s longer"."""
    texts = {"identity": _identity, "moved": _moved, "added": _added, "removed": _removed}
    return texts[stretch.kind](stretch, ends)


def _identity(stretch: Stretch, ends: Ends) -> str:
    stops = [ends.table.frame_range(track)[1] for track in (stretch.track, stretch.other)]
    to_the_end = stretch.end >= min(ends.frames[1], max(stops))
    where = scope_text(stretch.start, None if to_the_end else stretch.end)
    if stretch.mutual:
        return msg(
            "{track} and {other} are swapped {where}",
            track=stretch.track,
            other=stretch.other,
            where=where,
        )
    new = "" if stretch.other in ends.table else msg("new track ")
    return msg(
        "{track} becomes {new}{other} {where}",
        track=stretch.track,
        new=new,
        other=stretch.other,
        where=where,
    )


def _moved(stretch: Stretch, ends: Ends) -> str:
    far = (
        msg(", by up to {metres:.1f} m", metres=stretch.metres)
        if stretch.metres > _NO_METRES
        else ""
    )
    return msg(
        "{track} stands elsewhere for {time}{far}",
        track=stretch.track,
        time=ends.time(stretch.rows),
        far=far,
    )


def _added(stretch: Stretch, ends: Ends) -> str:
    first, stop = ends.table.frame_range(stretch.track)
    time = ends.time(stretch.rows)
    if first == stop:
        return msg("{track} is a new track of {time}", track=stretch.track, time=time)
    if stretch.start >= stop:
        return msg("{track} is tracked {time} longer", track=stretch.track, time=time)
    if stretch.end <= first:
        return msg("{track} is found {time} earlier", track=stretch.track, time=time)
    return msg("{track} is found for {time} where it had a gap", track=stretch.track, time=time)


def _removed(stretch: Stretch, ends: Ends) -> str:
    first, stop = ends.table.frame_range(stretch.track)
    time = ends.time(stretch.rows)
    at_start = stretch.start <= max(first, ends.frames[0])
    at_end = stretch.end >= min(stop, ends.frames[1])
    if at_start and at_end:
        return msg("{track} is not found, for {time}", track=stretch.track, time=time)
    if at_end:
        return msg("{track} ends {time} earlier", track=stretch.track, time=time)
    if at_start:
        return msg("{track} is found {time} later", track=stretch.track, time=time)
    return msg("{track} is lost for {time}", track=stretch.track, time=time)
