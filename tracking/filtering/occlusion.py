"""Where on the floor people cannot be seen because others stand in front of them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats

_HEAD_M = 1.75
_COVERED_M = 1.1
"""A body covered up to this height is not found."""
_LONGEST_M = 8.0


def hiding_reach(occluder: Floats, camera_height_m: float) -> Floats:
    """How far behind each person (people, 2) others are covered: (people,) m.

    The line of sight over a head falls to the covered height at this distance behind it; under a
    camera no higher than the head it never does, and the reach is the longest there is.
    """
    range_m = np.hypot(occluder[:, 0], occluder[:, 1])
    above = max(camera_height_m - _HEAD_M, 1e-6)
    return np.minimum((_HEAD_M - _COVERED_M) * range_m / above, _LONGEST_M)


def out_of_hiding(
    particles: NDArray[np.float32], occluder: Floats, reach_m: Floats, body_m: float
) -> NDArray[np.float32]:
    """How far each particle is from the nearest place where it would not be seen.

    Such a place is a strip on the floor as broad as a body that starts at a person and leads away
    from the camera.

    Args:
        particles: (people, N, 2) m. occluder: (others, 2) m; at least one.
        reach_m: (others,) length of each strip. body_m: half its breadth.

    Returns:
        (people, N) m; 0 inside a strip.
    """
    others = occluder.astype(np.float32)
    range_m = np.maximum(np.hypot(others[:, 0], others[:, 1]), np.float32(1e-6))
    away = others / range_m[:, None]
    along = particles @ away.T - range_m
    across = np.abs(particles @ np.stack((-away[:, 1], away[:, 0])))
    long = np.maximum(-along - body_m, along - reach_m.astype(np.float32))
    beyond = np.maximum(np.maximum(across - body_m, long), 0.0)
    return np.asarray(beyond.min(axis=2), np.float32)
