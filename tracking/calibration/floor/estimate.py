"""A floor as it was found, and how surely."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry import Ground, ground_of_plane
from tracking.translation import Message, msg

FloorMethod = Literal["stereo", "points", "board", "pose", "people", "typed"]
_STRAIGHT_DOWN_SIGMAS = 2.0
"""A camera that looks straight down within so many standard deviations is taken to look so: it has
no roll, and the overhead view would be turned by what is noise."""
_LEAST_LEAN_SIGMA_DEG = 0.3
"""Of the direction down: no mounting is truer."""
_SIDEWAYS_DEG = 60.0
"""A camera that is rolled further is turned, and its pictures should be."""


@dataclass(frozen=True, slots=True)
class FloorEstimate:
    """A floor that was found.

    Attributes:
        ground: height, tilt and roll of the left camera over it. method: how it was found.
        height_sigma_m, tilt_sigma_deg, roll_sigma_deg: standard deviations.
        notes: oddities, in words.
    """

    ground: Ground
    method: FloorMethod
    height_sigma_m: float
    tilt_sigma_deg: float
    roll_sigma_deg: float
    notes: tuple[Message, ...] = ()


def estimate_of(
    up: Floats,
    height_m: float,
    method: FloorMethod,
    height_sigma_m: float,
    lean_sigma_deg: float,
    notes: tuple[Message, ...] = (),
) -> FloorEstimate:
    """The estimate from the floor's plane in the left camera's axes.

    Args:
        up: (3,) unit vector away from the floor. height_m: distance of the camera from it.
        height_sigma_m: standard deviation. lean_sigma_deg: of the direction up, to any side.

    Raises:
        CalibrationError: the camera is not above the floor.
    """
    ground = ground_of_plane(up, float(height_m))
    tilt_deg, roll_deg = ground.tilt_deg, ground.roll_deg
    lean_deg = 90.0 - tilt_deg
    # Near straight down, roll is a compass bearing of the lean: it turns by far more than that.
    across = max(np.cos(np.deg2rad(tilt_deg)), 1e-3)
    found = FloorEstimate(
        ground,
        method,
        float(height_sigma_m),
        float(lean_sigma_deg),
        float(min(lean_sigma_deg / across, 180.0)),
        notes,
    )
    sure_deg = max(lean_sigma_deg, _LEAST_LEAN_SIGMA_DEG)
    if lean_deg < _STRAIGHT_DOWN_SIGMAS * sure_deg:
        note = msg(
            "the camera leans {lean:.1f} degrees from straight down, which is within the error: "
            "it is taken to look straight down",
            lean=lean_deg,
        )
        straight = Ground(float(height_m), 90.0, 0.0)
        return replace(found, ground=straight, notes=(*notes, note))
    if abs(roll_deg) > _SIDEWAYS_DEG:
        note = msg(
            "the camera is rolled by {roll:.0f} degrees: its images may want turning",
            roll=roll_deg,
        )
        return replace(found, notes=(*notes, note))
    return found


def check_above(height_m: float) -> None:
    """Raise CalibrationError for a camera that would be below the floor or at no height."""
    if not 0.05 <= height_m <= 200.0:
        raise CalibrationError(
            "floor: the camera would be {height:.3g} m above it; check units and points",
            height=height_m,
        )
