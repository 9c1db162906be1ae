"""From the foreground of one camera to a region a person."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people.heads import bodies_in
from tracking.people.silhouettes import Box, Labels, silhouettes
from tracking.people.splitting import owners
from tracking.people.standing import Bodies, Standing

_LEAST_HEIGHT = 1 / 16
"""Of the picture, where nothing is known in metres: what is lower is nobody."""
_LEAST_SHARE = 0.28
"""Of a standing person's height, where it is known: people may crouch."""
_LEAST_FILL = 0.1
"""Of the square over a person's height, that the person's pixels cover at least."""


def people_regions(body: NDArray[np.uint8], standing: Standing) -> Labels:
    """(height, width) k + 1 for the pixels of person k, 0 elsewhere.

    Args:
        body: (height, width) uint8, non-zero in foreground that is no shadow.
        standing: sizes of people.
    """
    labels, boxes = silhouettes(body)
    regions = np.zeros_like(labels)
    count = 0
    for k, box in enumerate(boxes):
        left, top, width, height = box
        inside = np.s_[top : top + height, left : left + width]
        own = labels[inside] == k + 1
        bodies = bodies_in(own, left, top, standing)
        kept = _people(own, box, bodies, body.shape[0], standing)
        if kept is None:
            continue
        owner = owners(own, left, top, kept)
        painted = np.where(owner > 0, owner + np.uint8(count), np.uint8(0))
        np.copyto(regions[inside], painted, where=owner > 0)
        count += len(kept)
    return regions


def _people(
    own: NDArray[np.bool_], box: Box, bodies: Bodies, rows: int, standing: Standing
) -> Bodies | None:
    """The bodies in a silhouette that is large enough to be people."""
    seen = box[3]
    usual = float(bodies.height.min())
    if seen < _LEAST_HEIGHT * rows or (standing.calibrated and seen < _LEAST_SHARE * usual):
        return None
    if np.count_nonzero(own) < _LEAST_FILL * min(seen, usual) ** 2:
        return None
    return bodies
