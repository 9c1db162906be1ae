"""Where a track leaves the picture and enters it again, or somebody else does."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.seen import EDGE_SHARE, Flags, Floats, Seen, place_errors
from tracking.trackers.stereo_boxes import MIDDLE_M

Rows = NDArray[np.intp]

_TURN_S = 0.6
"""Of the way before and after somebody may have left, and somebody else come."""
_LEAST_LINE = 5
"""Rows of a line."""
_BODY_M = (1.7, 0.5)
"""Height and width of a usual one."""
_WAY_M = 0.12
"""Who seems to move less than this, out and in again, may have stood there."""
_SURE = 3.0
"""In errors of a measured place: how much worse two ways must part elsewhere."""
_ERRORS = 1.5
"""The same on the floor, in errors of a measured place."""


def returned_over_edge(seen: Seen, first: Flags, view: View, fps: float) -> list[Return]:
    """Where tracks that went out over the picture's edge come back over it.

    At most once in each stretch along the edge that has others before and after it: where the way
    turns most, if it does from outwards to inwards.

    Args:
        first: (n,) where tracks begin, or go on after a gap.
    """
    returns = []
    part = np.cumsum(first)
    track_ends = np.append(first, True)
    changes = np.diff(seen.at_edge.astype(np.int8), prepend=0, append=0) != 0
    ends = np.flatnonzero(changes | track_ends)
    reach = max(_LEAST_LINE, round(_TURN_S * fps))
    for start, stop in pairwise(ends.tolist()):
        if seen.at_edge[start] and not track_ends[start] and not track_ends[stop]:
            own = np.arange(max(start - reach, 0), min(stop + reach, len(seen)))
            own = own[part[own] == part[start]]
            ways = _Ways.of(seen, own, view, fps)
            row = ways.turn(start, stop, reach, view)
            if row:
                returns.append(ways.sharpened(row, reach))
    return returns


@dataclass(frozen=True, slots=True)
class Return:
    """A track that comes back over the picture's edge.

    Attributes:
        row: of `Seen`, the first that may be somebody else. start, stop: the rows, half-open, of
            which it is not sure on which side they are.
    """

    row: int
    start: int
    stop: int


@dataclass(frozen=True, slots=True)
class _Ways:
    """A track's way along the edge.

    Attributes:
        row: (k,) of `Seen`. time_s: (k,). low, high: (k, 2) px, the box's corners.
        where: (k, 4) m, the box's middle as large as metres look there, and the place.
    """

    row: Rows
    time_s: Floats
    low: Floats
    high: Floats
    where: Floats

    @classmethod
    def of(cls, seen: Seen, rows: Rows, view: View, fps: float) -> _Ways:
        low, high = seen.box[rows, :2], seen.box[rows, :2] + seen.box[rows, 2:]
        across_px = np.median(view.box_of_person(seen.place[rows], *_BODY_M)[:, 2])
        middle_m = (low + high) / 2 * (_BODY_M[1] / across_px)
        where = np.concatenate((middle_m, seen.place[rows]), axis=1)
        return cls(rows, seen.frame[rows] / fps, low, high, where)

    def turn(self, start: int, stop: int, reach: int, view: View) -> int:
        """The row from start to stop from which on somebody comes back; 0 where nobody does.

        Two straight lines explain most more than one there.
        """
        best, most = 0, 0.0
        for row in range(start, stop + 1):
            low, at, high = np.searchsorted(self.row, (row - reach, row, row + reach)).tolist()
            if min(at - low, high - at) < _LEAST_LINE:
                continue
            out, back = self._line(low, at), self._line(at, high)
            gain = self._line(low, high)[1] - out[1] - back[1]
            if gain > most and self._returns(low, at, high, out[0], back[0], view):
                best, most = row, gain
        return best

    def sharpened(self, row: int, reach: int) -> Return:
        """The row close by that parts the same stretch best, and those that do nearly as well."""
        low, at, high = np.searchsorted(self.row, (row - reach, row, row + reach)).tolist()
        nearby = np.arange(
            max(at - reach // 2, low + _LEAST_LINE), min(at + reach // 2, high - _LEAST_LINE) + 1
        )
        misses = np.array([self._line(low, n)[1] + self._line(n, high)[1] for n in nearby.tolist()])
        error_m = place_errors(self.where[at : at + 1, 2:])[0]
        rows = self.row[nearby[misses <= 2.0 * misses.min() + (_SURE * error_m) ** 2]]
        return Return(int(self.row[nearby[misses.argmin()]]), int(rows[0]), int(rows[-1]))

    def _returns(self, low: int, at: int, high: int, out: Floats, back: Floats, view: View) -> bool:
        """Whether ways (4,) m lead over the edge and back, as it looks and on the floor."""
        touched = _outward(self.low[low:high].min(axis=0), self.high[low:high].max(axis=0), view)
        place = self.where[at, 2:]
        outward = _over_edge(place, touched, view)
        out_m, back_m = ((way.reshape(2, 2) * outward).sum(axis=1) for way in (out, back))
        least_m = np.array((_WAY_M, _ERRORS * place_errors(place[None])[0]))
        return bool((out_m > least_m).all() and (back_m < -least_m).all())

    def _line(self, start: int, stop: int) -> tuple[Floats, float]:
        """The best straight way (4,) m through rows, and the sum of its squared misses."""
        rows = slice(start, stop)
        time_s = self.time_s[rows] - self.time_s[rows].mean()
        offset = self.where[rows] - self.where[rows].mean(axis=0)
        speed = time_s @ offset / max(float(time_s @ time_s), 1e-9)
        misses = float(np.square(offset - time_s[:, None] * speed).sum())
        return speed * np.ptp(time_s), misses


def _outward(low: Floats, high: Floats, view: View) -> Floats:
    """(2,) right and down: 1 or -1 where a box reaches out over that edge or the opposite one."""
    size = np.array(view.camera.size, float)
    out = np.stack((-low, high - (size - 1.0)))
    side = np.where(out[1] > out[0], 1.0, -1.0)
    return np.where(out.max(axis=0) >= -EDGE_SHARE * size.max(), side, 0.0)


def _over_edge(place: Floats, touched: Floats, view: View) -> Floats:
    """(2, 2) unit vectors out of the picture, as it looks and on the floor; 0 without an edge."""
    chest = np.append(place, MIDDLE_M)[None]
    pixel = view.pixel_from_world(chest)
    floor = view.floor_from_pixel(pixel + touched, MIDDLE_M)[0] - place
    both = np.nan_to_num(np.stack((touched, floor)))
    return np.asarray(both / np.maximum(np.hypot(*both.T), 1e-9)[:, None])
