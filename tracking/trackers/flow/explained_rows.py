"""Which rows of tracklets a trajectory explains, and which show somebody nearer."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.bundles import Trajectory, gather_bundle, rows_near
from tracking.trackers.flow.chains import Rows, TrackletChains
from tracking.trackers.flow.floor import Floor, in_picture

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_LED_S = 0.3
_FAIR = 3.0
"""Misfit up to which a tracklet counts in full."""
_HEIGHTS_M, _HALF_WIDTHS_M = (0.0, 0.8, 1.5, 1.6, 1.75), (0.17, 0.28, 0.31, 0.17, 0.11)
_OVER_HEAD_M = 1.9
_TOP_SHARE, _LEAST_TOP_M, _PLACE_M = 95, 1.5, 0.3
"""Of a body whose head is in the picture, so many per cent of the points lie lower than its head.
The highest are on it, at least so high, as exactly as places so far off along the sight tell: legs,
and the arm of somebody nearer, which looks like a smaller body farther away, are no person."""
_LEAST_STEEP = 0.5
"""Slope of rays that tell how high a point is: straight below the camera none does."""
_BEHIND_M = 0.3
"""What is seen within this outline of a body is of this body: of nobody who is farther away than
it by more."""


@dataclass(frozen=True, slots=True, eq=False)
class ExplainedRows:
    """What a trajectory explains.

    Attributes:
        chain: (m,) the tracklets.
        row: (k,) their rows. of: (k,) the tracklet of each. well: (k,) 0 to 1, less where it suits
            the trajectory badly. away_m: (k,) how far away the walker is there. top_m: (k,) how
            high the point is at most. tells: (k,) whether the head is in the picture, and seen
            from where heights can be told.
    """

    chain: Rows
    row: Rows
    of: Rows
    well: Floats
    away_m: Floats
    top_m: Floats
    tells: Flags

    def count(self, left: Flags, front_m: Floats) -> float:
        """How many rows of tracklets that nobody explains yet are seen, and how well.

        A point that shows somebody nearer is not seen of a body behind.

        Args:
            left: (chains,) those that nobody explains. front_m: (rows,) see `cover_rows`.
        """
        return float(self.well[self._are_seen(left, front_m)].sum())

    def has_head(self, left: Flags, front_m: Floats) -> bool:
        """Whether the highest of these rows may be a head, if most heads are in the picture.

        Args:
            left, front_m: of `count`.
        """
        seen = self._are_seen(left, front_m)
        if 2 * self.tells[seen].sum() <= seen.sum():
            return True
        top_m = self.top_m[seen & self.tells]
        return bool(np.percentile(top_m, _TOP_SHARE) >= _LEAST_TOP_M)

    def _are_seen(self, left: Flags, front_m: Floats) -> Flags:
        return left[self.of] & (self.away_m < front_m[self.row] + _BEHIND_M)


def explained_rows(
    trajectory: Trajectory, chains: TrackletChains, floor: Floor, fps: float
) -> ExplainedRows:
    """The tracklets that move as the body of who walks a trajectory does."""
    near = gather_bundle(trajectory, chains, floor, fps, _LED_S)
    used = near.alike[near.number]
    well = np.clip(1.0 + _FAIR - near.misfit, 0.0, 1.0)
    place, slope = near.place[used], chains.slope[near.rows[used]]
    steep = np.hypot(*slope.T)
    tells = (steep > _LEAST_STEEP) & in_picture(place, _OVER_HEAD_M, floor)
    return ExplainedRows(
        near.chain[near.alike],
        near.rows[used],
        near.chain[near.number[used]],
        well[near.number[used]],
        np.hypot(*place.T),
        floor.heights(slope, place) + _PLACE_M / np.maximum(steep, _LEAST_STEEP),
        tells,
    )


def cover_rows(
    front_m: Floats, trajectory: Trajectory, chains: TrackletChains, floor: Floor
) -> None:
    """Take note of the rows that show the body of who walks a trajectory.

    Args:
        front_m: (rows,) how far away the nearest body is that covers each row, m; changed here.
    """
    rows, place, z_m = rows_near(trajectory, chains, floor)
    slope = chains.slope[rows]
    cross = slope[:, 1] * place[:, 0] - slope[:, 0] * place[:, 1]
    half_m = np.interp(z_m, _HEIGHTS_M, _HALF_WIDTHS_M, left=0.0, right=0.0)
    shown = np.abs(cross) < half_m * np.maximum(np.hypot(*slope.T), 1e-6)
    front_m[rows[shown]] = np.minimum(front_m[rows[shown]], np.hypot(*place[shown].T))
