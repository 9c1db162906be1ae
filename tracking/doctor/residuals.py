"""How far matched points are from where calibration and floor have them."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.doctor.matches import Matches
from tracking.geometry import Ground, StereoCalibration


def row_residuals(calibration: StereoCalibration, matches: Matches) -> Floats:
    """(n,) px: how far each pair is from one row, after rectification.

    Signed Sampson distance to the epipolar line ([Hartley2004] 11.4.3), so that no rectified image
    is needed and a fault of the calibration never changes the image it is measured in.
    """
    left, right = _rays(calibration, matches)
    direction = calibration.translation / np.linalg.norm(calibration.translation)
    essential = _cross(direction) @ calibration.rotation
    lines_right, lines_left = left @ essential.T, right @ essential
    error = (right * lines_right).sum(axis=1)
    slope = np.sqrt(
        (lines_right[:, :2] ** 2).sum(axis=1) + (lines_left[:, :2] ** 2).sum(axis=1)
    ).clip(1e-12)
    # Of both images' errors, as rows after rectification: sqrt(2) of the Sampson distance.
    return np.asarray(np.sqrt(2) * focal_px(calibration) * error / slope)


def floor_residuals(calibration: StereoCalibration, ground: Ground, matches: Matches) -> Floats:
    """(n,) px: disparity of each pair, less what it would be if the point lay on the floor."""
    assert calibration.right is not None
    left, right = _rays(calibration, matches)
    rotation, centre = ground.world_from_camera
    down = left @ rotation[2]
    reach = -centre[2] / np.where(down < -1e-6, down, np.nan)
    points = left * reach[:, None]
    expected = points @ calibration.rotation.T + calibration.translation
    ahead = np.where(expected[:, 2:] > 1e-6, expected[:, 2:], np.nan)
    along = -calibration.translation / calibration.baseline_m
    shift = (expected / ahead - right) @ (along * (1, 1, 0))
    return np.asarray(focal_px(calibration) * shift)


def disparities(calibration: StereoCalibration, matches: Matches) -> tuple[Floats, Floats]:
    """Left rays (n, 3) with z = 1, and normalised disparity (n,), baseline over depth."""
    left, right = _rays(calibration, matches)
    turned = right @ calibration.rotation  # into the left camera's axes
    along = -calibration.rotation.T @ calibration.translation
    along /= np.linalg.norm(along)
    # depth * left = centre + s * turned; least squares of both scalars, point by point
    a = (left * left).sum(axis=1)
    b = -(left * turned).sum(axis=1)
    c = (turned * turned).sum(axis=1)
    p, q = left @ along, -(turned @ along)
    whole = a * c - b * b
    depth = (c * p - b * q) / np.where(np.abs(whole) > 1e-15, whole, np.nan)
    return left, np.asarray(1.0 / depth)


def focal_px(calibration: StereoCalibration) -> float:
    """Mean focal length of both cameras."""
    assert calibration.right is not None
    matrices = (calibration.left.matrix, calibration.right.matrix)
    return float(np.mean([matrix[[0, 1], [0, 1]].mean() for matrix in matrices]))


def _rays(calibration: StereoCalibration, matches: Matches) -> tuple[Floats, Floats]:
    assert calibration.right is not None
    ones = np.ones(len(matches))
    return (
        np.column_stack((calibration.left.undistort(matches.first), ones)),
        np.column_stack((calibration.right.undistort(matches.second), ones)),
    )


def _cross(vector: Floats) -> Floats:
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
