"""A difference between a run and the corrected tracks in words."""

from __future__ import annotations

from dataclasses import dataclass

from tracking.editing.core.scope import frames_text, scope_text
from tracking.tracks import TrackTable

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
        if self.fps is None:
            return frames_text(frames)
        return f"{frames / self.fps:.1f} s" if frames >= self.fps / 10 else frames_text(frames)


def text_of(stretch: Stretch, ends: Ends) -> str:
    """One line, e.g. "7 is tracked 3.2 s longer"."""
    texts = {"identity": _identity, "moved": _moved, "added": _added, "removed": _removed}
    return texts[stretch.kind](stretch, ends)


def _identity(stretch: Stretch, ends: Ends) -> str:
    stops = [ends.table.frame_range(track)[1] for track in (stretch.track, stretch.other)]
    to_the_end = stretch.end >= min(ends.frames[1], max(stops))
    where = scope_text(stretch.start, None if to_the_end else stretch.end)
    if stretch.mutual:
        return f"{stretch.track} and {stretch.other} are swapped {where}"
    new = "" if stretch.other in ends.table else "new track "
    return f"{stretch.track} becomes {new}{stretch.other} {where}"


def _moved(stretch: Stretch, ends: Ends) -> str:
    far = f", by up to {stretch.metres:.1f} m" if stretch.metres > _NO_METRES else ""
    return f"{stretch.track} stands elsewhere for {ends.time(stretch.rows)}{far}"


def _added(stretch: Stretch, ends: Ends) -> str:
    first, stop = ends.table.frame_range(stretch.track)
    time = ends.time(stretch.rows)
    if first == stop:
        return f"{stretch.track} is a new track of {time}"
    if stretch.start >= stop:
        return f"{stretch.track} is tracked {time} longer"
    if stretch.end <= first:
        return f"{stretch.track} is found {time} earlier"
    return f"{stretch.track} is found for {time} where it had a gap"


def _removed(stretch: Stretch, ends: Ends) -> str:
    first, stop = ends.table.frame_range(stretch.track)
    time = ends.time(stretch.rows)
    at_start = stretch.start <= max(first, ends.frames[0])
    at_end = stretch.end >= min(stop, ends.frames[1])
    if at_start and at_end:
        return f"{stretch.track} is not found, for {time}"
    if at_end:
        return f"{stretch.track} ends {time} earlier"
    if at_start:
        return f"{stretch.track} is found {time} later"
    return f"{stretch.track} is lost for {time}"
