"""Who crouches or bends down while standing, and when."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.synthesis.crowd import PlannedWalk

_STANDS_M_S = 0.15
_DOWN_S = 0.6
"""How long it takes to go down, and again to stand up."""

_SHORTEST_S = 2 * _DOWN_S + 0.5
_BENDS = 0.4  # share of the stoops that are bends from the hip, not crouches


@dataclass(frozen=True, slots=True, eq=False)
class Stoops:
    """How far down one person is, a row each frame of the walk.

    Attributes:
        crouch: (n,) 0 standing .. 1 squatting with the hips near the heels.
        bend: (n,) 0 upright .. 1 bent over from the hip with nearly straight legs.
    """

    crouch: Floats
    bend: Floats


def stoops_of(walk: PlannedWalk, fps: float, share: float, rng: np.random.Generator) -> Stoops:
    """The stoops of a walk.

    Args:
        walk: the way; people stoop only while they stand long enough.
        fps: frames a second of the walk.
        share: of the long enough stops in which somebody goes down.
        rng: says in which, and how.
    """
    crouch, bend = np.zeros(len(walk.position)), np.zeros(len(walk.position))
    for start, end in _stops(walk, fps):
        if end - start < _SHORTEST_S * fps or rng.random() >= share:
            continue
        depth = rng.uniform(0.8, 1.0)
        way = bend if rng.random() < _BENDS else crouch
        way[start:end] = depth * _down_and_up(end - start, fps)
    return Stoops(crouch, bend)


def _stops(walk: PlannedWalk, fps: float) -> list[tuple[int, int]]:
    """Half-open ranges of the walk's rows in which the person stands."""
    moved = np.linalg.norm(np.diff(walk.position, axis=0, prepend=walk.position[:1]), axis=1)
    stands = np.concatenate(([0], (moved * fps < _STANDS_M_S).astype(int), [0]))
    edges = np.flatnonzero(np.diff(stands))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def _down_and_up(frames: int, fps: float) -> Floats:
    """0 at both ends of a stop, 1 in between, without jerks."""
    from_end = np.minimum(np.arange(frames), frames - 1 - np.arange(frames)) / fps
    way = np.clip(from_end / _DOWN_S, 0.0, 1.0)
    return np.asarray(way**2 * (3 - 2 * way))
