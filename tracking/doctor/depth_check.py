"""Check: the floor that depth images show, against [ground]."""

from __future__ import annotations

from tracking.calibration.floor import FloorEstimate, floor_by_stereo
from tracking.doctor.faults import Rig
from tracking.doctor.finding import Finding, Mend
from tracking.doctor.floor_cost import floor_cost_m
from tracking.errors import CalibrationError
from tracking.geometry import depth_pair
from tracking.recording import Recording
from tracking.translation import Message, msg

DEPTH_FLOOR = "depth-floor"
_SURELY = 1.5
"""Standard deviations by which a floor is off before it is told: they allow for errors of a pair's
calibration, which depth cameras hardly have."""
_LEAST_COST_M = 0.05
"""Depth cameras themselves are off by so much at 5 m."""


def check_depth_floor(recording: Recording) -> tuple[Finding | None, Message | None]:
    """The finding where depth shows another floor than the manifest gives, or why it is not known.

    Raises:
        RecordingError: a frame cannot be read.
    """
    if recording.calibration is None:
        return None, msg("needs a calibrated camera")
    if recording.ground is None:
        return None, msg("the recording does not say where the floor is")
    try:
        found = floor_by_stereo(recording)
    except CalibrationError as error:
        return None, error.message
    rig = depth_pair(recording.calibration), recording.ground
    cost = floor_cost_m(rig, (rig[0], found.ground))
    if cost < _LEAST_COST_M or not _is_sure(rig, found):
        return None, None
    return _finding(rig, found, cost), None


def _is_sure(rig: Rig, found: FloorEstimate) -> bool:
    """Whether the floors differ by more than by chance."""
    given = rig[1]
    assert given is not None
    height = abs(found.ground.height_m - given.height_m) / max(found.height_sigma_m, 1e-6)
    tilt = abs(found.ground.tilt_deg - given.tilt_deg) / max(found.tilt_sigma_deg, 1e-6)
    roll = abs(found.ground.roll_deg - given.roll_deg) / max(found.roll_sigma_deg, 1e-6)
    return max(height, tilt, roll) > _SURELY


def _finding(rig: Rig, found: FloorEstimate, cost_m: float) -> Finding:
    given, seen = rig[1], found.ground
    assert given is not None
    return Finding(
        DEPTH_FLOOR,
        msg(
            "by depth the camera is {height:.2f} m above the floor, tilted by {tilt:.1f} and "
            "rolled by {roll:.1f} degrees; recording.toml says otherwise",
            height=seen.height_m,
            tilt=seen.tilt_deg,
            roll=seen.roll_deg,
        ),
        msg("set [ground] to the floor found; check [depth] scale, too"),
        {
            "height_m": seen.height_m,
            "height_told_m": given.height_m,
            "tilt_deg": seen.tilt_deg,
            "tilt_told_deg": given.tilt_deg,
            "roll_deg": seen.roll_deg,
            "roll_told_deg": given.roll_deg,
        },
        cost_m,
        mend=Mend(ground=seen),
    )
