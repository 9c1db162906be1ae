"""From the foreground of one camera to a region a person."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people.heads import bodies_in
from tracking.people.silhouettes import Box, Labels, silhouettes
from tracking.people.splitting import placed
from tracking.people.standing import Bodies, Standing
from tracking.people.upright import BODY, SHADOW, body_pixels

_LEAST_HEIGHT = 1 / 16
"""Of the picture, where nothing is known in metres: what is lower is nobody."""
_LEAST_SHARE = 0.28
"""Of a standing person's height, where it is known: people may crouch."""
_LEAST_FILL = 0.1
"""Of the square over a person's height, that the person's pixels cover at least."""
_ABOVE = 0.1
"""Of a body's height, that hair may reach above what was first seen of it."""
_UNEXPLAINED = 1.13
"""Pixels so far down a body, its height being 1, belong to somebody who stands nearer."""
_MOST_NEARER = 2


@dataclass(frozen=True, slots=True)
class Silhouette:
    """A silhouette and the bodies in it.

    Attributes:
        label: its pixels' in the picture of labels.
        box: left, top, width, height in working px.
        bodies: whose heads are seen, or whose feet.
    """

    label: int
    box: Box
    bodies: Bodies


def people_regions(kind: NDArray[np.uint8], standing: Standing) -> Labels:
    """(height, width) k + 1 for the pixels of person k, 0 elsewhere.

    Args:
        kind: (height, width) uint8, 0 in the background, else of `tracking.people.upright`.
        standing: sizes of people.
    """
    certain = np.where(kind == SHADOW, np.uint8(0), kind)
    labels, boxes = silhouettes(certain)
    regions = np.zeros_like(labels)
    count = 0
    # From the top down: a head without a chest finds it before its own feet look for one.
    for k in sorted(range(len(boxes)), key=lambda k: boxes[k][1]):
        found = _silhouette(labels, k + 1, boxes[k], standing)
        if _paint(regions, kind, labels, found, count, standing.calibrated):
            count += len(found.bodies)
    return regions


def _silhouette(labels: Labels, label: int, box: Box, standing: Standing) -> Silhouette:
    left, top, width, height = box
    own = labels[top : top + height, left : left + width] == label
    bodies = bodies_in(own, left, top, standing)
    if standing.calibrated:
        v, u = np.nonzero(own)
        for _ in range(_MOST_NEARER):
            nearer = _nearer(u + left, v + top, bodies, standing)
            if nearer is None:
                break
            bodies = bodies.with_others(nearer)
    return Silhouette(label, box, bodies)


def _nearer(
    u: NDArray[np.intp], v: NDArray[np.intp], bodies: Bodies, standing: Standing
) -> Bodies | None:
    """Somebody whose feet are seen below all others' and whose head nothing shows."""
    rest = placed(u, v, bodies).along > _UNEXPLAINED
    if not rest.any():
        return None
    low = int(v[rest].max())
    body = standing.above(np.array([[float(np.median(u[rest])), float(low)]]))
    enough = _LEAST_FILL / 2 * body.height[0] ** 2
    return body if np.count_nonzero(rest) >= enough and body.head[0, 1] < low else None


def _paint(
    regions: Labels,
    kind: NDArray[np.uint8],
    labels: Labels,
    silhouette: Silhouette,
    count: int,
    metric: bool,
) -> bool:
    """Give pixels of a silhouette, and what looks like shadow in its bodies, to the bodies.

    Returns:
        Whether there are people; nothing is painted otherwise.
    """
    bodies = silhouette.bodies
    inside = _reach(silhouette, labels.shape, metric)
    top, left = inside[0].start, inside[1].start
    own = labels[inside] == silhouette.label
    shadow = (labels[inside] == 0) & (kind[inside] == SHADOW) & (regions[inside] == 0)
    v, u = np.nonzero(own | shadow)
    place = placed(u + left, v + top, bodies)
    found = kind[inside][v, u]
    found[found == 0] = BODY
    kept = body_pixels(found, place, u, len(bodies), metric)
    if not _are_people(v[kept], bodies, labels.shape[0], metric):
        return False
    regions[inside][v[kept], u[kept]] = place.body[kept] + count + 1
    return True


def _reach(silhouette: Silhouette, shape: tuple[int, ...], metric: bool) -> tuple[slice, slice]:
    """The rows and columns in which a silhouette's bodies may have pixels."""
    left, top, width, height = silhouette.box
    bodies = silhouette.bodies
    right, bottom = left + width, top + height
    top = max(0, top - int(_ABOVE * bodies.height.max()))
    if metric:
        bottom = max(bottom, int(bodies.foot[:, 1].max()))
        left = min(left, int((bodies.head[:, 0] - bodies.width / 2).min()))
        right = max(right, int((bodies.head[:, 0] + bodies.width / 2).max()))
    return slice(top, min(bottom, shape[0])), slice(max(left, 0), min(right, shape[1]))


def _are_people(rows: NDArray[np.intp], bodies: Bodies, height: int, metric: bool) -> bool:
    """Whether pixels in these rows are enough for people."""
    if len(rows) == 0:
        return False
    seen, usual = int(rows.max() - rows.min()) + 1, float(bodies.height.min())
    if seen < _LEAST_HEIGHT * height or (metric and seen < _LEAST_SHARE * usual):
        return False
    return bool(len(rows) >= _LEAST_FILL * min(seen, usual) ** 2)
