"""Where two tracks most likely changed over."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.editing.identity.courses import Courses, Floats, Frames, courses_of, turned_over
from tracking.editing.identity.looks import looks_changed
from tracking.errors import EditError
from tracking.tracks import Columns, TrackTable, check_known

_REACH_M = 0.55
_APART_WEIGHT = 2.0
"""People change over where they meet: what twice, three times the reach apart counts against it."""
_NEAR_FRAMES, _NEAR_WEIGHT = 150.0, 1.5
"""How the frame the user looks at counts: of two cuts about as good the nearer one wins."""
_PEAK_FRAMES = 10
"""Two proposals are at least so far apart."""
_MOST_FRAMES = 50_000
"""Of longer meetings only the closest frames are judged."""
_AROUND_FRAMES, _MET_M = 4000, 2.0
"""So far around the frame looked at is looked first; farther where they did not meet there."""


@dataclass(frozen=True, slots=True)
class SwapFrame:
    """A frame in which two tracks may have changed over.

    Attributes:
        frame: the first one in which they should bear each other's name.
        likelihood: 0 to 1, that it was here or within two frames, if they changed over at all.
        text: why, in words.
    """

    frame: int
    likelihood: float
    text: str


def propose_swap_frames(
    table: TrackTable,
    a: int,
    b: int,
    near: int | None = None,
    signals: Columns | None = None,
    most: int = 5,
) -> tuple[SwapFrame, ...]:
    """The frames in which a and b most likely changed over, likeliest first; at least one.

    Every frame of their time together is judged as a cut by what speaks for it: that each walk
    goes on as the other's rather than as its own, in place and direction; that clothes and height
    go over from one to the other; and how close they were. On the floor, or between the boxes
    where there are no metres, taking people as of usual height.

    Args:
        table, a, b: the tracks.
        near: the frame the user looks at; of two cuts about as good the nearer one wins.
        signals: `SIGNAL_COLUMNS` of the two (see `signals_of`); None: nothing was noticed.
        most: so many at most, each a good number of frames from the others.

    Returns:
        People who stand together and look alike give several of low likelihood.

    Raises:
        EditError: unknown or equal tracks.
    """
    check_known(table, a, b)
    if a == b:
        raise EditError(f"track {a} cannot change over with itself; choose two different tracks")
    both = np.intersect1d(table.frames_of_track(a), table.frames_of_track(b), assume_unique=True)
    courses, frames = _meeting(table, a, b, near)
    if not (len(both) and len(frames)):
        later = max(table.frame_range(a)[0], table.frame_range(b)[0])
        return (SwapFrame(later, 1.0, "they never stand in one frame; the later one begins here"),)
    walks = turned_over(courses, frames)
    looks = looks_changed(signals, a, b, frames)
    apart = _apart(courses, frames)
    score = walks + looks - _APART_WEIGHT * np.log1p(np.square(apart / _REACH_M))
    if near is not None:
        score = score - _NEAR_WEIGHT * np.minimum(np.abs(frames - near) / _NEAR_FRAMES, 2.0)
    share = np.exp(score - score.max())
    share /= share.sum()
    proposals = (
        SwapFrame(
            int(frames[at]),
            _around(frames, share, at),
            _text(walks[at], looks[at], apart[at], courses),
        )
        for at in _peaks(frames, score, most)
    )
    return tuple(sorted(proposals, key=lambda proposal: -proposal.likelihood))


def _meeting(table: TrackTable, a: int, b: int, near: int | None) -> tuple[Courses, Frames]:
    """Where both went, and the frames that may be cuts: around the frame looked at or all."""
    if near is not None:
        around = (max(near - _AROUND_FRAMES, 0), near + _AROUND_FRAMES)
        courses = courses_of(table, a, b, *around)
        frames = _cuts(courses)
        if len(frames) and _apart(courses, frames).min() < _MET_M:
            return courses, frames
    courses = courses_of(table, a, b)
    return courses, _cuts(courses)


def _cuts(courses: Courses) -> Frames:
    """The frames of their time together in which one of the two stands."""
    if not (len(courses.a.frames) and len(courses.b.frames)):
        return courses.a.frames[:0]
    frames = np.sort(np.concatenate([courses.a.frames, courses.b.frames]), kind="stable")
    frames = frames[np.diff(frames, prepend=-1) > 0]
    start = max(courses.a.frames[0], courses.b.frames[0])
    end = min(courses.a.frames[-1], courses.b.frames[-1])
    frames = frames[(frames >= start) & (frames <= end)]
    if len(frames) > _MOST_FRAMES:
        apart = _apart(courses, frames)
        frames = np.sort(frames[np.argpartition(apart, _MOST_FRAMES)[:_MOST_FRAMES]])
    return frames


def _apart(courses: Courses, frames: Frames) -> Floats:
    """(n,) m between them at each cut: the less of the frame and the one before it.

    Where one is missing, between where they were before and are after.
    """
    places = [
        np.column_stack([np.interp(frames, way.frames, way.places[:, axis]) for axis in (0, 1)])
        for way in (courses.a, courses.b)
    ]
    apart = np.linalg.norm(places[0] - places[1], axis=1)
    return np.asarray(np.minimum(apart, np.concatenate([apart[:1], apart[:-1]])))


def _peaks(frames: Frames, score: Floats, most: int) -> list[int]:
    """The best frames, none within the peak's width of a better one."""
    chosen: list[int] = []
    for at in np.argsort(-score, kind="stable").tolist():
        if all(abs(int(frames[at]) - int(frames[other])) > _PEAK_FRAMES for other in chosen):
            chosen.append(at)
        if len(chosen) == most:
            break
    return chosen


def _around(frames: Frames, share: Floats, at: int) -> float:
    """The likelihood that it was here or within two frames."""
    return float(share[np.abs(frames - frames[at]) <= 2].sum())


def _text(walks: float, looks: float, apart: float, courses: Courses) -> str:
    unit = "m" if courses.in_metres else "m or so"
    reasons = [f"{apart:.1f} {unit} apart"]
    if walks > 1:
        reasons.append("each walks on as the other did")
    if looks > 1:
        reasons.append("their looks change over")
    return ", ".join(reasons)
