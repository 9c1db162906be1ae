"""A frame as the flow tracker sees it: tracklets, where their rays go, and the foreground."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.point_tracker import Tracklets

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

POSITIONS = 3
"""Of a tracklet as it is clustered: n in [Yoneji2013] eq. 1."""
_BODY_MIDDLE_M = 0.8


@dataclass(frozen=True, slots=True, eq=False)
class FlowFrame:
    """One frame.

    Attributes:
        tracklets: n of them.
        slope, before: (n, 2) where their rays go (see `Floor`), now and `over_s` ago; NaN: not
            known.
        over_s: time between the first and the last position of those that are clustered.
        mask: (rows, columns) of the foreground at half resolution, as in `FlowObservation`.
        elapsed_s: since the frame before.
        fps: frames a second.
    """

    tracklets: Tracklets
    slope: Floats
    before: Floats
    over_s: float
    mask: NDArray[np.uint8]
    elapsed_s: float
    fps: float

    @classmethod
    def of(
        cls,
        tracklets: Tracklets,
        mask: NDArray[np.uint8],
        elapsed_s: float,
        fps: float,
        floor: Floor,
    ) -> FlowFrame:
        """The tracklets of a frame with their rays."""
        slope = floor.slopes(tracklets.path[:, 0].astype(np.float64))
        before = floor.slopes(tracklets.path[:, POSITIONS - 1].astype(np.float64))
        return cls(tracklets, slope, before, (POSITIONS - 1) / fps, mask, elapsed_s, fps)

    @property
    def known(self) -> Flags:
        """(n,) whether a tracklet has all positions, and floor to see below it."""
        return np.asarray(np.isfinite(self.slope + self.before).all(axis=1))

    @property
    def age_s(self) -> Floats:
        """(n,) how long each was followed."""
        return self.tracklets.age / self.fps

    def vectors(self, rows: NDArray[np.intp]) -> Floats:
        """(k, positions, 2) px, what is clustered of some tracklets."""
        return self.tracklets.path[rows, :POSITIONS].astype(np.float64)


def paces(slope: Floats, before: Floats, z_m: Floats, over_s: float, camera_m: float) -> Floats:
    """(..., 2) m/s on the floor of points at a height whose slope changed over some time."""
    return np.asarray((slope - before) * (camera_m - z_m)[..., None] / over_s)


def speeds(tracklets: Tracklets, positions: int, fps: float, floor: Floor) -> Floats:
    """(n,) m/s of tracklets over their last positions, as if half a body high; NaN: too short."""
    path = tracklets.path.astype(np.float64)
    first, last = floor.slopes(path[:, 0]), floor.slopes(path[:, positions - 1])
    middle = np.full(len(tracklets), _BODY_MIDDLE_M)
    pace = paces(first, last, middle, (positions - 1) / fps, floor.camera_m)
    return np.asarray(np.hypot(pace[:, 0], pace[:, 1]))
