"""Passages over lines: who crossed which line, which way, when and where."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tracking.arrays import Flags, Floats, Integers
from tracking.counting.paths import Paths
from tracking.tracks.labels import CountingLine

_ON_LINE = 1e-9
"""Metres or pixels; nearer than that a place is on the line: rounding, not walking."""


@dataclass(frozen=True, slots=True, eq=False)
class Passages:
    """A row for each passage, sorted by time, then line, then track.

    Attributes:
        line: (n,) the number of the line among those that were asked for.
        track: (n,) who passed.
        frame: (n,) the first frame in which they were beyond the line.
        time_s: (n,) when they were on the line, from frame 0; between two frames as if they
            walked straight and evenly.
        forward: (n,) from the left-hand side to the right-hand side.
        place: (n, 2) where they passed, in what the line is drawn in: metres or pixels.
        gap: (n,) how many frames lie between the two places around the line in which the track
            has none; 0: it was seen passing.
    """

    line: Integers
    track: Integers
    frame: Integers
    time_s: Floats
    forward: Flags
    place: Floats
    gap: Integers

    def __len__(self) -> int:
        """The number of passages."""
        return len(self.line)

    def rows(self, kept: Flags | Integers | slice) -> Passages:
        """Some of them."""
        return Passages(
            self.line[kept],
            self.track[kept],
            self.frame[kept],
            self.time_s[kept],
            self.forward[kept],
            self.place[kept],
            self.gap[kept],
        )

    def of_line(self, number: int) -> Passages:
        """Those over one line."""
        return self.rows(self.line == number)

    @property
    def totals(self) -> tuple[int, int]:
        """How many went forward, and how many backward."""
        ahead = int(np.count_nonzero(self.forward))
        return ahead, len(self) - ahead


def passages(
    columns: Mapping[str, ArrayLike],
    fps: float,
    lines: Sequence[CountingLine],
    *,
    jitter_m: float = 0.0,
    jitter_px: float = 0.0,
) -> Passages:
    """All passages of tracks over lines.

    Between two frames a person walks straight, also over frames in which the track has no place
    (`gap` tells). A passage leads from one side of the line to the other through the line itself,
    its ends included. A place on the line belongs to neither side: who comes to it and turns back
    has not passed, who stops on it passes when leaving it for the other side, and a track that
    begins on it has not come from anywhere. PedPy's `compute_crossing_frames` says the same of
    tracks that are never exactly on the line and have no gaps, but for passages into the last
    frame of a track, which it leaves out.

    Args:
        columns: `frame, track` and `x, y` (floor lines) or the box (lines in the picture).
        fps: frames a second.
        jitter_m, jitter_px: who passes and comes back without having been farther from the line
            than this did neither; 0: every passage counts.

    Raises:
        CountingError: a track stands twice in one frame.
    """
    floor = _needed(lines, in_picture=False) and Paths.on_floor(columns)
    feet = _needed(lines, in_picture=True) and Paths.in_picture(columns)
    found = []
    for number, line in enumerate(lines):
        paths, jitter = (feet, jitter_px) if line.in_picture else (floor, jitter_m)
        if isinstance(paths, Paths):
            found.append(passages_of_line(paths, fps, line, number, jitter=jitter))
    return joined(found)


def passages_of_line(
    paths: Paths, fps: float, line: CountingLine, number: int = 0, *, jitter: float = 0.0
) -> Passages:
    """The passages over one line of paths in its own frame of reference; see `passages`."""
    start, end = np.array(line.start, np.float64), np.array(line.end, np.float64)
    distance = _left_of(paths.place, start, end, flipped=line.in_picture)
    side = np.where(np.abs(distance) <= _ON_LINE, 0.0, np.sign(distance)).astype(np.int8)
    came_from = _side_before(side, paths)
    over = np.flatnonzero((side != 0) & (came_from == -side))
    share = _share(distance, side, over)
    place = paths.place[over - 1] + share[:, None] * (paths.place[over] - paths.place[over - 1])
    met = _within(place, start, end)
    over, share, place = over[met], share[met], place[met]
    if jitter > 0 and len(over):
        kept = stays_passed(over, side[over], np.abs(distance), paths.track, jitter)
        over, share, place = over[kept], share[kept], place[kept]
    before = paths.frame[over - 1]
    apart = paths.frame[over] - before
    found = Passages(
        np.full(len(over), number, np.int64),
        paths.track[over],
        paths.frame[over],
        (before + share * apart) / fps,
        side[over] < 0,
        place,
        apart - 1,
    )
    return _by_time(found)


def joined(parts: Sequence[Passages]) -> Passages:
    """Passages over several lines as one table."""
    if not parts:
        none = np.zeros(0, np.int64)
        return Passages(none, none, none, np.zeros(0), np.zeros(0, bool), np.zeros((0, 2)), none)
    columns = zip(*map(_columns, parts), strict=True)
    return _by_time(Passages(*(np.concatenate(column) for column in columns)))


def _columns(part: Passages) -> Iterator[Floats | Integers | Flags]:
    yield from (part.line, part.track, part.frame, part.time_s, part.forward, part.place, part.gap)


def _by_time(found: Passages) -> Passages:
    return found.rows(np.lexsort((found.track, found.line, found.time_s)))


def _needed(lines: Sequence[CountingLine], *, in_picture: bool) -> bool:
    return any(line.in_picture is in_picture for line in lines)


def _left_of(places: Floats, start: Floats, end: Floats, *, flipped: bool) -> Floats:
    """(n,) how far places are left of a line, looking along it; negative: right of it.

    flipped: the second coordinate grows downward.
    """
    along = (end - start) / np.hypot(*(end - start))
    left = along[0] * (places[:, 1] - start[1]) - along[1] * (places[:, 0] - start[0])
    signed: Floats = -left if flipped else left
    return signed


def _side_before(side: np.ndarray[tuple[int], np.dtype[np.int8]], paths: Paths) -> Integers:
    """(n,) the side each track was on last before each row, +1 or -1; 0: on none yet."""
    rows = np.arange(len(side))
    last = np.where(side != 0, rows, -1)
    last = np.maximum.accumulate(last) if len(last) else last
    before = np.concatenate([[-1], last[:-1]])[: len(last)]
    known = before >= paths.first_row
    return np.where(known, side[np.maximum(before, 0)], 0).astype(np.int64)


def _share(
    distance: Floats, side: np.ndarray[tuple[int], np.dtype[np.int8]], over: Integers
) -> Floats:
    """(k,) how much of the way from the row before lay before the line; 0: that row was on it."""
    before, after = np.abs(distance[over - 1]), np.abs(distance[over])
    share: Floats = np.where(side[over - 1] == 0, 0.0, before / (before + after))
    return share


def _within(places: Floats, start: Floats, end: Floats) -> Flags:
    """(k,) whether places on a line's straight continuation lie on the line, ends included."""
    along = end - start
    length = float(np.hypot(*along))
    way = (places - start) @ (along / length)
    inside: Flags = (way >= -_ON_LINE) & (way <= length + _ON_LINE)
    return inside


def stays_passed(
    over: Integers, side: NDArray[np.int8], distance: Floats, track: Integers, jitter: float
) -> Flags:
    """(k,) which passages over one line are kept.

    Two passages of one track in opposite directions, between which it was never farther from the
    line than jitter, take each other out; what remains of a longer to and fro is the one passage
    that leads to the other side, or none.

    Args:
        over: (k,) the rows that are the first beyond the line, ascending.
        side: (k,) the side each leads to, +1 or -1.
        distance: (n,) from the line, at least 0. track: (n,).
    """
    kept = np.ones(len(over), bool)
    waiting: list[int] = []
    for number in range(len(over)):
        last = waiting[-1] if waiting else -1
        if last >= 0 and track[over[last]] == track[over[number]] and side[last] != side[number]:
            farthest = distance[over[last] : over[number]].max()
            if farthest <= jitter:
                kept[[last, number]] = False
                waiting.pop()
                continue
        waiting.append(number)
    return kept
