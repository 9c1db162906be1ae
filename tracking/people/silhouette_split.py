"""Which pixels of a silhouette belong to which of the bodies in it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people.body_scale import Bodies

Floats = NDArray[np.float32]

_CORE = 0.3
"""Within so many breadths of its axis a nearer body hides those behind."""


@dataclass(frozen=True, slots=True)
class Placed:
    """Where on which body pixels lie; (n,) each.

    Attributes:
        body: whose the pixel is.
        along: 0 at the top of that body's head, 1 at its feet, on the body's axis.
        across: px from the axis in breadths of the body, never negative.
    """

    body: NDArray[np.intp]
    along: Floats
    across: Floats


def placed(u: NDArray[np.generic], v: NDArray[np.generic], bodies: Bodies) -> Placed:
    """Give pixels to bodies.

    A pixel belongs to the body whose axis, from the top of the head to the foot, is nearest in
    breadths of that body; above its head and below its feet nobody is. In its core the body that
    stands nearer comes before those behind.

    Args:
        u, v: (n,) working px.
        bodies: at least one.
    """
    head, foot = (ends.astype(np.float32).T[..., None] for ends in (bodies.head, bodies.foot))
    width, height = (size.astype(np.float32)[:, None] for size in (bodies.width, bodies.height))
    along = (v.astype(np.float32) - head[1]) / np.maximum(foot[1] - head[1], 1)
    axis = head[0] + np.clip(along, 0, 1) * (foot[0] - head[0])
    across = np.abs(u.astype(np.float32) - axis) / width
    body = np.zeros(len(u), np.intp)
    if len(bodies) > 1:
        outside = np.maximum(np.maximum(-along, along - 1), 0)
        nearness = bodies.foot[:, 1].argsort(kind="stable").argsort(kind="stable")
        hides = (across < _CORE) & (outside == 0)
        cost = across + outside * (height / width)
        body = (cost - hides * (1 + nearness.astype(np.float32))[:, None]).argmin(axis=0)
    pixel = np.arange(len(u))
    return Placed(body, along[body, pixel], across[body, pixel])
