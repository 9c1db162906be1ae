"""Check: the floor that depth images, or both cameras, show, against [ground]."""

from __future__ import annotations

import numpy as np

from tracking.calibration.floor import FloorEstimate, floor_by_stereo
from tracking.doctor.faults import Rig
from tracking.doctor.findings import Finding, Mend
from tracking.doctor.floor_cost import floor_cost_m
from tracking.errors import CalibrationError
from tracking.geometry import Ground, depth_pair
from tracking.progress import Progress, no_progress
from tracking.recording import Recording
from tracking.translation import Message, msg

DEPTH_FLOOR, OTHER_FLOOR = "depth-floor", "other-floor"
_SURELY = 1.5
"""Standard deviations by which a floor is off before it is told: they allow for errors of a pair's
calibration, which depth cameras hardly have."""
_SAME_WAY_DEG = 15.0
"""A floor is in other units where its direction agrees so far; what leans more is a wall or so."""
_LEAST_COST_M = 0.05
"""Depth cameras themselves are off by so much at 5 m."""


def check_depth_floor(
    recording: Recording, tell: Progress = no_progress
) -> tuple[Finding | None, Message | None]:
    """The finding where depth shows another floor than the manifest gives, or why it is not known.

    Raises:
        RecordingError: a frame cannot be read.
    """
    if recording.calibration is None:
        return None, msg("needs a calibrated camera")
    if recording.ground is None:
        return None, msg("the recording does not say where the floor is")
    try:
        found = floor_by_stereo(recording, tell)
    except CalibrationError as error:
        return None, error.message
    rig = depth_pair(recording.calibration), recording.ground
    cost = floor_cost_m(rig, (rig[0], found.ground))
    if cost < _LEAST_COST_M or not _is_sure(rig, found):
        return None, None
    said = msg(
        "by depth the camera is {height:.2f} m above the floor, tilted by {tilt:.1f} and "
        "rolled by {roll:.1f} degrees; recording.toml says otherwise",
        **_angles(found.ground),
    )
    fix = msg("set [ground] to the floor found; check [depth] scale, too")
    return _finding(DEPTH_FLOOR, said, fix, rig, found, cost), None


def check_other_floor(
    recording: Recording, tell: Progress = no_progress
) -> tuple[Finding | None, Message | None]:
    """The finding of two cameras that see no floor like the given one, or why it is not known.

    Raises:
        RecordingError: a frame cannot be read.
    """
    assert recording.calibration is not None, "two calibrated cameras"
    try:
        found = floor_by_stereo(recording, tell)
    except CalibrationError as error:
        return None, error.message
    rig = recording.calibration, recording.ground
    cost = floor_cost_m(rig, (rig[0], found.ground))
    if cost < _LEAST_COST_M or not _may_be_given(rig, found):
        return None, msg("too few points are seen on the floor")
    said = msg(
        "by both cameras the left one is {height:.2f} m above the floor, tilted by {tilt:.1f} "
        "and rolled by {roll:.1f} degrees; recording.toml says {told:.2f} m and {told_tilt:.1f} "
        "degrees",
        **_angles(found.ground),
        told=rig[1].height_m if rig[1] else 0.0,
        told_tilt=rig[1].tilt_deg if rig[1] else 0.0,
    )
    fix = msg("measure the camera's height and the distance of the cameras, in metres")
    return _finding(OTHER_FLOOR, said, fix, rig, found, cost), None


def _angles(ground: Ground) -> dict[str, float]:
    return {"height": ground.height_m, "tilt": ground.tilt_deg, "roll": ground.roll_deg}


def _is_sure(rig: Rig, found: FloorEstimate) -> bool:
    """Whether the floors differ by more than by chance."""
    given = rig[1]
    assert given is not None
    height = abs(found.ground.height_m - given.height_m) / max(found.height_sigma_m, 1e-6)
    tilt = abs(found.ground.tilt_deg - given.tilt_deg) / max(found.tilt_sigma_deg, 1e-6)
    roll = abs(found.ground.roll_deg - given.roll_deg) / max(found.roll_sigma_deg, 1e-6)
    return max(height, tilt, roll) > _SURELY


def _may_be_given(rig: Rig, found: FloorEstimate) -> bool:
    """Whether the floor found can be the one given, at another height, and is seen well."""
    assert rig[1] is not None
    ups = (ground.world_from_camera[0][2] for ground in (rig[1], found.ground))
    apart_deg = float(np.rad2deg(np.arccos(np.clip(np.dot(*ups), -1.0, 1.0))))
    return apart_deg < _SAME_WAY_DEG and not found.notes and _is_sure(rig, found)


def _finding(
    code: str, said: Message, fix: Message, rig: Rig, found: FloorEstimate, cost_m: float
) -> Finding:
    given, seen = rig[1], found.ground
    assert given is not None
    figures = {
        "height_m": seen.height_m,
        "height_told_m": given.height_m,
        "tilt_deg": seen.tilt_deg,
        "tilt_told_deg": given.tilt_deg,
        "roll_deg": seen.roll_deg,
        "roll_told_deg": given.roll_deg,
    }
    return Finding(code, said, fix, figures, cost_m, mend=Mend(ground=seen))
