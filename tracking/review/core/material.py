"""What every reason is looked for in, worked out once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats
from tracking.review.core.appearance import Looks, Sides
from tracking.review.core.evidence import Evidence, Rows
from tracking.tracks import Occluder

REACH_M = 1.2
"""People nearer than this can be taken for one another."""
_LOOKED_AT = (0.5, 1.0)
"""Places down a box that tell whether somebody stands behind something."""
_BORDER = 0.02
"""Share of the picture's width and height that counts as its border."""


@dataclass(frozen=True, slots=True, eq=False)
class Material:
    """The evidence with what several reasons need of it.

    Attributes:
        evidence: the rows. near: pairs within `REACH_M`. looks: over time.
        nearest: (n,) the track nearest to each row in its frame; 0 where nobody is within reach.
        sides: how tracks look before and after moments a tenth of a second apart.
        first, last: (t,) first and last row of each track.
        size: of the picture in px; of what the boxes reach where no camera is known.
        occluders: of the labels.
    """

    evidence: Evidence
    near: Neighbours
    looks: Looks
    nearest: Rows
    sides: Sides
    first: Rows
    last: Rows
    size: tuple[float, float]
    occluders: tuple[Occluder, ...]

    @classmethod
    def of(
        cls, evidence: Evidence, size: tuple[float, float] | None, occluders: tuple[Occluder, ...]
    ) -> Material:
        """Work it out; size: of the picture in px, None where it is not known."""
        near = neighbours(evidence, REACH_M)
        ends = np.flatnonzero(~evidence.goes_on)
        first = np.concatenate(([0], ends + 1)).astype(np.int64)[: len(ends) + 1]
        last = np.concatenate((ends, [len(evidence) - 1])).astype(np.int64)
        looks = Looks.of(evidence, near.nearest_m)
        return cls(
            evidence,
            near,
            looks,
            _nearest(evidence, near),
            Sides.of(looks),
            first if len(evidence) else first[:0],
            last if len(evidence) else last[:0],
            size or extent_of_boxes(evidence.box),
            occluders,
        )

    def at_border(self, rows: Rows) -> Flags:
        """(k,) whether the boxes touch the picture's border: people come and go there."""
        box = self.evidence.box[rows]
        margin = np.array(self.size) * _BORDER
        low, high = box[:, :2], box[:, :2] + box[:, 2:]
        return np.asarray(
            (low <= margin).any(axis=1)
            | (high >= np.array(self.size) - 1 - margin).any(axis=1)
            | ~np.isfinite(box).all(axis=1)
        )

    def at_occluder(self, rows: Rows) -> Flags:
        """(k,) whether a body's middle or feet lie in a labelled occluder."""
        box = self.evidence.box[rows]
        across = box[:, 0] + box[:, 2] / 2
        hidden = np.zeros(len(rows), np.bool_)
        for occluder in self.occluders:
            for share in _LOOKED_AT:
                point = np.stack((across, box[:, 1] + share * box[:, 3]), axis=1)
                hidden |= _within(point, np.array(occluder.polygon))
        return hidden


def _nearest(evidence: Evidence, near: Neighbours) -> Rows:
    """(n,) the track nearest to each row in its frame; 0 where nobody is within reach."""
    one = np.concatenate((near.first, near.second))
    other = np.concatenate((near.second, near.first))
    # Of what is written to one place several times the last stays: the nearest.
    order = np.argsort(-np.tile(near.distance_m, 2), kind="stable")
    tracks = np.zeros(len(evidence), np.int64)
    tracks[one[order]] = evidence.track[other[order]]
    return tracks


def _within(points: Floats, polygon: Floats) -> Flags:
    """(k,) whether points lie in a polygon: a ray to the right meets its edges an odd number."""
    u, v = points.T
    inside = np.zeros(len(points), np.bool_)
    for (u0, v0), (u1, v1) in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        if v0 != v1:
            crosses = (v0 > v) != (v1 > v)
            inside ^= crosses & (u < u0 + (v - v0) / (v1 - v0) * (u1 - u0))
    return inside


def extent_of_boxes(box: Floats) -> tuple[float, float]:
    """How far to the right and down any box (n, 4) reaches, in px."""
    far = box[:, :2] + box[:, 2:]
    far = far[np.isfinite(far).all(axis=1)]
    if not len(far):
        return 0.0, 0.0
    width, height = far.max(axis=0).tolist()
    return width, height


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
