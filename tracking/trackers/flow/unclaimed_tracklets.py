"""Tracklets of nobody given to people they move with."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import LOWEST_M, Floor, sight_axes
from tracking.trackers.flow.flow_frame import FlowFrame, paces
from tracking.trackers.flow.tracklet_owners import BOB_M, TrackletOwners
from tracking.trackers.flow.walkers import Walkers

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

_HALF_WIDTH_M, _HIGHEST_M = 0.24, 1.8
"""What lies farther from the upright axis, or higher, is off the body."""
_USUAL_OFF_M = 0.12
"""As far from the axis costs 1."""
_BODY_M, _HEAD_M = 0.2, 1.6
"""A body within this of its axis, and up to this height, hides what is behind."""
_PACE_M_S, _LEGS_M_S, _LEGS_BELOW_M = 0.35, 0.8, 0.65
"""As much faster or slower than the person costs 1: of a body, and of legs, which lie lower."""
_FARTHEST = 9.0
"""The cost from which on a tracklet is not theirs."""
_HIDDEN = 4.0
"""Of the squared distance: what belonging to somebody behind another body costs."""


def claim_tracklets(
    walkers: Walkers, owners: TrackletOwners, seen: FlowFrame, floor: Floor
) -> tuple[Indices, Indices]:
    """Rows of tracklets and of the people they belong to.

    Of tracklets of nobody those count that lie in somebody's body and move as it does; of several
    people the likeliest. Where a nearer body is in the way, it takes more to belong to the one
    behind it.
    """
    free = np.flatnonzero((owners.owner == 0) & seen.known)
    if not len(free) or not len(walkers):
        return free[:0], free[:0]
    cost = _costs(walkers, seen.slope[free], seen.before[free], seen.over_s, floor)
    best = cost.argmin(axis=0)
    good = cost[best, np.arange(len(free))] < _FARTHEST
    return free[good], best[good]


def _costs(walkers: Walkers, slope: Floats, before: Floats, over_s: float, floor: Floor) -> Floats:
    """(m, n) squared distances of tracklets from people; infinite for what cannot be."""
    place = walkers.place[:, None]
    z_m = floor.heights(slope[None], place)
    axes = sight_axes(walkers.place)
    off = np.einsum("mij,mnj->mni", axes, floor.places(slope[None], z_m) - place)
    aside = np.hypot(off[..., 0], off[..., 1])
    pace = paces(slope[None], before[None], z_m, over_s, floor.camera_m)
    miss = np.einsum("mij,mnj->mni", axes, pace - walkers.pace[:, None])
    steep = np.hypot(slope[:, 0], slope[:, 1])
    least = np.where(z_m < _LEGS_BELOW_M, _LEGS_M_S, _PACE_M_S)
    along = np.hypot(least, BOB_M * steep / over_s)
    cost = (aside / _USUAL_OFF_M) ** 2 + (miss[..., 0] / along) ** 2 + (miss[..., 1] / least) ** 2
    cost += _HIDDEN * _behind_bodies(walkers, aside, z_m)
    off_body = (aside > _HALF_WIDTH_M) | (z_m < LOWEST_M) | (z_m > _HIGHEST_M)
    return np.where(off_body, np.inf, cost)


def _behind_bodies(walkers: Walkers, aside: Floats, z_m: Floats) -> NDArray[np.bool_]:
    """(m, n) whether a body nearer than person m lies in a tracklet's ray."""
    nearer = np.argsort(np.hypot(*walkers.place.T), kind="stable")
    body = ((aside < _BODY_M) & (z_m < _HEAD_M) & (z_m > LOWEST_M))[nearer]
    before = np.cumsum(body, axis=0) - body > 0
    behind = np.empty_like(before)
    behind[nearer] = before
    return behind
