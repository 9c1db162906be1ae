"""Which pixels of a silhouette belong to which of the bodies in it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people.standing import Bodies

_CORE = 0.3
"""Within so many breadths of its axis a nearer body hides those behind."""


def owners(own: NDArray[np.bool_], left: int, top: int, bodies: Bodies) -> NDArray[np.uint8]:
    """(height, width) k + 1 where body k has the silhouette's pixel, 0 outside of it.

    A pixel belongs to the body whose axis, from the top of the head to the foot, is nearest in
    breadths of that body; above its head and below its feet nobody is.

    Args:
        own: (height, width) the silhouette in its box.
        left, top: of the box, working px.
        bodies: at least one.
    """
    v, u = np.nonzero(own)
    found = np.zeros(own.shape, np.uint8)
    found[v, u] = _nearest((u + left).astype(np.float64), (v + top).astype(np.float64), bodies) + 1
    return found


def _nearest(u: NDArray[np.float64], v: NDArray[np.float64], bodies: Bodies) -> NDArray[np.intp]:
    head, foot = bodies.head.T[..., None], bodies.foot.T[..., None]
    drop = np.maximum(foot[1] - head[1], 1.0)
    along = (v - head[1]) / drop
    axis = head[0] + np.clip(along, 0, 1) * (foot[0] - head[0])
    apart = np.abs(u - axis) / bodies.width[:, None]
    outside = np.maximum(np.maximum(-along, along - 1), 0)
    cost = apart + outside * bodies.height[:, None] / bodies.width[:, None]
    nearness = bodies.foot[:, 1].argsort(kind="stable").argsort(kind="stable")
    hides = (apart < _CORE) & (outside == 0)
    return np.asarray((cost - hides * (1.0 + nearness)[:, None]).argmin(axis=0), np.intp)
