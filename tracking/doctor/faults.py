"""Faults of a calibration and its floor, each as one number that can be fitted.

A fault with its number turns what a file says into what would be true; that is its mend, too.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import cv2
import numpy as np

from tracking.arrays import Floats
from tracking.geometry import Camera, Ground, StereoCalibration
from tracking.translation import N_

Rig = tuple[StereoCalibration, Ground | None]


@dataclass(frozen=True, slots=True)
class Fault:
    """One way to be wrong.

    Attributes:
        code, title, fix: see `Finding`; the title is a template with {amount}.
        unit: of the amount that is told. per_unit: it, for one of what is fitted.
        apply: what is true, where the files say this and are wrong by this much.
        needs_floor: rows of both cameras tell nothing of it.
        mendable: the pictures say it all; otherwise something must be measured by a person.
        most: of what is fitted that may be; more of it is another fault.
    """

    code: str
    title: str
    fix: str
    unit: str
    per_unit: float
    apply: Callable[[StereoCalibration, Ground | None, float], Rig]
    needs_floor: bool
    mendable: bool
    most: float


def _turned(axis: int) -> Callable[[StereoCalibration, Ground | None, float], Rig]:
    def apply(rig: StereoCalibration, ground: Ground | None, angle_rad: float) -> Rig:
        vector = np.zeros(3)
        vector[axis] = angle_rad
        turn = np.asarray(cv2.Rodrigues(vector)[0], float)
        return replace(
            rig, rotation=turn @ rig.rotation, translation=turn @ rig.translation
        ), ground

    return apply


def _with_matrix(camera: Camera, change: Floats) -> Camera:
    return Camera(
        camera.matrix * (1 + change[0]) * _IN_IMAGE + camera.matrix * ~_IN_IMAGE + _shift(change),
        camera.distortion, camera.width, camera.height, camera.fisheye,
    )  # fmt: skip


_IN_IMAGE = np.array([[True, True, False], [False, True, False], [False, False, False]])
"""The numbers of a camera matrix that grow with the focal length."""


def _shift(change: Floats) -> Floats:
    shift = np.zeros((3, 3))
    shift[:2, 2] = change[1:]
    return shift


def _right_matrix(*direction: float) -> Callable[[StereoCalibration, Ground | None, float], Rig]:
    def apply(rig: StereoCalibration, ground: Ground | None, amount: float) -> Rig:
        assert rig.right is not None
        return replace(rig, right=_with_matrix(rig.right, amount * np.array(direction))), ground

    return apply


def _focal_of_both(rig: StereoCalibration, ground: Ground | None, share: float) -> Rig:
    assert rig.right is not None
    change = np.array((share, 0.0, 0.0))
    return replace(
        rig, left=_with_matrix(rig.left, change), right=_with_matrix(rig.right, change)
    ), ground


def _height(rig: StereoCalibration, ground: Ground | None, share: float) -> Rig:
    assert ground is not None
    return rig, replace(ground, height_m=ground.height_m * (1 + share))


def _tilt(rig: StereoCalibration, ground: Ground | None, angle_rad: float) -> Rig:
    assert ground is not None
    tilt_deg = ground.tilt_deg + float(np.rad2deg(angle_rad))
    if abs(tilt_deg) <= _STRAIGHT_DEG:
        return rig, replace(ground, tilt_deg=tilt_deg)
    # Past straight down the camera looks the other way, upside down.
    roll_deg = ground.roll_deg - np.copysign(180.0, ground.roll_deg)
    return rig, Ground(ground.height_m, np.copysign(180.0, tilt_deg) - tilt_deg, float(roll_deg))


_STRAIGHT_DEG = 90.0


def _roll(rig: StereoCalibration, ground: Ground | None, angle_rad: float) -> Rig:
    assert ground is not None
    roll_deg = (ground.roll_deg + float(np.rad2deg(angle_rad)) + 180) % 360 - 180
    return rig, replace(ground, roll_deg=roll_deg)


_MOST_TURNED_RAD, _MOST_GROUND_RAD = float(np.deg2rad(5.0)), float(np.deg2rad(20.0))
_MOST_SHIFT_PX = 40.0
_MOST_FOCAL, _MOST_SCALE = 0.12, 0.5
"""Shares. A focal length that is off by more belongs to another lens; heights are guessed."""
_CALIBRATE = N_("calibrate the pair again; until then, mend it from the pictures")
_DEGREES = float(np.rad2deg(1.0))
_PERCENT = 100.0

FAULTS = (
    Fault(
        "ground-tilt", N_("the tilt of the camera is off by {amount:+.2f} degrees"),
        N_("take the floor from the pictures"), N_("degrees"), _DEGREES, _tilt, True, True,
        _MOST_GROUND_RAD,
    ),
    Fault(
        "ground-roll", N_("the roll of the camera is off by {amount:+.2f} degrees"),
        N_("take the floor from the pictures"), N_("degrees"), _DEGREES, _roll, True, True,
        _MOST_GROUND_RAD,
    ),
    Fault(
        "scale", N_("camera height and baseline disagree by {amount:+.2f} %"),
        N_("measure the camera's height and the distance of the cameras; one of them is off"),
        "percent", _PERCENT, _height, True, True, _MOST_SCALE,
    ),
    Fault(
        "right-tilted", N_("the right camera is tilted by {amount:+.2f} degrees"), _CALIBRATE,
        N_("degrees"), _DEGREES, _turned(0), False, True, _MOST_TURNED_RAD,
    ),
    Fault(
        "right-shifted-rows", N_("the right image is shifted by {amount:+.2f} rows"), _CALIBRATE,
        "px", 1.0, _right_matrix(0, 0, 1), False, True, _MOST_SHIFT_PX,
    ),
    Fault(
        "right-turned", N_("the right camera is turned sideways by {amount:+.2f} degrees"),
        _CALIBRATE, N_("degrees"), _DEGREES, _turned(1), False, True, _MOST_TURNED_RAD,
    ),
    Fault(
        "right-rolled", N_("the right camera is rolled by {amount:+.2f} degrees"), _CALIBRATE,
        N_("degrees"), _DEGREES, _turned(2), False, True, _MOST_TURNED_RAD,
    ),
    Fault(
        "focal-both", N_("the focal length is off by {amount:+.2f} %"),
        N_("calibrate the cameras again, with the lens as it is now"),
        "percent", _PERCENT, _focal_of_both, True, False, _MOST_FOCAL,
    ),
    Fault(
        "focal-one", N_("the focal lengths differ by {amount:+.2f} % from what is given"),
        _CALIBRATE, "percent", _PERCENT, _right_matrix(1, 0, 0), False, True, _MOST_FOCAL,
    ),
    Fault(
        "right-shifted-columns", N_("the right image is shifted by {amount:+.2f} columns"),
        _CALIBRATE, "px", 1.0, _right_matrix(0, 1, 0), True, True, _MOST_SHIFT_PX,
    ),
)  # fmt: skip
"""What is wrong most often comes first: of faults that look alike it is the one that is named."""
