"""Which row of a run each row of the corrected table is, and what the run noticed of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.tracks.columns import Columns
from tracking.tracks.row_keys import row_keys
from tracking.tracks.run import Run

Rows = NDArray[np.int64]
_HELD = ("left", "top", "x", "y")
"""Values that tell the rows of a frame apart."""


@dataclass(frozen=True, slots=True, eq=False)
class RunRows:
    """The run's rows behind some rows.

    Attributes:
        run: None where there is none.
        row: (n,) of the run's tracks; -1 where a row is of no run.
        key: (n,) track and frame the row has in the run; -1 likewise.
    """

    run: Run | None
    row: Rows
    key: Rows

    def signal(self, name: str) -> NDArray[np.float32]:
        """(n,) a signal; NaN where it was not noticed."""
        return self._looked_up(self.run.signals if self.run else {}, name)

    def margin(self) -> NDArray[np.float32]:
        """(n,) by how much the next best choice was dearer; NaN where nothing was chosen."""
        return self._looked_up(self.run.associations if self.run else {}, "margin")

    def failed_parts(self) -> Rows:
        """(n,) which parts of the person have failed: 1 head, 2 torso, 4 hip-leg, added up."""
        parts = self.run.parts if self.run else {}
        if not len(parts.get("failed", ())):
            return np.zeros(len(self.row), np.int64)
        failed, person = np.unique(_keys(parts)[parts["failed"]], return_inverse=True)
        if not len(failed):
            return np.zeros(len(self.row), np.int64)
        bits = np.left_shift(1, parts["part"][parts["failed"]].astype(np.int64))
        which = np.bincount(person.reshape(-1), bits).astype(np.int64)
        at = np.minimum(np.searchsorted(failed, self.key), len(failed) - 1)
        return np.where(failed[at] == self.key, which[at], 0)

    def _looked_up(self, columns: Columns, name: str) -> NDArray[np.float32]:
        values = np.full(len(self.row), np.nan, np.float32)
        if not len(columns.get(name, ())):
            return values
        assert self.run is not None
        if len(columns[name]) == len(self.run.tracks["frame"]) and np.array_equal(
            _keys(columns), _keys(self.run.tracks)
        ):
            known = self.row >= 0
            values[known] = columns[name][self.row[known]]
            return values
        at = _places_of(_keys(columns), self.key)
        values[at >= 0] = columns[name][at[at >= 0]]
        return values


def rows_in_run(columns: Columns, run: Run | None) -> RunRows:
    """Find rows in the run they came from by frame, box and place.

    Args:
        columns: at least `frame, track, left, top, x, y`.
    """
    own = _keys(columns)
    if run is None or not len(run.tracks["frame"]):
        nothing = np.full(len(own), -1)
        return RunRows(run, nothing, nothing)
    theirs = _keys(run.tracks)
    row = _places_of(theirs, own)
    row[~_same(columns, np.arange(len(own)), run.tracks, row)] = -1
    moved = np.flatnonzero(row < 0)
    row[moved] = _found_by_value(columns, moved, run.tracks)
    return RunRows(run, row, np.where(row >= 0, theirs[row], -1))


def run_within(run: Run | None, start: int, end: int) -> Run | None:
    """What a run holds of a half-open range of frames, as far as it is looked up here."""
    if run is None:
        return None
    return replace(
        run,
        tracks=_within(run.tracks, start, end),
        associations=_within(run.associations, start, end),
        parts=_within(run.parts, start, end),
        signals=_within(run.signals, start, end),
    )


def _within(columns: Columns, start: int, end: int) -> Columns:
    frame = columns["frame"]
    rows = np.flatnonzero((frame >= start) & (frame < end))
    return {name: column[rows] for name, column in columns.items()}


def _found_by_value(columns: Columns, rows: Rows, tracks: Columns) -> Rows:
    """(k,) the run's row of the same frame with the same values; -1 for none."""
    wanted, there = _fingerprints(columns, rows), _fingerprints(tracks, slice(None))
    found = _places_of(there, wanted)
    found[~_same(columns, rows, tracks, found)] = -1
    return found


def _same(columns: Columns, rows: Rows, tracks: Columns, found: Rows) -> NDArray[np.bool_]:
    """(k,) whether rows hold, bit for bit, what those of the run hold."""
    same = found >= 0
    for name in ("frame", *_HELD):
        own, theirs = columns[name][rows], tracks[name][found]
        same &= (own == theirs) | ((own != own) & (theirs != theirs))
    return same


def _fingerprints(columns: Columns, rows: Rows | slice) -> Rows:
    """(k,) frame and, mixed into the lower half, the values' bits."""
    mixed = np.zeros(len(columns["frame"][rows]), np.uint64)
    for name in _HELD:
        bits = np.ascontiguousarray(columns[name][rows]).view(np.uint64)
        mixed = (mixed ^ bits) * np.uint64(0x9E3779B97F4A7C15)
    frame = columns["frame"][rows].astype(np.int64)
    return np.asarray((frame << 32) | (mixed >> np.uint64(32)).astype(np.int64))


def _places_of(there: Rows, wanted: Rows) -> Rows:
    """(k,) where each wanted number stands among those there; -1 where it does not."""
    if not len(there):
        return np.full(len(wanted), -1)
    order = np.argsort(there, kind="stable")
    ordered = there[order]
    at = np.minimum(np.searchsorted(ordered, wanted), len(ordered) - 1)
    return np.where(ordered[at] == wanted, order[at], -1)


def _keys(columns: Columns) -> Rows:
    return row_keys(columns["track"], columns["frame"])
