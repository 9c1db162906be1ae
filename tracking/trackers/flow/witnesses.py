"""Whether the tracklets of a run leave room for somebody at a place."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.foot_fit import ratios
from tracking.tracks.run import Run

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]

_HALF_WIDTH_M, _LOW_M, _HIGH_M = 0.2, 0.3, 1.75
"""Points so near to the axis, at such heights, are of the body or of what hides it."""
_NOWHERE = 0.2
"""Where the foreground ends by so much farther away, as a logarithm, nobody stands."""
_MOST_OF_THREE = 2
_COLUMNS = ("u0", "v0", "foot_v")


class Witnesses:
    """The tracklets of a run, asked who may be where.

    Whoever is in sight has tracklets, or stands behind somebody who has. Where no tracklet lies
    in the outline of a body, or where the foreground below all of them ends far behind it, there
    is nobody. A run of which no tracklets are known leaves room everywhere.
    """

    def __init__(self, run: Run, floor: Floor) -> None:
        """What was followed in each frame."""
        columns = {name: np.asarray(run.tracklets.columns[name]) for name in _COLUMNS}
        u, v, foot_v = (columns[name].astype(np.float64) for name in _COLUMNS)
        self.floor = floor
        self._start = run.tracklets.start
        self._slope = floor.slopes(np.column_stack((u, v)))
        foot = floor.slopes(np.column_stack((u, foot_v)))
        self._feet_m = np.hypot(*foot.T) * floor.camera_m

    def allow(self, place: Floats, frame: Integers) -> Flags:
        """(n,) whether somebody may be at places (n, 2) in frames (n,)."""
        if not len(self._slope):
            return np.ones(len(place), bool)
        allowed = np.zeros(len(place), bool)
        order = np.argsort(frame, kind="stable")
        for rows in np.split(order, np.flatnonzero(np.diff(frame[order])) + 1):
            if len(rows) and 0 <= frame[rows[0]] < len(self._start) - 1:
                allowed[rows] = self._of_frame(place[rows], int(frame[rows[0]]))
        return allowed

    def allow_for_a_while(self, place: Floats, frame: Integers) -> Flags:
        """(k, t) the same of places (k, t, 2) in frames (k, t), one after the other.

        By the most of each three: points are lost for a moment.
        """
        if not frame.size:
            return np.zeros(frame.shape, bool)
        each = self.allow(place.reshape(-1, 2), frame.ravel()).reshape(frame.shape)
        wide = np.pad(each.astype(np.int64), ((0, 0), (1, 1)), mode="edge")
        return np.asarray(wide[:, :-2] + wide[:, 1:-1] + wide[:, 2:] >= _MOST_OF_THREE)

    def _of_frame(self, place: Floats, frame: int) -> Flags:
        """(k,) the same of one frame."""
        seen = slice(int(self._start[frame]), int(self._start[frame + 1]))
        slope, place = self._slope[seen][None], place[:, None]
        cross = slope[..., 1] * place[..., 0] - slope[..., 0] * place[..., 1]
        near = np.abs(cross) < _HALF_WIDTH_M * np.hypot(slope[..., 0], slope[..., 1])
        z_m = self.floor.heights(slope, place)
        near &= (z_m > _LOW_M) & (z_m < _HIGH_M)
        ratio = ratios(self._feet_m[seen], np.hypot(place[..., 0], place[..., 1]))
        return np.asarray((near & ~(ratio > _NOWHERE)).any(axis=1))
