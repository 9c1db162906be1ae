"""Where two tracks most likely changed over."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.editing.identity.courses import Courses, Frames, courses_of, swap_gain
from tracking.errors import EditError
from tracking.tracks import CLOTHES, Columns, TrackTable, check_known
from tracking.translation import Message, joined, msg

_REACH_M = 0.55
_APART_WEIGHT = 2.0
"""People change over where they meet: what twice, three times the reach apart counts against it."""
_NEAR_FRAMES, _NEAR_WEIGHT = 150.0, 1.5
"""How the frame the user looks at counts: of two cuts about as good the nearer one wins."""
_SPEAKS = 1.0
"""So much likelier than not, as a difference of log-likelihoods, ways or looks are named."""
_PEAK_FRAMES = 10
"""Two proposals are at least so far apart."""
_MOST_FRAMES = 50_000
"""Of longer meetings only the closest frames are judged."""
_AROUND_FRAMES, _MET_M = 4000, 2.0
"""So far around the frame looked at is looked first; farther where they did not meet there."""


_WINDOW = 40
"""Frames on either side of a cut; longer, and the next change over is among them."""
_NOISE = {**dict.fromkeys(CLOTHES, 7.0), "height_m": 0.07}
"""How much each errs from one look at a person to the next, light and pose included."""
_TOGETHER = 8.0
"""So many frames on end tell as much as one look: light and pose change slowly."""
_LARGEST = 14.0
_TOLD_M = 0.1
"""Of two distances that differ by more it is said which one is meant."""


@dataclass(frozen=True, slots=True)
class SwapFrame:
    """A frame in which two tracks may have changed over.

    Attributes:
        frame: the first one in which they should bear each other's name.
        likelihood: 0 to 1, that it was here or within two frames, if they changed over at all.
        text: why, in words.
        shown: how they walk or how they look speaks for it.
        apart_m: how far apart they were there, or in the frame before where that is less; NaN
            where there are no metres.
    """

    frame: int
    likelihood: float
    text: str
    shown: bool = True
    apart_m: float = float("nan")


def propose_swap_frames(
    table: TrackTable,
    a: int,
    b: int,
    near: int | None = None,
    signals: Columns | None = None,
    most: int = 5,
    flagged: tuple[int, int] | None = None,
) -> tuple[SwapFrame, ...]:
    """The frames in which a and b most likely changed over, likeliest first; at least one.

    Every frame of their time together is judged as a cut by what speaks for it: that each walk
    goes on as the other's rather than as its own, in place and direction; that clothes and height
    go over from one to the other; and how close they were. On the floor, or between the boxes
    where there are no metres, taking people as of usual height.

    Args:
        table, a, b: the tracks.
        near: the frame the user looks at; of two cuts about as good the nearer one wins.
        signals: `SIGNAL_COLUMNS` of the two; None: nothing was noticed.
        most: so many at most, each a good number of frames from the others.
        flagged: half-open frames in which a review item says they may have swapped. What is
            likeliest in there comes first, and where nothing shows it what is nearest to `near`;
            behind it only what walks or looks speak for.

    Returns:
        People who stand together and look alike give several of low likelihood.

    Raises:
        EditError: unknown or equal tracks.
    """
    check_known(table, a, b)
    if a == b:
        raise EditError("track {a} cannot be swapped with itself; choose two different tracks", a=a)
    both = np.intersect1d(table.frames_of_track(a), table.frames_of_track(b), assume_unique=True)
    courses, frames = _meeting(table, a, b, near)
    if not (len(both) and len(frames)):
        later = max(table.frame_range(a)[0], table.frame_range(b)[0])
        return (
            SwapFrame(later, 1.0, msg("they never stand in one frame; the later one begins here")),
        )
    judged = _judged(courses, frames, looks_changed(signals, a, b, frames), near)
    first = _frame_in_flagged(judged, near, flagged)
    if first is not None:
        behind = judged.shown | (np.arange(len(frames)) == first)
        judged = replace(judged, score=np.where(behind, judged.score, -np.inf))
    return judged.best(most, first, courses)


@dataclass(frozen=True, slots=True)
class _Judged:
    """Every frame of their time together as a cut.

    Attributes:
        frames: (n,). walks, looks: (n,) log-likelihood ratios that they changed over there.
        apart: (n,) m between them, there or in the frame before: see `_apart`. here: (n,) there.
        score: (n,) all together; -inf: it is not proposed.
    """

    frames: Frames
    walks: Floats
    looks: Floats
    apart: Floats
    here: Floats
    score: Floats

    @property
    def shown(self) -> NDArray[np.bool_]:
        """(n,) how they walk or how they look speaks for it."""
        return np.asarray(np.maximum(self.walks, self.looks) > _SPEAKS)

    def best(self, most: int, first: int | None, courses: Courses) -> tuple[SwapFrame, ...]:
        """What to propose: the cut `first`, if any, then the others, the likeliest before."""
        share = np.exp(self.score - self.score.max())
        share /= share.sum()
        shown = self.shown
        proposals = {
            at: SwapFrame(
                int(self.frames[at]),
                _around(self.frames, share, at),
                self._text(at, courses),
                bool(shown[at]),
                float(self.apart[at]) if courses.in_metres else float("nan"),
            )
            for at in _peaks(self.frames, self.score, most, first)
        }
        order = sorted(proposals, key=lambda at: (at != first, -proposals[at].likelihood))
        return tuple(proposals[at] for at in order)

    def _text(self, at: int, courses: Courses) -> str:
        before = self.here[at] - self.apart[at] > _TOLD_M
        reasons = [_apart_text(self.apart[at], before, courses.in_metres)]
        if self.walks[at] > _SPEAKS:
            reasons.append(msg("each walks on as the other did"))
        if self.looks[at] > _SPEAKS:
            reasons.append(msg("their appearances swap"))
        return joined(", ", reasons)


def _judged(courses: Courses, frames: Frames, looks: Floats, near: int | None) -> _Judged:
    """What speaks for each cut; see `propose_swap_frames`."""
    walks, (apart, here) = swap_gain(courses, frames), _apart(courses, frames)
    score = walks + looks - _APART_WEIGHT * np.log1p(np.square(apart / _REACH_M))
    if near is not None:
        score = score - _NEAR_WEIGHT * np.minimum(np.abs(frames - near) / _NEAR_FRAMES, 2.0)
    return _Judged(frames, walks, looks, apart, here, score)


def _frame_in_flagged(
    judged: _Judged, near: int | None, flagged: tuple[int, int] | None
) -> int | None:
    """The likeliest cut in the flagged range of frames; None without one."""
    frames, shown = judged.frames, judged.shown
    low, high = np.searchsorted(frames, flagged if flagged is not None else (0, 0))
    if low == high:
        return None
    if near is not None and not shown[low:high].any():
        return int(low + np.argmin(np.abs(frames[low:high] - near)))
    said = np.where(shown[low:high] | (near is None), judged.score[low:high], -np.inf)
    return int(low + np.argmax(said))


def _meeting(table: TrackTable, a: int, b: int, near: int | None) -> tuple[Courses, Frames]:
    """Where both went, and the frames that may be cuts: around the frame looked at or all."""
    if near is not None:
        around = (max(near - _AROUND_FRAMES, 0), near + _AROUND_FRAMES)
        courses = courses_of(table, a, b, *around)
        frames = _cuts(courses)
        if len(frames) and _apart(courses, frames)[0].min() < _MET_M:
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
        apart, _ = _apart(courses, frames)
        frames = np.sort(frames[np.argpartition(apart, _MOST_FRAMES)[:_MOST_FRAMES]])
    return frames


def _apart(courses: Courses, frames: Frames) -> tuple[Floats, Floats]:
    """(n,) m between them at each cut: the less of the frame and the one before it; in the frame.

    Where one is missing, between where they were before and are after.
    """
    places = [
        np.column_stack([np.interp(frames, way.frames, way.places[:, axis]) for axis in (0, 1)])
        for way in (courses.a, courses.b)
    ]
    apart = np.linalg.norm(places[0] - places[1], axis=1)
    return np.asarray(np.minimum(apart, np.concatenate([apart[:1], apart[:-1]]))), apart


def _peaks(frames: Frames, score: Floats, most: int, first: int | None) -> list[int]:
    """The best frames, none within the peak's width of a better one, nor of the `first`."""
    chosen: list[int] = [] if first is None else [first]
    for at in np.argsort(-score, kind="stable").tolist():
        if len(chosen) == most or score[at] == -np.inf:
            break
        if all(abs(int(frames[at]) - int(frames[other])) > _PEAK_FRAMES for other in chosen):
            chosen.append(at)
    return chosen


