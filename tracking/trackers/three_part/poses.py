"""Where the parts of a person can be to each other, standing, bending or crouching.

All distances are in heights of the person standing upright, so that one rule serves people near
and far. The limits hold for all of the rendered walks, bends and crouches they were read from
(seeds 4111 to 4114 and 4161 to 4163), with half as much again of room.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.three_part.people import Flags, Floats
from tracking.tracks import HEAD, HIP_LEG, TORSO

_HEAD_FROM_TORSO = ((-0.28, -0.48), (0.28, -0.08))
_LEGS_FROM_TORSO = ((-0.30, 0.04), (0.30, 0.48))
_LEGS_FROM_HEAD = ((-0.42, 0.20), (0.42, 0.85))
"""Lowest and highest offset x, y of the rectangles' middles."""
_LARGEST = np.array((0.28, 0.45, 0.50))
_SMALLEST = np.array((0.02, 0.05, 0.05))
"""Of the rectangles' heights."""
_CHANGE = 0.06
"""How far parts move against each other within the memory of a pose, in heights."""
_SLACK = 0.05
"""How far out of its limits a part is as unlikely as one standard deviation."""


def pose_faults(rectangles: Floats, height: Floats) -> Flags:
    """(people, 3) parts that cannot be where they are.

    Where the other two go together, the third is at fault; where no two do, all are.

    Args:
        rectangles: (people, 3, 4) cx, cy, width, height px. height: (people,) px, upright.
    """
    head_torso, torso_legs, head_legs = (
        np.asarray((excess == 0.0).all(axis=-1)) for excess in _excesses(rectangles, height)
    )
    fault = np.zeros((len(rectangles), 3), bool)
    fault[:, HEAD] = ~head_torso & (torso_legs | ~head_legs)
    fault[:, TORSO] = ~head_torso & ~torso_legs
    fault[:, HIP_LEG] = ~torso_legs & (head_torso | ~head_legs)
    size = rectangles[..., 3] / height[:, None]
    return np.asarray(fault | (size > _LARGEST) | (size < _SMALLEST))


def log_prior(
    rectangles: NDArray[np.floating], pose: Floats, height: NDArray[np.floating]
) -> Floats:
    """(particles,) log of how likely poses are.

    Poses nobody can take are next to impossible; of the others those are likelier that the person
    had a moment ago.

    Args:
        rectangles: (particles, 3, 4) px.
        pose: (particles, 3, 2) px, where the middles were from their mean.
        height: (particles,) px, of their person upright.
    """
    total = sum((excess**2).sum(axis=-1) for excess in _excesses(rectangles, height))
    size = rectangles[..., 3] / height[:, None]
    beyond = np.maximum(size - _LARGEST, 0.0) + np.maximum(_SMALLEST - size, 0.0)
    total = total + (beyond**2).sum(axis=-1)
    middle = rectangles[..., :2]
    bent = middle - middle.mean(axis=1, keepdims=True) - pose
    change = (bent**2).sum(axis=(1, 2)) / np.maximum(height, 1.0) ** 2
    return np.asarray(-0.5 * (total / _SLACK**2 + change / _CHANGE**2))


def _excesses(
    rectangles: NDArray[np.floating], height: NDArray[np.floating]
) -> tuple[Floats, Floats, Floats]:
    """(people, 2) each: how far head from torso, legs from torso, legs from head are out."""
    middle = rectangles[..., :2] / np.maximum(height, 1.0)[:, None, None]
    head, torso, legs = (middle[:, part] for part in (HEAD, TORSO, HIP_LEG))
    return (
        _beyond(head - torso, _HEAD_FROM_TORSO),
        _beyond(legs - torso, _LEGS_FROM_TORSO),
        _beyond(legs - head, _LEGS_FROM_HEAD),
    )


def _beyond(offset: Floats, limits: tuple[tuple[float, float], tuple[float, float]]) -> Floats:
    low, high = np.array(limits)
    return np.asarray(np.maximum(offset - high, 0.0) + np.maximum(low - offset, 0.0))
