"""Mean shift of tracklets written as the paper has it: one tracklet after the other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow import KernelTable
from tracking.trackers.flow.mean_shift import MOST_STEPS

Vectors = NDArray[np.float64]


def plain_settled(tracklets: Vectors, table: KernelTable) -> Vectors:
    """Every tracklet shifted until it moves no more."""
    return np.array([_settled(one.copy(), tracklets, table) for one in tracklets])


def plain_step(mode: Vectors, tracklets: Vectors, table: KernelTable) -> Vectors:
    """The mean of the tracklets within the kernel at each instant."""
    members = [one for one in tracklets if _holds(mode, one, table)]
    return np.mean(members, axis=0) if members else mode


def _settled(mode: Vectors, tracklets: Vectors, table: KernelTable) -> Vectors:
    for _ in range(MOST_STEPS):
        after = plain_step(mode, tracklets, table)
        still = np.abs(after - mode).max() <= 0.05
        mode = after
        if still:
            break
    return mode


def _holds(mode: Vectors, tracklet: Vectors, table: KernelTable) -> bool:
    for place, point in zip(mode, tracklet, strict=True):
        width, height = table.at(place)
        beside = abs(point[0] - place[0]) <= width / 2
        if not (beside and abs(point[1] - place[1]) <= height / 2):
            return False
    return True
