"""The rows around a frame of one track: which stand fast, and which hang between those."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags
from tracking.editing.boxes.interpolation import Way, interpolate, was_straight
from tracking.editing.core.selection import Rows, rows_differ, select_rows, stack_rows
from tracking.tracks import Columns, Source, TrackTable

_FIRST_LOOK = 64
"""So many rows are looked through at first; a track may have a million."""


def stands_fast(rows: Columns) -> Flags:
    """(n,) which rows are no interpolated ones."""
    return np.asarray(rows["source"] != Source.INTERPOLATED)


def rows_around(table: TrackTable, track: int, frame: int) -> Rows:
    """The track's rows from the one that stands fast before a frame to the one after it.

    Where none stands fast on a side, all rows of that side; the frame's own row is among them
    where there is one.
    """
    frames = table.frames_of_track(track)
    before, after = (int(at) for at in np.searchsorted(frames, [frame, frame + 1]))
    first = _nearest_fast(table, track, frames[:before][::-1])
    last = _nearest_fast(table, track, frames[after:])
    return select_rows(
        table.of_track(track, first if first >= 0 else 0, last + 1 or None), slice(None)
    )


def _nearest_fast(table: TrackTable, track: int, frames: NDArray[np.int32]) -> int:
    """The first of the frames, which go away from a place, whose row stands fast; -1: none."""
    start, look = 0, _FIRST_LOOK
    while start < len(frames):
        part = frames[start : start + look]
        rows = table.of_track(track, int(part.min()), int(part.max()) + 1)
        fast = rows["frame"][stands_fast(rows)]
        if len(fast):
            return int(fast[0] if part[0] <= part[-1] else fast[-1])
        start, look = start + look, look * 2
    return -1


def interpolate_between(ends: Columns, frames: NDArray[np.int32], way: Way, there: Columns) -> Rows:
    """New rows of a track for the given frames, each between two of the ends.

    there: rows that stood in some of these frames: their visibility stays.
    """
    at = np.searchsorted(ends["frame"], frames, side="right") - 1
    fresh = interpolate(ends, at, frames, way, np.zeros(len(frames), np.bool_))
    _, now, before = np.intersect1d(frames, there["frame"], assume_unique=True, return_indices=True)
    fresh["visibility"][now] = there["visibility"][before]
    return fresh


def reinterpolate(old: Columns, new: Columns, way: Way) -> Rows:
    """Rows of a window anew, after some that stand fast were moved, added or let go.

    Args:
        old: the window's rows as they are.
        new: as they shall be, where the interpolated ones still have old values: these, where they
            lie between two that stand fast, are interpolated again; others stay.
        way: how; where it leaves it open, as they were before.
    """
    fast = stands_fast(new)
    ends = select_rows(new, fast)
    hanging = np.flatnonzero(~fast & _enclosed(fast))
    if not len(hanging):
        return select_rows(new, slice(None))
    frames = new["frame"][hanging]
    at = np.searchsorted(ends["frame"], frames) - 1
    fresh = interpolate(ends, at, frames, way, _hung_straight(old, frames))
    result = select_rows(new, slice(None))
    for name, column in fresh.items():
        if name != "visibility":
            result[name][hanging] = column
    return result


def _hung_straight(old: Columns, frames: NDArray[np.int32]) -> Flags:
    """(n,) which of the frames lay in a stretch that ran straight; a stretch's new rows with it."""
    fast = stands_fast(old)
    ends = select_rows(old, fast)
    hanging = np.flatnonzero(~fast & _enclosed(fast))
    straight = np.zeros(max(len(ends["frame"]) - 1, 0), np.bool_)
    if len(hanging):
        rows = select_rows(old, hanging)
        at = np.searchsorted(ends["frame"], rows["frame"]) - 1
        np.logical_or.at(straight, at, was_straight(ends, at, rows))
    if not len(straight):
        return np.zeros(len(frames), np.bool_)
    where = np.searchsorted(ends["frame"], frames) - 1
    return np.asarray(straight[where.clip(0, len(straight) - 1)])


def _enclosed(fast: Flags) -> Flags:
    """(n,) which rows lie between the first and the last that stand fast."""
    places = np.flatnonzero(fast)
    inside = np.zeros(len(fast), np.bool_)
    if len(places):
        inside[places[0] : places[-1] + 1] = True
    return inside


def compare_windows(before: Columns, after: Columns) -> tuple[Rows, Rows]:
    """The rows that stand only before and only after, of one track's windows."""
    _, was, will = np.intersect1d(
        before["frame"], after["frame"], assume_unique=True, return_indices=True
    )
    same = ~rows_differ(select_rows(before, was), select_rows(after, will))
    goes, comes = np.ones(len(before["frame"]), np.bool_), np.ones(len(after["frame"]), np.bool_)
    goes[was[same]] = comes[will[same]] = False
    return select_rows(before, goes), select_rows(after, comes)


def with_row(rows: Columns, row: Columns) -> Rows:
    """The window with one row put in, in place of what stood there."""
    return stack_rows([select_rows(rows, rows["frame"] != row["frame"][0]), row])
