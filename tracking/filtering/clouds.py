"""The shape of each person's particles: how far they spread, and whether they fall in two."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering.particles import Particles, Weights

_ROUNDS = 4
"""Of two-means along the longest direction; more move no border worth mentioning."""
_ONE_CLUSTER = 0.75
"""Share of the variance that two halves of an evenly filled line explain; of a bell it is 0.64."""
_LEAST_VARIANCE = 1e-12


def cloud_shapes(
    particles: Particles, weights: Weights
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Spread and split of all people's particles at once.

    The spread is the square root of the largest eigenvalue of the weighted covariance. The split
    tells how much of the variance along that direction lies between two clusters of them: 0 for
    one cluster, bell-shaped or even, and 1 for two points.

    Args:
        particles: (people, N, 2) m. weights: (people, N), rows sum to 1.

    Returns:
        (people,) m, and (people,) 0 to 1.
    """
    middle = (weights[:, None] @ particles)[:, 0]
    x = particles[..., 0] - middle[:, :1]
    y = particles[..., 1] - middle[:, 1:]
    weighted_x, weighted_y = x * weights, y * weights
    xx, yy, xy = np.vecdot(x, weighted_x), np.vecdot(y, weighted_y), np.vecdot(x, weighted_y)
    half, skew = (xx - yy) / 2, np.hypot((xx - yy) / 2, xy)
    variance = np.maximum((xx + yy) / 2 + skew, 0.0)
    angle = np.arctan2(xy, half) / 2
    along = x * np.cos(angle)[:, None] + y * np.sin(angle)[:, None]
    return np.sqrt(variance), _split(along, weights, variance)


def _split(
    along: NDArray[np.float32], weights: Weights, variance: NDArray[np.float32]
) -> NDArray[np.float32]:
    """(people,) 0 to 1; along: (people, N) m from the middle in the longest direction."""
    border = np.zeros(len(along), np.float32)
    share = below = border
    pull = along * weights
    for _ in range(_ROUNDS):
        low = (along < border[:, None]).astype(np.float32)
        share = np.vecdot(low, weights)
        # The middle is 0, so the upper cluster pulls as much as the lower one.
        below = np.vecdot(low, pull)
        border = (below / np.maximum(share, 1e-6) - below / np.maximum(1 - share, 1e-6)) / 2
    between = below**2 / np.maximum(share * (1.0 - share), 1e-6)
    explained = between / np.maximum(variance, _LEAST_VARIANCE)
    split = np.clip((explained - _ONE_CLUSTER) / (1.0 - _ONE_CLUSTER), 0.0, 1.0)
    return np.asarray(np.where(variance > _LEAST_VARIANCE, split, 0.0), np.float32)
