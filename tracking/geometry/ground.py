"""Where the floor is, seen from the left camera."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError

_ROTATION_TOLERANCE = 1e-3
_STRAIGHT = 1e-9
"""Of a camera that looks straight down there is no roll."""


@dataclass(frozen=True, slots=True)
class Ground:
    """The camera's place over the floor.

    Attributes:
        height_m: the left camera's centre above the floor.
        tilt_deg: the optical axis below the horizon; 90 is straight down.
        roll_deg: the camera turned about its optical axis, clockwise as it sees the world.

    Raises:
        CalibrationError: the height is not positive, or an angle is out of range.
    """

    height_m: float
    tilt_deg: float
    roll_deg: float = 0.0

    def __post_init__(self) -> None:
        if not (np.isfinite(self.height_m) and self.height_m > 0):
            raise CalibrationError(
                "ground: height is {height_m} m; give the camera's height above the floor",
                height_m=self.height_m,
            )
        if not -90 <= self.tilt_deg <= 90 or not -180 <= self.roll_deg <= 180:
            raise CalibrationError(
                "ground: tilt {tilt_deg} or roll {roll_deg} is out of range; tilt lies in "
                "-90..90 and roll in -180..180 degrees",
                tilt_deg=self.tilt_deg,
                roll_deg=self.roll_deg,
            )

    @property
    def world_from_camera(self) -> tuple[Floats, Floats]:
        """Rotation (3, 3) and translation (3,) from camera axes into the world, in metres.

        World: origin on the floor below the camera, x right, y forward, z up. Looking straight
        down, forward is the direction of the image's upper edge.
        """
        return _world_from_camera(self.height_m, self.tilt_deg, self.roll_deg)


def ground_of_pose(rotation: Floats, translation: Floats) -> Ground:
    """The floor of a pose: x_camera = rotation @ x_world + translation, world z up, metres.

    The world's origin moves to the floor below the camera.

    Raises:
        CalibrationError: the rotation (3, 3) is none, or the camera is not above the floor.
    """
    finite = np.isfinite(rotation).all() and np.isfinite(translation).all()
    if not finite or np.abs(rotation @ rotation.T - np.eye(3)).max() > _ROTATION_TOLERANCE:
        raise CalibrationError("ground: R is not a rotation")
    centre = -rotation.T @ translation
    return ground_of_plane(rotation[:, 2], float(centre[2]))


def ground_of_plane(up: Floats, height_m: float) -> Ground:
    """The floor whose normal (3,), a unit vector in camera axes, points up; see `Ground`."""
    tilt_deg = float(np.rad2deg(np.arcsin(np.clip(-up[2], -1.0, 1.0))))
    level = np.hypot(up[0], up[1])
    roll_deg = float(np.rad2deg(np.arctan2(-up[0], -up[1]))) if level > _STRAIGHT else 0.0
    return Ground(height_m, tilt_deg, roll_deg)


@lru_cache(maxsize=32)
def _world_from_camera(height_m: float, tilt_deg: float, roll_deg: float) -> tuple[Floats, Floats]:
    """Kept, as every trip between pixels and the floor asks for it; not to be written to."""
    tilt, roll = np.deg2rad((tilt_deg, roll_deg))
    right = np.array([1.0, 0.0, 0.0])
    down = np.array([0.0, -np.sin(tilt), -np.cos(tilt)])
    forward = np.array([0.0, np.cos(tilt), -np.sin(tilt)])
    x_axis = right * np.cos(roll) + down * np.sin(roll)
    y_axis = -right * np.sin(roll) + down * np.cos(roll)
    rotation, centre = np.column_stack((x_axis, y_axis, forward)), np.array([0.0, 0.0, height_m])
    rotation.flags.writeable = centre.flags.writeable = False
    return rotation, centre
