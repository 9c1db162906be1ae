"""Whose a run's findings are after the edits: the one rule for parts, particles and samples."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import (
    PART_COLUMNS,
    Columns,
    Run,
    TrackTable,
    between,
    empty,
    pairs_of,
    row_keys,
)
from tracking.tracks.run_rows import rows_in_run

Keys = NDArray[np.int64]
_BOX = ("left", "top", "width", "height")
_TELLING = ("frame", "track", *_BOX, "x", "y")
"""Columns by which a row of the corrected table is found in the run it came from."""
_REACH = 0.5
"""In heights of the box: how far a box may have been moved to be found by where it is."""


def run_keys(rows: Columns, table: TrackTable, run: Run) -> Keys:
    """(n,) which of a run's rows each row is by now: its `row_keys`, track first; -1: none.

    An edit that renames hands a row on as it is, and it is found by its values. One whose box was
    moved or drawn is, of those of the run's rows in its frame that nobody has, the nearest within
    half a height, else the one of its own id however far it was moved. A deleted row's is nobody's.

    Args:
        rows: of the table, at least `frame, track, left, top, width, height, x, y`.
        table: tells what the others of a frame have.
    """
    key = _unmoved(rows, run)
    moved = np.flatnonzero(key < 0)
    if len(moved):
        frames = np.unique(rows["frame"][moved])
        everybody = table.of_tracks(table.track_ids, int(frames[0]), int(frames[-1]) + 1)
        whole = _in_frames(everybody, frames)
        found = _with_moved(whole, _unmoved(whole, run), _in_frames(run.tracks, frames))
        own = _keys(whole)
        order = np.argsort(own)
        key[moved] = found[order][np.searchsorted(own[order], _keys(rows)[moved])]
    return key


def ids_by_now(table: TrackTable, run: Run, frame: int) -> dict[int, int]:
    """For each track of a run in a frame the id that person has there by now; see `run_keys`.

    Tracks whose row was deleted are left out.
    """
    rows = table.of_frame(frame)
    tracks, _ = pairs_of(run_keys(rows, table, run))
    ids = zip(tracks.tolist(), rows["track"].tolist(), strict=True)
    return {track: now for track, now in ids if track > 0}


def parts_by_now(
    table: TrackTable,
    run: Run | None,
    tracks: Collection[int],
    frames: tuple[int, int] | None = None,
) -> Columns:
    """`PART_COLUMNS` that a run saw of some people, who have these ids by now; see `run_keys`.

    Args:
        frames: half-open; None: all.
    """
    if run is None or not len(run.parts["frame"]):
        return empty(PART_COLUMNS)
    rows: Columns = (
        table.by_track(_TELLING, tracks)
        if frames is None
        else table.of_tracks([track for track in tracks if track in table], *frames)
    )
    key = run_keys(rows, table, run)
    known = np.flatnonzero(key >= 0)
    if not len(known):
        return empty(PART_COLUMNS)
    known = known[np.argsort(key[known], kind="stable")]
    seen = _between_frames(run.parts, rows["frame"])
    asked = _keys(seen)
    at = np.minimum(np.searchsorted(key[known], asked), len(known) - 1)
    theirs = key[known][at] == asked
    parts = {name: column[theirs] for name, column in seen.items()}
    return {**parts, "track": rows["track"][known[at[theirs]]].astype(np.int32)}


def _unmoved(rows: Columns, run: Run) -> Keys:
    """(n,) the keys of rows that hold what the run's rows hold; -1 for others."""
    if not len(rows["frame"]):
        return np.zeros(0, np.int64)
    near = replace(run, tracks=_between_frames(run.tracks, rows["frame"]))
    return np.array(rows_in_run(rows, near).key, np.int64)


def _with_moved(rows: Columns, key: Keys, made: Columns) -> Keys:
    """The keys of whole frames' rows, those that were moved given what nobody has.

    made: the run's rows of these frames, sorted by frame.
    """
    theirs = _keys(made)
    free = ~np.isin(theirs, key)
    made, theirs = {name: made[name][free] for name in ("frame", "track", *_BOX)}, theirs[free]
    moved = np.flatnonzero(key < 0)
    row, other = _of_same_frames(rows["frame"][moved], made["frame"])
    row = moved[row]
    apart = _apart(rows, row, made, other)
    apart[apart > _REACH] = np.inf
    own = rows["track"][row] == made["track"][other]
    likely = np.flatnonzero(own | np.isfinite(apart))
    order = likely[np.lexsort((other[likely], ~own[likely], apart[likely]))]
    key, given = key.copy(), set()
    for mine, its in zip(row[order].tolist(), other[order].tolist(), strict=True):
        if key[mine] < 0 and its not in given:
            key[mine] = theirs[its]
            given.add(its)
    return key


def _of_same_frames(
    frame: NDArray[np.int32], there: NDArray[np.int32]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """All pairs of one row each with the same frame; `there` is sorted."""
    first = np.searchsorted(there, frame, side="left")
    count = np.searchsorted(there, frame, side="right") - first
    row = np.repeat(np.arange(len(frame)), count)
    within = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
    return row, np.repeat(first, count) + within


def _apart(rows: Columns, row: Keys, made: Columns, other: Keys) -> NDArray[np.float64]:
    """(k,) the largest difference of two boxes in any number, in heights; unknown: infinite."""
    largest = np.zeros(len(row))
    for name in _BOX:
        largest = np.maximum(largest, np.abs(rows[name][row] - made[name][other]))
    return np.nan_to_num(largest / np.maximum(made["height"][other], 1.0), nan=np.inf)


def _between_frames(columns: Columns, frames: NDArray[np.int32]) -> Columns:
    """The rows, sorted by frame, from the first to the last of some frames."""
    inside = between(columns["frame"], int(frames.min()), int(frames.max()) + 1)
    return {name: column[inside] for name, column in columns.items()}


def _in_frames(columns: Columns, frames: NDArray[np.int32]) -> Columns:
    inside = np.isin(columns["frame"], frames)
    return {name: column[inside] for name, column in columns.items()}


def _keys(columns: Columns) -> Keys:
    return row_keys(columns["track"], columns["frame"])