def _around(frames: Frames, share: Floats, at: int) -> float:
    """The likelihood that it was here or within two frames."""
    return float(share[np.abs(frames - frames[at]) <= 2].sum())


def _apart_text(apart: float, before: bool, in_metres: bool) -> Message:
    """How close they were; before: in the frame before, closer than in the cut's own."""
    if before:
        return msg(
            "{apart:.1f} m apart just before" if in_metres else "{apart:.1f} m or so just before",
            apart=apart,
        )
    return msg("{apart:.1f} m apart" if in_metres else "{apart:.1f} m or so apart", apart=apart)


def looks_changed(signals: Columns | None, a: int, b: int, cuts: NDArray[np.int32]) -> Floats:
    """(n,) how much more likely looks change over at a cut than stay: log-likelihoods' difference.

    What differs between the two is averaged before and after: the same person looks the same, so
    with names changed over the two differ the other way round.
    """
    score = np.zeros(len(cuts))
    if signals is None or not len(signals.get("frame", ())):
        return score
    first, stop = int(cuts[0]) - _WINDOW, int(cuts[-1]) + _WINDOW
    for name, noise in _NOISE.items():
        differ = _by_frame(signals, a, name, first, stop) - _by_frame(signals, b, name, first, stop)
        known = np.isfinite(differ)
        counts = np.concatenate([[0], np.cumsum(known)])
        sums = np.concatenate([[0.0], np.cumsum(np.where(known, differ, 0.0))])
        at = cuts - first
        before, after = (at - _WINDOW, at), (at, np.minimum(at + _WINDOW, stop - first))
        n, m = (counts[end] - counts[start] for start, end in (before, after))
        total = [sums[end] - sums[start] for start, end in (before, after)]
        means = [part / np.maximum(number, 1) for part, number in zip(total, (n, m), strict=True)]
        looks = n * m / np.maximum(n + m, 1) / _TOGETHER
        score -= looks * means[0] * means[1] / noise**2
    return _LARGEST * np.tanh(score / _LARGEST)


def _by_frame(signals: Columns, track: int, name: str, first: int, stop: int) -> Floats:
    """(stop - first,) a track's signal in each frame; NaN where it has none."""
    values = np.full(stop - first, np.nan)
    own = signals["track"] == track
    frames = signals["frame"][own]
    inside = (frames >= first) & (frames < stop)
    values[frames[inside] - first] = signals[name][own][inside]
    return values
