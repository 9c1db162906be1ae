"""The ways two tracks take, and whether each goes on as the other's."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.editing.boxes.floor_boxes import USUAL_HEIGHT_M, boxes_of, places_of
from tracking.tracks import Columns, TrackTable

Frames = NDArray[np.int32]

_WINDOW, _GUARD = 6, 3
"""Rows on either side of a cut from which a walk is told, and those left out for a second look:
a smoothed path leads from one person to the other in a few frames."""
_OLDEST = 60
"""Frames; what lies farther from a cut tells nothing of it."""
_LEAST_NOISE_M = 0.015
_SWAY = 6e-5
"""m² a frame³: how much people change their velocity."""
_TAIL = 4.0
"""Degrees of freedom of the errors: people turn now and then."""
_LONELY = 6.0
"""What one who ends and another who begins at a cut cost."""
_GUARDED = 0.7


@dataclass(frozen=True, slots=True, eq=False)
class Course:
    """The rows of one track that tell where it is.

    Attributes:
        frames: (n,) ascending. places: (n, 2) m.
        noise_m: how much a place errs.
    """

    frames: Frames
    places: Floats
    noise_m: float


@dataclass(frozen=True, slots=True, eq=False)
class Courses:
    """Two tracks' ways in one unit.

    Attributes:
        a, b: the ways. in_metres: on the floor; else in the picture, a person's height as long as
            usual.
    """

    a: Course
    b: Course
    in_metres: bool


def courses_of(
    table: TrackTable, a: int, b: int, start: int = 0, end: int | None = None
) -> Courses:
    """The ways of two tracks in a half-open range of frames.

    What was only predicted is left out where something was measured.
    """
    rows = [_telling(table.of_track(track, start, end)) for track in (a, b)]
    on_floor = [places_of(part) for part in rows]
    in_metres = all(_mostly_known(places) for places in on_floor)
    places = on_floor if in_metres else _in_picture(rows)
    ways = [_course(part["frame"], where) for part, where in zip(rows, places, strict=True)]
    return Courses(ways[0], ways[1], in_metres)


def swap_gain(courses: Courses, cuts: Frames) -> Floats:
    """(n,) how much more likely each walk goes on as the other's at a cut than as its own.

    A difference of log-likelihoods: rows before and after a cut are joined by lines, and what
    place and velocity of these differ by is judged by how much rows err and people sway. Where
    there is nothing to join, as at the very end of a track, nothing can speak for a cut: it is
    judged as the nearest ones are that can be told, if these are unlikely.
    """
    near, guarded = (_turned_over(courses, cuts, guard) for guard in (0, _GUARD))
    guarded = np.where(np.isnan(guarded), near, guarded)
    return _as_nearby(near + _GUARDED * guarded)


def _turned_over(courses: Courses, cuts: Frames, guard: int) -> Floats:
    """As `swap_gain`; NaN where nothing tells."""
    ways = (courses.a, courses.b)
    led = [_line(way, cuts, guard, after=False) for way in ways]
    came = [_line(way, cuts, guard, after=True) for way in ways]
    own = _cost(led[0], came[0]), _cost(led[1], came[1])
    other = _cost(led[0], came[1]), _cost(led[1], came[0])
    return _difference(own, other)


def _difference(own: tuple[Floats, Floats], other: tuple[Floats, Floats]) -> Floats:
    """(n,) what going on as oneself costs more than going on as the other; NaN: nothing tells.

    Where one of the two walks cannot be told on either side, it is taken to say the same as the
    one that can, if that speaks against changing over: silence speaks for nothing.
    """
    missing = [np.isnan(np.stack(pair)) for pair in (own, other)]
    totals = []
    for pair, lacks in zip((own, other), missing, strict=True):
        total = np.nansum(np.stack(pair), axis=0)
        totals.append(total + np.where(lacks.all(axis=0), 2 * _LONELY, 0.0))
    more = totals[0] - totals[1]
    half = (missing[0].sum(axis=0) == 1) & (missing[1].sum(axis=0) == 1)
    more = np.where(half & (more < 0), 2 * more, more)
    return np.where(missing[0].all(axis=0) & missing[1].all(axis=0), np.nan, more)


def _as_nearby(judged: Floats) -> Floats:
    """(n,) with NaN filled from the nearest that are known, nowhere above 0."""
    known = np.flatnonzero(~np.isnan(judged))
    if not len(known):
        return np.zeros(len(judged))
    nearby = np.interp(np.arange(len(judged)), known, judged[known])
    return np.where(np.isnan(judged), np.minimum(nearby, 0.0), judged)


@dataclass(frozen=True, slots=True, eq=False)
class _Lines:
    """Lines through rows on one side of each cut; NaN where there are none.

    Attributes:
        place: (n, 2) m at the cut. velocity: (n, 2) m a frame. noise: (n, 2) m² and (m/frame)²:
            variances of the two. reach: (n,) frames from the rows' middle to the cut.
    """

    place: Floats
    velocity: Floats
    noise: Floats
    reach: Floats


def _line(way: Course, cuts: Frames, guard: int, *, after: bool) -> _Lines:
    at = np.searchsorted(way.frames, cuts)
    steps = np.arange(_WINDOW) + guard if after else np.arange(-_WINDOW, 0) - guard
    rows = at[:, None] + steps
    moment = cuts - 0.5
    inside = (rows >= 0) & (rows < len(way.frames))
    rows = rows.clip(0, len(way.frames) - 1)
    off = way.frames[rows] - moment[:, None]
    weight = (inside & (np.abs(off) <= _OLDEST)).astype(float)
    count = weight.sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        middle = (weight * off).sum(axis=1) / count
        place = np.einsum("nw,nwc->nc", weight, way.places[rows]) / count[:, None]
        spread = (weight * np.square(off - middle[:, None])).sum(axis=1)
        lever = weight * (off - middle[:, None])
        slope = np.einsum("nw,nwc->nc", lever, way.places[rows]) / spread[:, None]
        error = np.column_stack([1 / count, 1 / spread]) * way.noise_m**2
    return _Lines(place - slope * middle[:, None], slope, error, np.abs(middle))


def _cost(led: _Lines, came: _Lines) -> Floats:
    """(n,) minus the log-likelihood that one walk goes on as the other; NaN: one is missing."""
    span = led.reach + came.reach
    velocity = led.noise[:, 1] + came.noise[:, 1] + _SWAY * span
    reached = led.noise[:, 1] * led.reach**2 + came.noise[:, 1] * came.reach**2
    place = led.noise[:, 0] + came.noise[:, 0] + reached + _SWAY * span**3 / 3
    off = np.square(led.place - came.place).sum(axis=1) / place
    off += np.square(led.velocity - came.velocity).sum(axis=1) / velocity
    return np.asarray((_TAIL + 4) / 2 * np.log1p(off / _TAIL))


def _telling(rows: Columns) -> Columns:
    measured = ~rows["predicted"]
    if np.count_nonzero(measured) < 2:
        return rows
    return {name: column[measured] for name, column in rows.items()}


def _mostly_known(places: Floats) -> bool:
    return bool(2 * np.count_nonzero(np.isfinite(places).all(axis=1)) >= len(places))


def _in_picture(rows: list[Columns]) -> list[Floats]:
    """Middles of boxes, in metres as if people were of usual height."""
    boxes = [boxes_of(part) for part in rows]
    heights = np.concatenate([part[:, 3] for part in boxes])
    heights = heights[heights > 0]
    scale = USUAL_HEIGHT_M / float(np.median(heights)) if len(heights) else 1.0
    return [(part[:, :2] + part[:, 2:] / 2) * scale for part in boxes]


def _course(frames: Frames, places: Floats) -> Course:
    known = np.isfinite(places).all(axis=1)
    if not known.any():
        return Course(frames, np.zeros((len(frames), 2)), 1.0)
    frames, places = frames[known], places[known]
    bends = (
        np.diff(places, n=2, axis=0)[np.diff(frames, n=2) == 0] if len(frames) > 2 else places[:0]
    )
    noise = float(np.median(np.abs(bends))) / 0.6745 / np.sqrt(6.0) if len(bends) else 0.0
    return Course(frames, places, max(noise, _LEAST_NOISE_M))
