"""Who is near whom: all pairs of rows of one frame within a distance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.review.core.evidence import Evidence, Rows

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Neighbours:
    """Pairs of rows.

    Attributes:
        first, second: (k,) rows of one frame, the first of the lower track; ordered by the pair
            of tracks, then by frame.
        distance_m: (k,).
        nearest_m: (n,) for each row of the evidence how far the nearest other one is; at least
            the radius where nobody is within it.
    """

    first: Rows
    second: Rows
    distance_m: Floats
    nearest_m: Floats


def neighbours(evidence: Evidence, radius_m: float) -> Neighbours:
    """All pairs within the radius.

    A sweep over each frame's rows in order of x: as many passes as people stand within a strip as
    broad as the radius, each over all frames at once.
    """
    x, y = evidence.place.T
    known = np.flatnonzero(np.isfinite(x) & np.isfinite(y))
    order = known[np.lexsort((x[known], evidence.frame[known]))]
    frame, x, y = evidence.frame[order], x[order], y[order]
    found: list[tuple[Rows, Rows, Floats]] = []
    left = np.arange(len(order))
    step = 0
    while len(left):
        step += 1
        left = left[left + step < len(order)]
        right = left + step
        near = (frame[left] == frame[right]) & (x[right] - x[left] <= radius_m)
        left, right = left[near], right[near]
        distance = np.hypot(x[right] - x[left], y[right] - y[left])
        close = distance <= radius_m
        found.append((order[left[close]], order[right[close]], distance[close]))
    return _ordered(evidence, found, radius_m)


def _ordered(
    evidence: Evidence, found: list[tuple[Rows, Rows, Floats]], radius_m: float
) -> Neighbours:
    nothing = (np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0))
    one, other, distance = (np.concatenate(parts) for parts in zip(nothing, *found, strict=True))
    first, second = np.minimum(one, other), np.maximum(one, other)
    order = np.lexsort((evidence.frame[first], evidence.track[second], evidence.track[first]))
    nearest = np.full(len(evidence), radius_m)
    for side in (first, second):
        np.minimum.at(nearest, side, distance)
    return Neighbours(first[order], second[order], distance[order], nearest)
