"""What would change if a run were taken, told before it is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags
from tracking.editing.log.history import History
from tracking.editing.tracking_again.alignment import Alignment, Exchange, align, exchangeable
from tracking.editing.tracking_again.counterparts import HERE_M
from tracking.editing.tracking_again.difference_text import Ends, Stretch, text_of
from tracking.editing.tracking_again.protection import Protection, find_protected
from tracking.progress import Progress
from tracking.tracks import Columns, Labels, Run, TrackTable

Integers = NDArray[np.integer]

_JOINED_FRAMES = 5
"""Differences of one kind with no more frames between them are told as one."""
_USUAL_FPS = 20.0
_STEPS = 7
"""Of comparing, each told: the run laid over the table, sorted, four kinds, folded."""


_SMALL_S, _SMALL_FRAMES = 0.2, 4
"""What is shorter says little by itself."""
_REACH_S, _REACH_FRAMES = 1.0, 20
"""So far apart, what is small joins its neighbour."""


@dataclass(frozen=True, slots=True)
class Difference:
    """A stretch in which a run says something else than the corrected tracks.

    Attributes:
        track: the corrected track it is about; of one that would be new, its id.
        other: of an identity, who that person would be then; else 0.
        start, end: half-open range of frames.
        kind: "moved" (the same person elsewhere), "identity" (somebody else's id), "added" (rows
            where the track has none) or "removed" (the opposite).
        text: as people read it.
        protected: a person's work stands there; it is not taken.
        rows: how many rows differ.
    """

    track: int
    other: int
    start: int
    end: int
    kind: str
    text: str
    protected: bool
    rows: int

    @property
    def tracks(self) -> tuple[int, ...]:
        """The tracks that would change."""
        return (self.track, self.other) if self.other else (self.track,)


def differences(
    table: TrackTable,
    labels: Labels,
    history: History,
    run: Run,
    frames: tuple[int, int] | None,
    *,
    fps: float | None = None,
) -> tuple[Difference, ...]:
    """What would change if a run were taken in a range of frames, by frame and track.

    The ids are those that the tracks would have then: see `run_identities.named`. What is too
    small to be read by itself is told with its neighbour, or not at all: see `merge_small`.

    Args:
        frames: half-open; None: all the run was run over.
        fps: frames a second; without it the texts count frames.

    Raises EditError where the run was not run over any of these frames.
    """
    protection = find_protected(table, labels, history, fps=fps)
    return _told(align(table, run, frames, protection), table, fps)


def compare_runs(
    run_a: Run, run_b: Run, *, fps: float | None = None, progress: Progress | None = None
) -> tuple[tuple[Difference, ...], TrackTable, TrackTable]:
    """What run b says otherwise than run a in the frames of both, and both as tables in a's ids.

    progress: as of `compare_to_table`.
    Raises EditError where the two were not run over the same frames.
    """
    shared = max(run_a.frames[0], run_b.frames[0]), min(run_a.frames[1], run_b.frames[1])
    if not (run_a.known_tracks and run_b.known_tracks):
        run_b = replace(run_b, known_tracks=0)
    table = TrackTable(run_a.tracks, highest_track=run_a.known_tracks)
    found, rows = compare_to_table(table, run_b, shared, Protection(), fps=fps, progress=progress)
    return found, table, TrackTable(rows)


def compare_to_table(
    table: TrackTable,
    run: Run,
    frames: tuple[int, int] | None,
    protection: Protection,
    *,
    fps: float | None = None,
    progress: Progress | None = None,
) -> tuple[tuple[Difference, ...], Columns]:
    """What a run says otherwise than a table, and the run's rows under the table's ids, by frame.

    progress: is told how many steps of how many are done; what it raises ends the work.
    Raises EditError where the run was not run over any of these frames.
    """
    report = progress or _nobody
    report(0, _STEPS)
    both = align(table, run, frames, protection)
    report(1, _STEPS)
    order = np.lexsort((both.found["track"], both.found["frame"]))
    rows = {name: column[order] for name, column in both.found.items()}
    report(2, _STEPS)
    return _told(both, table, fps, report), rows


def _nobody(_done: int, _steps: int) -> None:
    """Nobody asked how far it is."""


def _told(
    found: Alignment, table: TrackTable, fps: float | None, report: Progress = _nobody
) -> tuple[Difference, ...]:
    """The differences of a run laid over the table, by frame and track."""
    gap = _JOINED_FRAMES if fps is None else max(1, round(_JOINED_FRAMES * fps / _USUAL_FPS))
    taken = exchangeable(found)
    parts: list[Stretch] = []
    for done, kind in enumerate((_changed_ids, _moved, _added, _removed), 3):
        report(done, _STEPS)
        parts += kind(found, taken, gap)
    every = merge_small(parts, fps)
    report(_STEPS, _STEPS)
    ends = Ends(table, found.frames, fps)
    told = [
        Difference(
            each.track,
            each.other,
            each.start,
            each.end,
            each.kind,
            text_of(each, ends),
            each.protected,
            each.rows,
        )
        for each in every
    ]
    return tuple(sorted(told, key=lambda one: (one.start, one.track, one.kind, one.end)))


def _changed_ids(found: Alignment, taken: Exchange, gap: int) -> Iterator[Stretch]:
    """Where somebody would have another id; two that do so at once change over."""
    rows = np.flatnonzero((found.mate >= 0) & (found.mate != found.own))
    before, after = found.corrected["track"][found.mate[rows]], found.found["track"][rows]
    frame, kept = found.found["frame"][rows], ~taken.enters[rows]
    waiting: dict[tuple[int, int, bool], list[Stretch]] = {}
    for part in _stretches("identity", before, after, frame, kept, gap):
        twins = waiting.get((part.other, part.track, part.protected), [])
        twin = next((each for each in twins if _overlap(part, each)), None)
        if twin is None:
            waiting.setdefault((part.track, part.other, part.protected), []).append(part)
            continue
        twins.remove(twin)
        yield _both(twin, part)
    for parts in waiting.values():
        yield from parts


def _overlap(one: Stretch, other: Stretch) -> bool:
    return one.start < other.end and other.start < one.end


def _both(one: Stretch, other: Stretch) -> Stretch:
    """Two tracks that become each other, as one stretch."""
    low, high = sorted((one.track, other.track))
    return replace(
        one,
        track=low,
        other=high,
        start=min(one.start, other.start),
        end=max(one.end, other.end),
        rows=one.rows + other.rows,
        mutual=True,
    )


def _moved(found: Alignment, taken: Exchange, gap: int) -> Iterator[Stretch]:
    """Where a track would be elsewhere, and not where another one is."""
    away = (found.own >= 0) & ~found.same & ((found.mate < 0) | (found.mate == found.own))
    rows = np.flatnonzero(away)
    own = found.own[rows]
    metres = np.hypot(*(found.found[n][rows] - found.corrected[n][own] for n in ("x", "y")))
    track, frame = found.found["track"][rows], found.found["frame"][rows]
    nobody = np.zeros_like(track)
    yield from _stretches("moved", track, nobody, frame, ~taken.enters[rows], gap, metres)


def _added(found: Alignment, taken: Exchange, gap: int) -> Iterator[Stretch]:
    """Where a track would have rows and has none, and nobody else is."""
    rows = np.flatnonzero((found.own < 0) & (found.mate < 0))
    track, frame = found.found["track"][rows], found.found["frame"][rows]
    yield from _stretches("added", track, np.zeros_like(track), frame, ~taken.enters[rows], gap)


def _removed(found: Alignment, taken: Exchange, gap: int) -> Iterator[Stretch]:
    """Where a track has rows, would have none, and nobody else would be there."""
    gone = np.ones(len(found.corrected["frame"]), bool)
    gone[found.own[found.own >= 0]] = False
    gone[found.mate[found.mate >= 0]] = False
    track, frame = found.corrected["track"][gone], found.corrected["frame"][gone]
    yield from _stretches("removed", track, np.zeros_like(track), frame, ~taken.leaves[gone], gap)


def _stretches(
    kind: str,
    track: Integers,
    other: Integers,
    frame: Integers,
    kept: Flags,
    gap: int,
    metres: NDArray[np.float64] | None = None,
) -> Iterator[Stretch]:
    """Rows of the same tracks close in time as stretches."""
    if not len(track):
        return
    order = np.lexsort((frame, kept, other, track))
    keys = np.stack((track[order], other[order], kept[order]))
    cut = (np.diff(keys) != 0).any(axis=0) | (np.diff(frame[order]) > gap + 1)
    first = np.append(0, np.flatnonzero(cut) + 1)
    last = np.append(first[1:], len(order)) - 1
    far = np.zeros(len(order)) if metres is None else np.nan_to_num(metres[order])
    farthest = np.maximum.reduceat(far, first)
    low, high = frame[order][first], frame[order][last] + 1
    columns = (*keys[:, first], low, high, last - first + 1, farthest)
    for one, two, held, start, end, rows, away in zip(*(c.tolist() for c in columns), strict=True):
        yield Stretch(kind, one, two, start, end, bool(held), rows, away)


def merge_small(stretches: Iterable[Stretch], fps: float | None) -> Iterator[Stretch]:
    """The stretches with small ones joined to their neighbours of the same track and kind.

    Identities stay as they are. A step aside that is both short and no farther than where the
    same person may stand is left out: nobody would look at it.

    Args:
        fps: frames a second; without it durations are counted as at 20.
    """
    small = _SMALL_FRAMES if fps is None else round(_SMALL_S * fps)
    reach = _REACH_FRAMES if fps is None else round(_REACH_S * fps)
    last: dict[tuple[object, ...], Stretch] = {}
    for one in sorted(stretches, key=lambda each: each.start):
        if one.kind == "identity":
            yield one
            continue
        key = (one.kind, one.track, one.other, one.protected)
        before = last.get(key)
        if before is not None and _is_near(before, one, small, reach):
            one = _joined(before, one)
        elif before is not None and not _is_trifle(before, small):
            yield before
        last[key] = one
    yield from (one for one in last.values() if not _is_trifle(one, small))


def _is_near(one: Stretch, other: Stretch, small: int, reach: int) -> bool:
    """Whether one of the two is small and the other one next to it."""
    return min(one.rows, other.rows) < small and other.start - one.end <= reach


def _joined(one: Stretch, other: Stretch) -> Stretch:
    return replace(
        one,
        end=max(one.end, other.end),
        rows=one.rows + other.rows,
        metres=max(one.metres, other.metres),
    )


def _is_trifle(one: Stretch, small: int) -> bool:
    return one.kind == "moved" and one.rows < small and 0.0 < one.metres < HERE_M
