"""People who walk as a script says: who is where at which moment."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from tracking.arrays import Floats
from tracking.synthesis.crowd import PlannedWalk

EVERYBODY = -1

_FINE_HZ = 60.0
_ROUNDED_S = 0.22  # people neither start nor turn at once
_TURNED_S = 0.35
_TURNS_BEFORE_S = 0.6  # who has stood turns round before going on


@dataclass(frozen=True, slots=True, eq=False)
class Role:
    """One person's way.

    Attributes:
        points: (k, 3) seconds, world x, y; straight and steady in between. The same place twice
            is a stay.
    """

    points: Floats

    def later(self, seconds: float) -> Role:
        """The same way at another time."""
        return Role(self.points + np.array([seconds, 0.0, 0.0]))


@dataclass(frozen=True, slots=True)
class Moment:
    """A stretch of a scenario that has a name.

    Attributes:
        start_s, end_s: from when to when, half-open.
        person: index of who it is about, or `EVERYBODY`.
        kind: "stands", "walks" or "situation".
        name: the mark, the two marks walked between, or what happens.
        difficulty: of a situation, 1 to 5; 0: not rated.
    """

    start_s: float
    end_s: float
    person: int
    kind: str
    name: str
    difficulty: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Scenario:
    """Everybody's way, and the moments in it that are looked at."""

    roles: tuple[Role, ...]
    moments: tuple[Moment, ...]

    def walks(self, frames: int, fps: float) -> tuple[PlannedWalk | None, ...]:
        """The walks of all roles over `frames` frames; None for who comes later than that."""
        return tuple(_walk_of(role, frames, fps) for role in self.roles)


def _walk_of(role: Role, frames: int, fps: float) -> PlannedWalk | None:
    first = int(np.ceil(role.points[0, 0] * fps))
    last = min(int(role.points[-1, 0] * fps), frames - 1)
    if last < first:
        return None
    fine = np.arange(role.points[0, 0], role.points[-1, 0] + 1.0 / _FINE_HZ, 1.0 / _FINE_HZ)
    rounded = [
        gaussian_filter1d(_at(role, fine, axis), _ROUNDED_S * _FINE_HZ, mode="nearest")
        for axis in (1, 2)
    ]
    heading = gaussian_filter1d(_heading(role, fine), _TURNED_S * _FINE_HZ, mode="nearest")
    at = np.arange(first, last + 1) / fps
    x, y, turned = (np.interp(at, fine, values) for values in (*rounded, heading))
    return PlannedWalk(first, np.column_stack((x, y)), turned)


def _at(role: Role, seconds: Floats, axis: int) -> Floats:
    return np.asarray(np.interp(seconds, role.points[:, 0], role.points[:, axis]))


def _heading(role: Role, seconds: Floats) -> Floats:
    """Where the person looks, unwrapped, in steps: along the leg, after a stay along the next."""
    legs = np.diff(role.points, axis=0)
    moves = np.hypot(legs[:, 1], legs[:, 2]) > 1e-6
    begins = role.points[:-1, 0].copy()
    after_stay = np.concatenate(([False], ~moves[:-1]))
    begins[after_stay] -= _TURNS_BEFORE_S
    angles = np.unwrap(np.arctan2(legs[moves, 2], legs[moves, 1]))
    leg = np.searchsorted(begins[moves], seconds, side="right") - 1
    return np.asarray(angles[np.maximum(leg, 0)])
