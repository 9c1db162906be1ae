"""A tracker's stretch as keyframes: few enough to be corrected by hand."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Floats
from tracking.editing.boxes.floor_boxes import boxes_of, places_of
from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.keyframes import vouch_for
from tracking.editing.boxes.stretches import compare_windows, interpolate_between
from tracking.editing.core.change import Change, State
from tracking.editing.core.scope import Scope, check_scope, scope_text
from tracking.editing.core.selection import Rows, select_rows, stack_rows
from tracking.errors import EditError
from tracking.geometry import View
from tracking.progress import Progress, no_progress
from tracking.tracks import (
    CORRECTED_COLUMNS,
    LARGEST_NUMBER,
    Columns,
    Source,
    TrackTable,
    check_known,
    empty,
)
from tracking.translation import msg

TOLERANCE_M = 0.15
"""Of places, where nobody says another."""

_ROWS_AT_ONCE = 1 << 14
"""Of many tracks thinned together: they stay in the processor's cache."""


def plan_thin(
    table: TrackTable,
    track: int,
    start: int = 0,
    end: int | None = None,
    tolerance_px: float = 3.0,
    tolerance_m: float = TOLERANCE_M,
    how: How | None = None,
    *,
    view: View | None = None,
    fps: float | None = None,
) -> Change:
    """Turn a stretch into keyframes with interpolation between them.

    Where no edge of a box and no place on the floor would be farther off than the tolerances, the
    row is interpolated; the others become keyframes, by dividing at the worst row again and again
    ([DouglasPeucker1973], here on box and place at once). Keyframes that are there stay, and so
    does what borders on rows whose box or place is unknown where its own is known.

    Args:
        table, track: what.
        start, end: half-open range of frames; end None: from there on.
        tolerance_px: of the boxes' edges. tolerance_m: of places that are known.
        how, view, fps: of the interpolation.

    Raises:
        EditError: fewer than three rows are there, a tolerance is not positive, or every row would
            have to stay.
    """
    old = _rows_to_thin(table, track, start, end)
    _check_tolerances(tolerance_px, tolerance_m)
    way = Way(how, view, fps)
    keys = _kept(old, way, (tolerance_px, tolerance_m))
    return _thin_change(track, Scope(start, end), old, keys, way)


def _rows_to_thin(table: TrackTable, track: int, start: int, end: int | None) -> Rows:
    """A track's rows in a range. Raises EditError where they are too few."""
    check_known(table, track)
    check_scope(start, end)
    rows = table.of_track(track, start, end)
    if len(rows["frame"]) < 3:
        raise EditError(
            "track {track} has fewer than three boxes {where}; nothing to thin",
            track=track,
            where=scope_text(start, end),
        )
    return rows


def _thin_change(track: int, scope: Scope, old: Rows, keys: Flags, way: Way) -> Change:
    """The change that interpolates a track's rows between keyframes (n,) of them.

    Raises EditError where every row would have to stay.
    """
    before, after = compare_windows(old, _thinned(old, keys, way))
    if keys.all() or not len(after["frame"]):
        raise EditError(
            "track {track}: no row can be left out; allow a larger tolerance", track=track
        )
    text = msg(
        "Thin {track} {where} to {keys} keyframes of {count} boxes",
        track=track,
        where=scope_text(scope.start, scope.end),
        keys=int(keys.sum()),
        count=len(keys),
    )
    return Change("thin", text, int(old["frame"][0]), State(rows=before), State(rows=after), scope)


def _check_tolerances(tolerance_px: float, tolerance_m: float) -> None:
    if not (tolerance_px > 0 and tolerance_m > 0):
        raise EditError(
            "tolerances of {tolerance_px} px and {tolerance_m} m: both are above 0",
            tolerance_px=tolerance_px,
            tolerance_m=tolerance_m,
        )


def thin_tracks(
    rows: Columns,
    tolerance_px: float,
    way: Way,
    report: Progress = no_progress,
    tolerance_m: float = TOLERANCE_M,
) -> tuple[Rows, Flags]:
    """Rows of many tracks thinned as `plan_thin` does, many at once; no row counts as a keyframe.

    Args:
        rows: whole tracks, by track then frame.
        report: called with rows; raises to cancel.

    Returns: the rows, in the same order, and (n,) which are of a track that was thinned; tracks of
        which every row would have to stay are as they were.
    """
    starts = np.flatnonzero(np.diff(rows["track"], prepend=0))
    stops = np.append(starts[1:], len(rows["track"]))
    parts, changed, first = [empty(CORRECTED_COLUMNS)], np.zeros(len(rows["track"]), np.bool_), 0
    while first < len(starts):
        last = _joint(rows["frame"], starts, stops, first)
        chosen = slice(int(starts[first]), int(stops[last - 1]))
        ends = np.zeros(chosen.stop - chosen.start, np.bool_)
        ends[starts[first:last] - chosen.start] = ends[stops[first:last] - 1 - chosen.start] = True
        tick = partial(report, chosen.start, len(changed))
        part, changed[chosen] = _thin_joint(
            select_rows(rows, chosen), ends, way, (tolerance_px, tolerance_m), tick
        )
        parts.append(part)
        first = last
    report(len(changed), len(changed))
    return {name: np.concatenate([p[name] for p in parts]) for name in CORRECTED_COLUMNS}, changed


