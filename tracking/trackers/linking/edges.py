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
_LEAST_LINE = 3
"""Rows of a line."""
_BODY_M = (1.7, 0.5)
"""Height and width of a usual one."""
_WAY_M = 0.12
"""Who seems to move less than this, out and in again, may have stood there."""
_ERRORS = 1.5
"""The same on the floor, in errors of a measured place."""


def returned_over_edge(seen: Seen, first: Flags, view: View, fps: float) -> Flags:
    """(n,) rows where a track that went out over the picture's edge comes back over it.

    One row in each stretch along the edge that has others before and after it: where the way
    turns most, if it does from outwards to inwards.

    Args:
        first: (n,) where tracks begin, or go on after a gap.
    """
    returned = np.zeros(len(seen), bool)
    part = np.cumsum(first)
    track_ends = np.append(first, True)
    changes = np.diff(seen.at_edge.astype(np.int8), prepend=0, append=0) != 0
    ends = np.flatnonzero(changes | track_ends)
    reach = max(_LEAST_LINE, round(_TURN_S * fps))
    for start, stop in pairwise(ends.tolist()):
        if seen.at_edge[start] and not track_ends[start] and not track_ends[stop]:
            own = np.arange(max(start - reach, 0), min(stop + reach, len(seen)))
            own = own[part[own] == part[start]]
            row = _Ways.of(seen, own, view, fps).turn(start, stop, reach, view)
            returned[row] = row > 0
    return returned


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
            before = slice(*np.searchsorted(self.row, (row - reach, row)))
            after = slice(*np.searchsorted(self.row, (row, row + reach)))
            if min(before.stop - before.start, after.stop - after.start) < _LEAST_LINE:
                continue
            around = slice(before.start, after.stop)
            out, parted = self._line(before)
            back, other = self._line(after)
            gain = self._line(around)[1] - parted - other
            if gain > most and self._returns(around, self.where[after.start, 2:], out, back, view):
                best, most = row, gain
        return best

    def _returns(self, around: slice, place: Floats, out: Floats, back: Floats, view: View) -> bool:
        """Whether ways (4,) m lead over the edge and back, as it looks and on the floor."""
        touched = _outward(self.low[around].min(axis=0), self.high[around].max(axis=0), view)
        outward = _over_edge(place, touched, view)
        out_m, back_m = ((way.reshape(2, 2) * outward).sum(axis=1) for way in (out, back))
        least_m = np.array((_WAY_M, _ERRORS * place_errors(place[None])[0]))
        return bool((out_m > least_m).all() and (back_m < -least_m).all())

    def _line(self, rows: slice) -> tuple[Floats, float]:
        """The best straight way (4,) m through rows, and the sum of its squared misses."""
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
