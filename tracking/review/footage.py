"""The table's rows by blocks of frames, each with what lies around it, and when a block changed."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.review.core.evidence import NAMES, Rows
from tracking.tracks import Columns, TrackTable, row_keys

AROUND_S = 8.0
"""So far around a block rows can tell about it: looks over seconds, ends and beginnings."""
_SHORTEST_S = 30.0
_LEAST_ROWS = 24_000
"""Blocks of fewer rows cost more time than they save."""
_SPREAD = np.uint64(0x9E3779B97F4A7C15)


@dataclass(frozen=True, slots=True, eq=False)
class Footage:
    """All rows, one track behind the other, each track by frame.

    Attributes:
        columns: `NAMES`. key: (n,) ascending `row_keys`. mark: (n,) a number mixed of all a row
            holds.
        tracks: (t,) all ids. first, last: (t,) first and last row of each track.
        seen_before, seen_after: (n + 1,) the row seen last before each, and first from it on; -1
            and n for none, of whichever track.
    """

    columns: Columns
    key: Rows
    mark: NDArray[np.uint64]
    first: Rows
    last: Rows
    tracks: Rows
    seen_before: Rows
    seen_after: Rows

    @classmethod
    def of(cls, table: TrackTable) -> Footage:
        """All of a table."""
        columns = table.by_track(NAMES)
        track = columns["track"].astype(np.int64)
        ends = np.flatnonzero(np.diff(track, append=-1))
        first = np.append(0, ends[:-1] + 1)[: len(ends)]
        row, count = np.arange(len(track)), len(track)
        seen = ~columns["predicted"]
        before = np.maximum.accumulate(np.append(-1, np.where(seen, row, -1)))
        after = np.minimum.accumulate(np.append(np.where(seen, row, count), count)[::-1])[::-1]
        key = row_keys(track, columns["frame"])
        return cls(columns, key, _marks(columns), first, ends, track[first], before, after)

    def length(self, stop: int, fps: float) -> int:
        """Frames of a block: the same for about as many rows, so that edits do not change it."""
        frames = max(1, round(_SHORTEST_S * fps))
        while frames < stop and len(self.key) * frames < _LEAST_ROWS * stop:
            frames *= 2
        return frames

    def around(self, start: int, end: int, frames: int) -> Rows:
        """(k,) rows in a half-open range of frames, so many before and after it, and few more.

        Of who is out of sight from the range to beyond that: where they are seen last before, and
        first after it, or where their track ends.
        """
        low, high = (self._rows_from(frame) for frame in (start - frames, end + frames))
        there = np.flatnonzero(high > low)
        low, high, first, last = low[there], high[there], self.first[there], self.last[there]
        count = high - low
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        before, after = self.seen_before[low], self.seen_after[high]
        late = self._frame(self.seen_after[low]) >= start
        early = self._frame(self.seen_before[high]) < end
        more = (before[late & (before >= first)], np.minimum(after, last)[early])
        rows = np.sort(np.concatenate((np.repeat(low, count) + within, *more)), kind="stable")
        return np.asarray(rows[np.diff(rows, prepend=-1) > 0])

    def _rows_from(self, frame: int) -> Rows:
        """(t,) each track's first row in or after a frame."""
        wanted = row_keys(self.tracks, np.full(len(self.tracks), max(frame, 0)))
        return np.asarray(np.searchsorted(self.key, wanted), np.int64)

    def _frame(self, rows: Rows) -> Rows:
        """(k,) of rows, also of those that are none."""
        return np.asarray(self.columns["frame"][np.clip(rows, 0, len(self.key) - 1)], np.int64)

    def fingerprint(self, rows: Rows) -> bytes:
        """Tells whether rows hold what they held."""
        return hashlib.blake2b(self.mark[rows].tobytes(), digest_size=16).digest()


def _marks(columns: Columns) -> NDArray[np.uint64]:
    """(n,) the bits of all columns, mixed."""
    mixed = np.zeros(len(columns["track"]), np.uint64)
    for name in NAMES:
        column = columns[name]
        bits = np.ascontiguousarray(column).view(f"u{column.dtype.itemsize}").astype(np.uint64)
        mixed = (mixed ^ bits) * _SPREAD
        mixed ^= mixed >> np.uint64(29)
    return mixed
