"""From the foreground of one camera to a region a person."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people.heads import bodies_in
from tracking.people.silhouettes import Box, Labels, silhouettes
from tracking.people.splitting import placed
from tracking.people.standing import Bodies, Standing
from tracking.people.upright import SHADOW, body_pixels

_LEAST_HEIGHT = 1 / 16
"""Of the picture, where nothing is known in metres: what is lower is nobody."""
_LEAST_SHARE = 0.28
"""Of a standing person's height, where it is known: people may crouch."""
_LEAST_FILL = 0.1
"""Of the square over a person's height, that the person's pixels cover at least."""
_ABOVE = 0.1
"""Of a body's height, that hair may reach above what was first seen of it."""


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
    for k, box in enumerate(boxes):
        left, top, width, height = box
        own = labels[top : top + height, left : left + width] == k + 1
        bodies = bodies_in(own, left, top, standing)
        if _are_people(own, box, bodies, labels.shape[0], standing):
            _paint(regions, kind, labels, k + 1, box, bodies, count, standing.calibrated)
            count += len(bodies)
    return regions


def _paint(
    regions: Labels,
    kind: NDArray[np.uint8],
    labels: Labels,
    label: int,
    box: Box,
    bodies: Bodies,
    count: int,
    metric: bool,
) -> None:
    """Give a silhouette's pixels, and what looks like shadow in its bodies, to the bodies."""
    left, top, width, height = box
    top = max(0, top - int(_ABOVE * bodies.height.max()))
    inside = np.s_[top : box[1] + height, left : left + width]
    own = labels[inside] == label
    v, u = np.nonzero(own | ((labels[inside] == 0) & (kind[inside] == SHADOW)))
    place = placed(u + left, v + top, bodies)
    # Holes that were closed are of the body, whatever they look like.
    found = np.where(own[v, u], np.where(kind[inside][v, u] == 1, 1, 255), kind[inside][v, u])
    kept = body_pixels(found.astype(np.uint8), place, len(bodies), metric)
    regions[inside][v[kept], u[kept]] = place.body[kept] + count + 1


def _are_people(
    own: NDArray[np.bool_], box: Box, bodies: Bodies, rows: int, standing: Standing
) -> bool:
    """Whether a silhouette is large enough to be people."""
    seen, usual = box[3], float(bodies.height.min())
    if seen < _LEAST_HEIGHT * rows or (standing.calibrated and seen < _LEAST_SHARE * usual):
        return False
    return bool(np.count_nonzero(own) >= _LEAST_FILL * min(seen, usual) ** 2)
