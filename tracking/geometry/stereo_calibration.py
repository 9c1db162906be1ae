"""Two cameras and how they stand to each other."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera

_ROTATION_TOLERANCE = 1e-3
_WIDEST_BASELINE_M = 20.0
_USUAL_BASELINE_M = 0.12
"""Of depth whose cameras are not known: that of a ZED; others have 0.05 to 0.1 m."""
_SAME_SHAPE = 0.005
"""By which share the shapes of two resolutions may differ: sides are whole pixels."""


@dataclass(frozen=True, slots=True, eq=False)
class StereoCalibration:
    """A stereo rig, or one calibrated camera.

    Attributes:
        left: the left (or only) camera.
        right: the right camera; None in a monocular rig.
        rotation: (3, 3), x_right = rotation @ x_left + translation.
        translation: (3,) in metres; a right camera on the right has a negative first number.
        rough: estimated from matched points, without a board: metres are rough.

    Raises:
        CalibrationError: the rotation is none, or the cameras do not stand side by side.
    """

    left: Camera
    right: Camera | None
    rotation: Floats
    translation: Floats
    rough: bool = False

    def __post_init__(self) -> None:
        rotation = _checked_rotation(np.array(self.rotation, float))
        translation = np.array(self.translation, float).ravel()
        if translation.shape != (3,) or not np.isfinite(translation).all():
            raise CalibrationError("calibration: T is not three finite numbers")
        object.__setattr__(self, "rotation", rotation)
        object.__setattr__(self, "translation", translation)
        if self.right is not None:
            _check_side_by_side(rotation, translation)

    @classmethod
    def of_one(cls, camera: Camera, *, rough: bool = False) -> StereoCalibration:
        """The calibration of a monocular recording."""
        return cls(camera, None, np.eye(3), np.zeros(3), rough)

    @property
    def baseline_m(self) -> float:
        """Distance between the two camera centres; 0 with one camera."""
        return float(np.linalg.norm(self.translation))

    def scaled_to(self, size: tuple[int, int]) -> StereoCalibration:
        """The same for images of another resolution (width, height) of the same field of view.

        Raises:
            CalibrationError: the images' shape differs: they are cut out, nobody knows where.
        """
        shapes = (self.left.width * size[1], size[0] * self.left.height)
        if abs(shapes[0] - shapes[1]) > _SAME_SHAPE * max(shapes):
            self.check_size(size)
        right = None if self.right is None else self.right.scaled_to(size)
        return replace(self, left=self.left.scaled_to(size), right=right)

    def check_size(self, size: tuple[int, int]) -> None:
        """Raise CalibrationError if images of this size (width, height) do not fit it."""
        for side, camera in (("left", self.left), ("right", self.right)):
            if camera is not None and camera.size != size:
                raise CalibrationError(
                    "calibration: made for {width} x {height} px ({side} camera), the "
                    "recording is {width2} x {height2}; give the calibration of this size",
                    width=camera.width,
                    height=camera.height,
                    side=side,
                    width2=size[0],
                    height2=size[1],
                )


def depth_pair(calibration: StereoCalibration) -> StereoCalibration:
    """The left camera with a partner that would measure its depth as a disparity.

    The partner is the same camera moved along its row, as far as the right camera stands where
    there is one: errors of depth grow with distance as that pair's do.
    """
    left = calibration.left
    aside = calibration.baseline_m if calibration.right is not None else _USUAL_BASELINE_M
    shift = np.array([-aside, 0.0, 0.0])
    return StereoCalibration(left, left, np.eye(3), shift, calibration.rough)


def _checked_rotation(rotation: Floats) -> Floats:
    """The rotation, made exactly orthonormal where rounding in a file left it nearly so."""
    if rotation.shape != (3, 3) or not np.isfinite(rotation).all():
        raise CalibrationError("calibration: R is not 3 x 3 finite numbers")
    error = np.abs(rotation @ rotation.T - np.eye(3)).max()
    if error > _ROTATION_TOLERANCE or np.linalg.det(rotation) < 0:
        raise CalibrationError("calibration: R is not a rotation; calibrate the stereo pair again")
    if error < 1e-12:
        return rotation
    u, _, vt = np.linalg.svd(rotation)
    return np.asarray(u @ vt, float)


def _check_side_by_side(rotation: Floats, translation: Floats) -> None:
    centre = -rotation.T @ translation
    if not 1e-4 < np.linalg.norm(centre) < _WIDEST_BASELINE_M:
        raise CalibrationError(
            "calibration: the cameras stand {distance:g} m apart; lengths (T) are in metres",
            distance=np.linalg.norm(centre),
        )
    if centre[0] < abs(centre[1]) or centre[0] < abs(centre[2]):
        raise CalibrationError(
            "calibration: the right camera does not stand right of the left one; "
            "swap the cameras or calibrate them side by side"
        )
