"""What a fault costs: metres on the floor."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.doctor.faults import Rig
from tracking.doctor.matches import Matches
from tracking.doctor.residuals import disparities

DISTANCE_M = 5.0
"""From the camera's foot point, where costs are told; no cost is more than all of it."""
_STEP_PX = 16
_NEAR_M = 1.0


def floor_cost_m(told: Rig, true: Rig) -> float:
    """Mean distance between where people are and where the files have them, about 5 m away.

    Placed by disparity or by their feet on the floor, whichever is worse. Where the picture shows
    no floor so far away, on the farthest that it shows.
    """
    calibration, ground = true
    if ground is None or told[1] is None or calibration.right is None:
        return 0.0
    pixels, world = _seen_floor(true)
    if not len(pixels):
        return 0.0
    rotation, centre = ground.world_from_camera
    in_left = (world - centre) @ rotation
    right = calibration.right.project(in_left @ calibration.rotation.T + calibration.translation)
    shown = np.isfinite(right).all(axis=1)
    if not shown.any():
        return 0.0
    both_ways = (
        _placed(told, Matches(pixels[shown], right[shown])),
        _on_floor(told, pixels[shown]),
    )
    return max(_mean_error_m(found, world[shown]) for found in both_ways)


def _mean_error_m(found: Floats, true: Floats) -> float:
    error = np.hypot(*(found - true)[:, :2].T)
    # Behind the cameras or at infinity: nobody is there.
    error = np.where(np.isfinite(error), error, DISTANCE_M)
    return float(np.minimum(error, DISTANCE_M).mean())


def _seen_floor(rig: Rig) -> tuple[Floats, Floats]:
    """Left pixels (n, 2) of the floor about 5 m away, and their places (n, 3)."""
    calibration, _ = rig
    width, height = calibration.left.size
    u, v = np.meshgrid(np.arange(0.0, width, _STEP_PX), np.arange(0.0, height, _STEP_PX))
    pixels = np.column_stack((u.ravel(), v.ravel()))
    world = _on_floor(rig, pixels)
    distance = np.hypot(world[:, 0], world[:, 1])
    ok = distance < DISTANCE_M + _NEAR_M
    if not ok.any():
        return pixels[ok], world[ok]
    farthest = min(DISTANCE_M, float(distance[ok].max()))
    ok &= distance > farthest - _NEAR_M
    return pixels[ok], world[ok]


def _placed(rig: Rig, matches: Matches) -> Floats:
    """World points (n, 3) of pairs; NaN where they meet behind the cameras."""
    calibration, ground = rig
    assert ground is not None
    rays, disparity = disparities(calibration, matches)
    depth = calibration.baseline_m / np.where(disparity > 0, disparity, np.nan)
    rotation, centre = ground.world_from_camera
    return rays * depth[:, None] @ rotation.T + centre


def _on_floor(rig: Rig, pixels: Floats) -> Floats:
    """World points (n, 3) of the floor at left pixels (n, 2); NaN above the horizon."""
    calibration, ground = rig
    assert ground is not None
    rays = np.column_stack((calibration.left.undistort(pixels), np.ones(len(pixels))))
    rotation, centre = ground.world_from_camera
    in_world = rays @ rotation.T
    down = np.where(in_world[:, 2] < -1e-6, in_world[:, 2], np.nan)
    return np.asarray(centre - in_world * (centre[2] / down)[:, None])
