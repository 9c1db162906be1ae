"""A floor as it was found, and how surely."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry import Ground, StereoCalibration, ground_of_plane
from tracking.translation import Message, msg

FloorMethod = Literal["stereo", "points", "board", "pose", "people", "typed"]
_STRAIGHT_DOWN_SIGMAS = 2.0
"""A camera that looks straight down within so many standard deviations is taken to look so: it has
no roll, and the overhead view would be turned by what is noise."""
_LEAST_LEAN_SIGMA_DEG = 0.3
"""Of the direction down: no mounting is truer."""
_ROUGH_FOV_DEG, _ROUGH_DISTANCE = 5.0, 0.05
"""By which a field of view from a data sheet, and a distance from lens to lens that was measured
with a tape (a share of it), may be off in a rough calibration."""
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


def with_calibration(found: FloorEstimate, calibration: StereoCalibration | None) -> FloorEstimate:
    """The same, as unsure as the calibration that it was found with: more where that is rough.

    Heights grow with the focal length, and by stereo with the distance of the cameras. A pose was
    measured otherwise.
    """
    if calibration is None or not calibration.rough or found.method == "pose":
        return found
    camera = calibration.left
    fov_rad = 2.0 * np.arctan2(camera.width / 2.0, camera.matrix[0, 0])
    share = np.deg2rad(_ROUGH_FOV_DEG) / np.sin(fov_rad)
    if found.method == "stereo":
        share = np.hypot(share, _ROUGH_DISTANCE)
    note = msg(
        "the calibration is rough: the height, and every place with it, may be off by {share:.0%}",
        share=float(share),
    )
    sigma_m = float(np.hypot(found.height_sigma_m, share * found.ground.height_m))
    return replace(found, height_sigma_m=sigma_m, notes=(*found.notes, note))


def check_above(height_m: float) -> None:
    """Raise CalibrationError for a camera that would be below the floor or at no height."""
    if not 0.05 <= height_m <= 200.0:
        raise CalibrationError(
            "floor: the camera would be {height:.3g} m above it; check units and points",
            height=height_m,
        )
