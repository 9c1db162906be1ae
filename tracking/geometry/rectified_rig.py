"""The pair of virtual cameras that rectified images belong to."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.geometry.camera import Camera
from tracking.geometry.stereo_calibration import StereoCalibration

_LEAST_ZOOM = 0.6
"""The rectified focal length never falls below this share of the recorded one."""
_EXACT = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class RectifiedRig:
    """Two ideal cameras with equal focal length, rows that agree, and x along the baseline.

    Attributes:
        identity: the recorded images are rectified already.
        left_rotation, right_rotation: (3, 3) rectified axes from each recorded camera's axes.
        focal_px: focal length, in x and y.
        cx_left, cx_right, cy: principal points in px.
        baseline_m: distance between the camera centres.
    """

    identity: bool
    left_rotation: Floats
    right_rotation: Floats
    focal_px: float
    cx_left: float
    cx_right: float
    cy: float
    baseline_m: float


def rectified_rig(calibration: StereoCalibration, right: Camera) -> RectifiedRig:
    """Choose the rectified cameras of a stereo pair.

    Both cameras turn to the mean of their viewing directions, made square to the baseline
    ([Fusiello2000] with Bouguet's shared rotation). The camera matrix is ours: OpenCV's
    stereoRectify may put the principal point off the image. Here the middle of the recorded
    picture stays in the middle, and the middles of its four edges stay inside.
    """
    left = calibration.left
    if _is_rectified(calibration, right):
        cx_left, cx_right = left.matrix[0, 2], right.matrix[0, 2]
        focal, cy, side = left.matrix[0, 0], left.matrix[1, 2], np.eye(3)
        return RectifiedRig(
            True, side, side, float(focal), float(cx_left), float(cx_right), float(cy),
            calibration.baseline_m,
        )  # fmt: skip
    left_rotation = _rectified_axes(calibration)
    right_rotation = left_rotation @ calibration.rotation.T
    focal, cx, cy = _shared_matrix(((left, left_rotation), (right, right_rotation)))
    return RectifiedRig(
        False, left_rotation, right_rotation, focal, cx, cx, cy, calibration.baseline_m
    )


def _is_rectified(calibration: StereoCalibration, right: Camera) -> bool:
    """Equal ideal cameras side by side (principal points may differ along the row)."""
    left = calibration.left
    differing_columns = np.abs(left.matrix - right.matrix)
    differing_columns[0, 2] = 0
    return bool(
        left.lens.is_ideal
        and right.lens.is_ideal
        and np.abs(calibration.rotation - np.eye(3)).max() < _EXACT
        and np.abs(calibration.translation[1:]).max() < _EXACT
        and differing_columns.max() < _EXACT
        and abs(left.matrix[0, 0] - left.matrix[1, 1]) < _EXACT
        and abs(left.matrix[0, 1]) < _EXACT
    )


def _rectified_axes(calibration: StereoCalibration) -> Floats:
    """Rows are the rectified axes in the left camera's axes."""
    to_right = -calibration.rotation.T @ calibration.translation
    x_axis = to_right / np.linalg.norm(to_right)
    forward = np.array([0.0, 0.0, 1.0]) + calibration.rotation[2]
    forward = forward - (forward @ x_axis) * x_axis
    z_axis = forward / np.linalg.norm(forward)
    return np.stack((x_axis, np.cross(z_axis, x_axis), z_axis))


def _shared_matrix(cameras: tuple[tuple[Camera, Floats], ...]) -> tuple[float, float, float]:
    """Focal length and principal point (cx, cy) of both rectified cameras, in px."""
    width, height = cameras[0][0].size
    half = np.array([(width - 1) / 2, (height - 1) / 2])
    middles = np.stack([_turned(camera, rotation, half[None]) for camera, rotation in cameras])
    middle = middles.mean(axis=0)[0]
    edges = half + np.array([[-half[0], 0], [half[0], 0], [0, -half[1]], [0, half[1]]])
    # Only the left camera must stay whole: boxes and floor are measured in it.
    offsets = np.abs(_turned(*cameras[0], edges) - middle)
    wanted = float(np.mean([camera.matrix[[0, 1], [0, 1]].mean() for camera, _ in cameras]))
    fitting = float((half / np.nanmax(offsets, axis=0)).min())
    focal = min(wanted, max(fitting, _LEAST_ZOOM * wanted))
    cx, cy = half - focal * middle
    return focal, float(cx), float(cy)


def _turned(camera: Camera, rotation: Floats, pixels: Floats) -> Floats:
    """Normalised rectified coordinates (n, 2) of recorded pixels (n, 2)."""
    rays = camera.undistort(pixels)
    turned = np.column_stack((rays, np.ones(len(rays)))) @ rotation.T
    return turned[:, :2] / turned[:, 2:]
