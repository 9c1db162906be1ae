"""Where a track leaves the picture and enters it again, or somebody else does."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.seen_rows import (
    EDGE_SHARE,
    Flags,
    Floats,
    SeenRows,
    is_after_gap,
    is_track_start,
    place_errors,
)
from tracking.trackers.stereo.boxes import MIDDLE_M, Bodies

Rows = NDArray[np.intp]

_TURN_S = 0.6
"""Of the way before and after somebody may have left, and somebody else come."""
_STEP_M = 0.1
"""By which a place is moved to see how the picture lies over the floor."""
_LEAST_LINE = 5
"""Rows of a line."""
_WAY_M = 0.12
"""Who seems to move less than this, out and in again, may have stood there."""
_BEND = 1.75
"""Times the misses of two straight ways, up to which one bend explains the way as well."""
_SURE = 3.0
"""In errors of a measured place: how much worse two ways must part elsewhere."""
_ERRORS = 1.5
"""The same on the floor, in errors of a measured place."""


def find_edge_returns(seen: SeenRows, view: View, fps: float) -> list[EdgeReturn]:
    """Where tracks that went out over the picture's edge come back over it.

    At most once in each stretch along the edge that has others before and after it: where the way
    turns most, if it does from outwards to inwards. Not where it bends evenly: who turns round
    slows down first, while somebody else comes as fast as the other went.
    """
    returns = []
    first = is_track_start(seen) | is_after_gap(seen, _TURN_S, fps)
    part, scale = np.cumsum(first), _Scale.of(seen.place, view)
    track_ends = np.append(first, True)
    changes = np.diff(seen.at_edge.astype(np.int8), prepend=0, append=0) != 0
    ends = np.flatnonzero(changes | track_ends)
    reach = max(_LEAST_LINE, round(_TURN_S * fps))
    for start, stop in pairwise(ends.tolist()):
        if seen.at_edge[start] and not track_ends[start] and not track_ends[stop]:
            own = np.arange(max(start - reach, 0), min(stop + reach, len(seen)))
            own = own[part[own] == part[start]]
            ways = _Paths.of(seen, own, scale, view, fps)
            row = ways.turn(start, stop, reach)
            found = [ways.sharpen(row, reach)] if row else []
            returns += [one for one in found if not ways.bends(one.row, reach)]
    return returns


@dataclass(frozen=True, slots=True)
class EdgeReturn:
    """A track that comes back over the picture's edge.

    Attributes:
        row: of `SeenRows`, the first that may be somebody else. start, stop: the rows,
            half-open, of which it is not sure on which side they are.
    """

    row: int
    start: int
    stop: int


@dataclass(frozen=True, slots=True)
class _Scale:
    """How the picture lies over the floor at every row.

    Attributes:
        px_per_m: (n,) how large a metre looks. moved_px: (n, 2, 2) how far right and down
            somebody moves in the picture who goes a metre along x, and along y; 0 where unknown.
    """

    px_per_m: Floats
    moved_px: Floats

    @classmethod
    def of(cls, place: Floats, view: View) -> _Scale:
        chest = np.concatenate((place, np.full((len(place), 1), MIDDLE_M)), axis=1)
        here = view.pixel_from_world(chest)
        moved = [view.pixel_from_world(chest + _STEP_M * axis) - here for axis in np.eye(3)[:2]]
        px_per_m = Bodies.at(place, view).px_per_m
        return cls(px_per_m[:, 0], np.nan_to_num(np.stack(moved, axis=1)) / _STEP_M)

    def outward(self, rows: Rows, touched: Floats) -> Floats:
        """(k, 2, 2) unit vectors over an edge, as it looks and on the floor; 0 without an edge."""
        floor = self.moved_px[rows] @ touched
        both = np.stack((np.broadcast_to(touched, floor.shape), floor), axis=1)
        return np.asarray(both / np.maximum(np.hypot(both[..., :1], both[..., 1:]), 1e-9))


@dataclass(frozen=True, slots=True)
class _Paths:
    """A track's way along the edge.

    Attributes:
        row: (k,) of `SeenRows`. time_s: (k,) from their middle.
        where: (k, 4) m, the box's middle as large as metres look there, and the place.
        outward: (k, 2, 2) unit vectors out of the picture, as it looks and on the floor.
        upto: (k + 1, 3, 4) sums over the rows before each: `where`, times time, squared.
        time_upto: (k + 1, 3) the same of 1, time and its square.
    """

    row: Rows
    time_s: Floats
    where: Floats
    outward: Floats
    upto: Floats
    time_upto: Floats

    @classmethod
    def of(cls, seen: SeenRows, rows: Rows, scale: _Scale, view: View, fps: float) -> _Paths:
        low, high = seen.box[rows, :2], seen.box[rows, :2] + seen.box[rows, 2:]
        middle_m = (low + high) / (2.0 * np.median(scale.px_per_m[rows]))
        where = np.concatenate((middle_m, seen.place[rows]), axis=1)
        time_s = (seen.frame[rows] - seen.frame[rows].mean()) / fps
        offset, time = where - where.mean(axis=0), time_s[:, None]
        return cls(
            rows,
            time_s,
            where,
            scale.outward(rows, _touched(low.min(axis=0), high.max(axis=0), view)),
            _upto(np.stack((offset, time * offset, offset**2), axis=1)),
            _upto(np.concatenate((time**0, time, time**2), axis=1)),
        )

    def turn(self, start: int, stop: int, reach: int) -> int:
        """The row from start to stop from which on somebody comes back; 0 where nobody does.

        Two straight lines explain most more than one there.
        """
        low, at, high = self._around(np.arange(start, stop + 1), reach)
        enough = np.minimum(at - low, high - at) >= _LEAST_LINE
        low, at, high = low[enough], at[enough], high[enough]
        (out, one), (back, other) = self._lines(low, at), self._lines(at, high)
        gain = self._lines(low, high)[1] - one - other
        gain[~self._return(at, out, back)] = 0.0
        return int(self.row[at[gain.argmax()]]) if gain.max(initial=0.0) > 0.0 else 0

    def bends(self, row: int, reach: int) -> bool:
        """Whether the way around a row is one even bend, rather than two straight ways."""
        low, at, high = self._around(np.array([row]), reach)
        own = slice(int(low[0]), int(high[0]))
        time = np.vander(self.time_s[own], 3)
        bend = time @ np.linalg.lstsq(time, self.where[own], rcond=None)[0]
        miss = np.square(self.where[own] - bend).sum()
        straight = self._lines(low, at)[1] + self._lines(at, high)[1]
        return bool(miss <= _BEND * straight[0])

    def sharpen(self, row: int, reach: int) -> EdgeReturn:
        """The row close by that parts the same stretch best, and those that do nearly as well."""
        low, at, high = (int(n[0]) for n in self._around(np.array([row]), reach))
        first, last = (
            max(at - reach // 2, low + _LEAST_LINE),
            min(at + reach // 2, high - _LEAST_LINE),
        )
        near = np.arange(first, last + 1)
        misses = self._lines(np.full_like(near, low), near)[1]
        misses += self._lines(near, np.full_like(near, high))[1]
        error_m = place_errors(self.where[at : at + 1, 2:])[0]
        rows = self.row[near[misses <= 2.0 * misses.min() + (_SURE * error_m) ** 2]]
        return EdgeReturn(int(self.row[near[misses.argmin()]]), int(rows[0]), int(rows[-1]))

    def _around(self, rows: Rows, reach: int) -> tuple[Rows, Rows, Rows]:
        """(k,) where the stretch around each row begins, where the row is, where it ends."""
        low, at, high = np.searchsorted(self.row, (rows - reach, rows, rows + reach))
        return low, at, high

    def _return(self, at: Rows, out: Floats, back: Floats) -> Flags:
        """(k,) whether ways (k, 4) m lead over the edge and back, as it looks and on the floor."""
        error_m = place_errors(self.where[at, 2:])
        least_m = np.stack((np.full(len(at), _WAY_M), _ERRORS * error_m), axis=1)
        out_m, back_m = (
            (way.reshape(-1, 2, 2) * self.outward[at]).sum(axis=2) for way in (out, back)
        )
        return np.asarray(((out_m > least_m) & (back_m < -least_m)).all(axis=1))

    def _lines(self, start: Rows, stop: Rows) -> tuple[Floats, Floats]:
        """The best straight ways (k, 4) m through rows, and the sums (k,) of squared misses."""
        count, time, time2 = (self.time_upto[stop] - self.time_upto[start]).T[:, :, None]
        where, slanted, squared = np.moveaxis(self.upto[stop] - self.upto[start], 1, 0)
        count = np.maximum(count, 1.0)
        spread = np.maximum(time2 - time**2 / count, 1e-9)
        speed = (slanted - time * where / count) / spread
        misses = squared - where**2 / count - speed**2 * spread
        elapsed_s = (
            self.time_s[np.maximum(stop, 1) - 1] - self.time_s[np.minimum(start, len(self.row) - 1)]
        )
        return speed * elapsed_s[:, None], misses.sum(axis=1)


def _upto(values: Floats) -> Floats:
    """Sums over all rows before each, one more than there are rows."""
    return np.concatenate((np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)))


def _touched(low: Floats, high: Floats, view: View) -> Floats:
    """(2,) right and down: 1 or -1 where a box reaches out over that edge or the opposite one."""
    size = np.array(view.camera.size, float)
    out = np.stack((-low, high - (size - 1.0)))
    side = np.where(out[1] > out[0], 1.0, -1.0)
    return np.where(out.max(axis=0) >= -EDGE_SHARE * size.max(), side, 0.0)
