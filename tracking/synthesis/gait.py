"""From a way over the floor to steps: where each foot stands, when it swings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d

from tracking.arrays import Floats
from tracking.synthesis.crowd import PlannedWalk

_STANCE = 0.6  # share of a stride in which a foot stands
_MIDDLE = 0.3  # the body passes over the foot in the middle of that
_TURN_STEP_M = 0.2  # turning on the spot by a radian costs steps as this distance does
_FOOT_GAP = 0.044  # half the distance between the feet, as a share of body height
_LIFT = 0.026  # how high a swinging ankle is lifted
_BRISK_M_S = 1.1  # from this pace on limbs swing fully
_PITCH_AT = (0.0, 0.08, 0.36, 0.6, 0.72, 0.9, 1.0)
_PITCH_RAD = (-0.32, 0.0, 0.05, 0.62, 0.75, -0.15, -0.32)  # heel up is positive


@dataclass(frozen=True, slots=True, eq=False)
class Steps:
    """How one person's feet follow the walk, a row each frame; feet are left, right.

    Attributes:
        foot: (n, 2, 2) world x, y under each foot's middle.
        yaw: (n, 2) where each foot points, radians.
        lift_m: (n, 2) how far it is off the floor.
        pitch: (n, 2) radians, heel up is positive.
        phase: (n,) strides walked; the left foot lands at whole numbers.
        pace: (n,) 0 standing .. 1 walking briskly: how much limbs swing.
    """

    foot: Floats
    yaw: Floats
    lift_m: Floats
    pitch: Floats
    phase: Floats
    pace: Floats


def steps_of(walk: PlannedWalk, height_m: float, fps: float, start: float) -> Steps:
    """The steps of a walk.

    A foot that stands does not move: it lands where the body will pass over it in the middle of
    its stance, so neither turns nor changes of speed make it skate.

    Args:
        walk: the way.
        height_m: the person's height, which sets the length of a stride.
        fps: frames a second of the walk.
        start: phase at the first frame, in strides.
    """
    way = _Way(walk, fps)
    stride_m = height_m * (0.42 + 0.22 * min(way.usual_speed, 1.6))
    phase = start + way.distance / stride_m
    pace = np.clip(way.speed / _BRISK_M_S, 0.0, 1.15)
    feet = [
        _foot(way, phase, offset, side * _FOOT_GAP * height_m, start, stride_m)
        for offset, side in ((0.0, 1.0), (0.5, -1.0))
    ]
    share = np.stack([(phase + offset) % 1.0 for offset in (0.0, 0.5)], axis=1)
    swing = np.clip((share - _STANCE) / (1 - _STANCE), 0.0, 1.0)
    return Steps(
        foot=np.stack([place for place, _ in feet], axis=1),
        yaw=np.stack([yaw for _, yaw in feet], axis=1),
        lift_m=_LIFT * height_m * np.sin(np.pi * swing) * pace[:, None],
        pitch=np.interp(share, _PITCH_AT, _PITCH_RAD) * pace[:, None],
        phase=phase,
        pace=pace,
    )


class _Way:
    """A walk as a function of the distance walked, going straight on beyond its ends."""

    def __init__(self, walk: PlannedWalk, fps: float) -> None:
        moved = np.diff(walk.position, axis=0, prepend=walk.position[:1])
        turned = np.abs(np.diff(walk.heading, prepend=walk.heading[:1]))
        length = np.linalg.norm(moved, axis=1)
        # Strictly growing, or the way could not be looked up by distance.
        self.distance = np.cumsum(length + _TURN_STEP_M * turned + 1e-7)
        self.speed = gaussian_filter1d((length + _TURN_STEP_M * turned) * fps, 3.0, mode="nearest")
        walking = self.speed[self.speed > 0.3]
        self.usual_speed = float(np.median(walking)) if len(walking) else 1.0
        self._heading = walk.heading
        self._extend(walk.position)

    def _extend(self, position: Floats) -> None:
        beyond = 2.0
        ends = [np.array([np.cos(a), np.sin(a)]) for a in self._heading[[0, -1]]]
        self._at = np.concatenate(
            ([self.distance[0] - beyond], self.distance, [self.distance[-1] + beyond])
        )
        self._position = np.concatenate(
            ([position[0] - beyond * ends[0]], position, [position[-1] + beyond * ends[1]])
        )

    def place(self, distance: Floats) -> tuple[Floats, Floats]:
        """Position (n, 2) and heading (n,) after a distance."""
        x = np.interp(distance, self._at, self._position[:, 0])
        y = np.interp(distance, self._at, self._position[:, 1])
        return np.column_stack((x, y)), np.interp(distance, self.distance, self._heading)


def _foot(
    way: _Way, phase: Floats, offset: float, gap_m: float, start: float, stride_m: float
) -> tuple[Floats, Floats]:
    """Position and yaw of one foot in every frame."""
    own = phase + offset
    step = np.floor(own)
    swing = np.clip((own - step - _STANCE) / (1 - _STANCE), 0.0, 1.0)
    ease = swing**2 * (3 - 2 * swing)
    here, yaw_here = _landing(way, (step + _MIDDLE - offset - start) * stride_m, gap_m)
    there, yaw_there = _landing(way, (step + 1 + _MIDDLE - offset - start) * stride_m, gap_m)
    place = here + (there - here) * ease[:, None]
    return place, yaw_here + (yaw_there - yaw_here) * ease


def _landing(way: _Way, distance: Floats, gap_m: float) -> tuple[Floats, Floats]:
    """Where a foot lands that stands beside the body after a distance."""
    place, heading = way.place(distance)
    sideways = np.column_stack((-np.sin(heading), np.cos(heading)))
    return place + gap_m * sideways, heading