def _joint(
    frames: NDArray[np.int32], starts: NDArray[np.intp], stops: NDArray[np.intp], first: int
) -> int:
    """One past the last track that is thinned together with this one.

    Together they have neither too many rows nor more frames than are counted.
    """
    spans = frames[stops[first:] - 1].astype(np.int64) - frames[starts[first:]] + 1
    fit = (np.cumsum(spans) <= LARGEST_NUMBER) & (stops[first:] - starts[first] <= _ROWS_AT_ONCE)
    return first + max(1, int(np.count_nonzero(fit)))


def _thin_joint(
    rows: Rows, ends: Flags, way: Way, tolerances: tuple[float, float], tick: Callable[[], None]
) -> tuple[Rows, Flags]:
    """Tracks thinned together: in frames of their own, one track after the other.

    ends: (n,) the first and the last row of each track; nothing hangs between two tracks.
    """
    frames, begins = rows["frame"], np.append(True, np.diff(rows["track"]) != 0)
    steps = np.where(begins, 1, np.diff(frames.astype(np.int64), prepend=0))
    joint = {**rows, "frame": np.cumsum(steps).astype(np.int32)}
    joint["source"] = np.zeros_like(rows["source"])
    keys = _kept(joint, way, tolerances, ends, tick)
    thinned = _thinned(joint, keys, way)
    thinned["frame"] = frames
    track = np.cumsum(begins) - 1
    changed = np.asarray((np.bincount(track, ~keys) > 0)[track])
    kept = {name: np.where(changed, thinned[name], rows[name]) for name in rows}
    return kept, changed


def _kept(
    rows: Columns,
    way: Way,
    tolerances: tuple[float, float],
    ends: Flags | None = None,
    tick: Callable[[], None] = lambda: None,
) -> Flags:
    """(n,) which rows become keyframes; ends: rows that do anyway. tick: called now and then."""
    keys = np.asarray(rows["source"] == Source.PERSON)
    keys[0] = keys[-1] = True
    if ends is not None:
        keys |= ends
    known = np.isfinite(np.column_stack([boxes_of(rows), places_of(rows)]))
    borders = np.flatnonzero((known[1:] != known[:-1]).any(axis=1))
    keys[borders] = keys[borders + 1] = True
    open_rows = np.flatnonzero(~keys)
    while len(open_rows):
        tick()
        there = select_rows(rows, open_rows)
        stretch = np.cumsum(keys)[open_rows] - 1
        between = interpolate_between(_ends_of(rows, keys, stretch), there["frame"], way, there)
        off = _off(there, between, tolerances)
        order = np.lexsort((off, stretch))
        worst = order[np.flatnonzero(np.diff(stretch[order], append=-1))]
        worst = worst[off[worst] > 1]
        keys[open_rows[worst]] = True
        divided = np.isin(stretch, stretch[worst])
        divided[worst] = False
        open_rows = open_rows[divided]
    return keys


def _ends_of(rows: Columns, keys: Flags, stretch: NDArray[np.intp]) -> Rows:
    """The keyframes on both sides of some of the stretches between keyframes."""
    at = np.flatnonzero(keys)
    asked = np.zeros(len(at), np.bool_)
    asked[stretch] = asked[stretch + 1] = True
    return select_rows(rows, at[asked])


def _thinned(rows: Columns, keys: Flags, way: Way) -> Rows:
    """The rows with those that are no keys interpolated between those that are."""
    ends, there = select_rows(rows, keys), select_rows(rows, ~keys)
    between = interpolate_between(ends, there["frame"], way, there)
    vouch_for(ends)
    return stack_rows([ends, between])


def _off(rows: Columns, thinned: Columns, tolerances: tuple[float, float]) -> Floats:
    """(n,) how far box and place are off, in tolerances; what is unknown is not off."""
    edges, apart = boxes_of(thinned) - boxes_of(rows), places_of(thinned) - places_of(rows)
    edges[:, 2:] += edges[:, :2]
    box, place = np.abs(edges).max(axis=1), np.linalg.norm(apart, axis=1)
    return np.asarray(np.fmax(np.fmax(box / tolerances[0], place / tolerances[1]), 0.0))
