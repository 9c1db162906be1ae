"""Two people in one region: who is on which side of it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association
from tracking.geometry import View
from tracking.people import Detections
from tracking.trackers.stereo.boxes import MIDDLE_M, Bodies
from tracking.trackers.stereo.population import Population
from tracking.tracks.boxes import common_px2

Floats = NDArray[np.float64]
_INSIDE = 0.5
"""Share of a person's expected box in a region from which on it may be part of it."""
_WIDER = 1.2
"""A region so many times wider than the body of who took it has room for another."""
_PATIENCE_S = 2.0
_FARTHEST_M = 0.6


@dataclass(frozen=True, slots=True)
class SharedRegions:
    """People in regions that hold two of them.

    Attributes:
        owner: (k,) index of the pair whose detection is shared. occluded: (k,) row of the person
            without a detection who is part of it.
        owner_at, occluded_at: (k, 2) m, where the region's sides put them.
    """

    owner: NDArray[np.intp]
    occluded: NDArray[np.intp]
    owner_at: Floats
    occluded_at: Floats

    def alone_of(self, pairs: Association) -> NDArray[np.bool_]:
        """(pairs,) whose region holds nobody else."""
        alone = np.ones(len(pairs.track), np.bool_)
        alone[self.owner] = False
        return alone


NONE_SHARED = SharedRegions(*np.zeros((2, 0), np.intp), *np.zeros((2, 0, 2)))


def find_shared_regions(
    people: Population, bodies: Bodies, pairs: Association, seen: Detections, view: View
) -> SharedRegions:
    """Find the regions that hold two people and put each on its side.

    [Kawashita2014] section 3.4 leaves regions larger than a person out. Where we differ: a region
    wider than the learnt outline of who took it, with somebody else expected in it, is both
    of them; its left side is the left one's and its right side the right one's, so that both stay
    where they are instead of one taking the middle and the other drifting off.

    Args:
        people: predicted to this frame. bodies: theirs, there.
        pairs: rows of people and of detections.
    """
    alone = people.confirmed & (people.missed_s < _PATIENCE_S)
    alone[pairs.track] = False
    occluded = np.flatnonzero(alone)
    if len(occluded) == 0:
        return NONE_SHARED
    box = bodies.boxes(people.outline)
    region = seen.box[pairs.detection]
    inside = _share_inside(box[occluded], region)
    room = region[:, 2] > _WIDER * box[pairs.track, 2]
    inside[:, ~room] = 0.0
    rows = np.flatnonzero(inside.max(axis=1, initial=0.0) >= _INSIDE)
    if len(rows) == 0:
        return NONE_SHARED
    owner, first = np.unique(inside[rows].argmax(axis=1), return_index=True)
    occluded = occluded[rows[first]]
    host = pairs.track[owner]
    left_occluded = (box[occluded, 0] + box[occluded, 2] / 2) < (box[host, 0] + box[host, 2] / 2)
    return SharedRegions(
        owner,
        occluded,
        _beside(bodies.select(host), box[host], region[owner], ~left_occluded, view),
        _beside(bodies.select(occluded), box[occluded], region[owner], left_occluded, view),
    )


def _share_inside(box: Floats, region: Floats) -> Floats:
    """(people, regions) the share of each box that lies in each region."""
    common = common_px2(box[:, None], region[None])
    return np.asarray(common / np.prod(box[:, 2:], axis=1)[:, None])


def _beside(
    bodies: Bodies, box: Floats, region: Floats, left: NDArray[np.bool_], view: View
) -> Floats:
    """(k, 2) m where people stand whose left or right side is the region's."""
    to_left = region[:, 0] - box[:, 0]
    to_right = region[:, 0] + region[:, 2] - box[:, 0] - box[:, 2]
    farthest = _FARTHEST_M * bodies.px_per_m[:, 0]
    middle = bodies.middle.copy()
    middle[:, 0] += np.clip(np.where(left, to_left, to_right), -farthest, farthest)
    return view.floor_from_pixel(middle, MIDDLE_M)
