"""The floor from points clicked on it: with places, or with distances between them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from scipy.optimize import least_squares

from tracking.arrays import Floats
from tracking.calibration.floor.estimate import (
    FloorEstimate,
    FloorMethod,
    check_above,
    estimate_of,
)
from tracking.errors import CalibrationError
from tracking.geometry import Camera
from tracking.translation import Message, count_msg, msg

_LEAST_SQUARES: Any = least_squares
"""Its stubs take no plain floats and functions."""
_FEWEST = 4
_CLICK_PX = 1.0
"""A click is no better, however well the points agree."""
_FLATTEST = 0.02
"""Least width of the points on the floor over their length: on a line they leave the tilt open."""
_LARGE_PX = 15.0
"""Points that are off by more are told: a place was mistyped, or the calibration does not fit."""


@dataclass(frozen=True, slots=True)
class FloorPoint:
    """A pixel of the left image as recorded, and where it is on the floor in metres.

    The places' origin and directions are anybody's; only how they lie to each other counts.
    """

    u: float
    v: float
    x_m: float
    y_m: float


def floor_by_points(camera: Camera, points: Sequence[FloorPoint]) -> FloorEstimate:
    """The floor through points whose places are known: pose by PnP, refined by least squares.

    Raises:
        CalibrationError: fewer than four points, points on a line, or no pose sees them so.
    """
    pixels = np.array([(point.u, point.v) for point in points], float).reshape(-1, 2)
    places = np.array([(point.x_m, point.y_m) for point in points], float).reshape(-1, 2)
    return floor_of_places(camera, pixels, places, "points", _CLICK_PX)


def floor_of_places(
    camera: Camera, pixels: Floats, places: Floats, method: FloorMethod, least_px: float
) -> FloorEstimate:
    """The floor through pixels (n, 2) whose places (n, 2) in metres on it are known.

    Args:
        method: how they were found. least_px: they are no surer, however well they agree.

    Raises:
        CalibrationError: fewer than four points, points on a line, or no pose sees them so.
    """
    _check(pixels, places)
    rays = _rays(camera, pixels)
    focal_px = float(camera.matrix[0, 0])
    state = _first_pose(rays, places)

    def misses(state: Floats) -> Floats:
        return (_seen(state, places) - rays).ravel() * focal_px

    found = _LEAST_SQUARES(misses, state)
    up, height_m = _floor_of(found.x)
    check_above(height_m)
    free = max(2 * len(pixels) - 6, 1)
    error_px = max(least_px, float(np.sqrt((found.fun**2).sum() / free)))
    sigmas = _sigmas(found.x, np.linalg.pinv(found.jac.T @ found.jac) * error_px**2)
    return estimate_of(up, height_m, method, *sigmas, _far_off(found.fun.reshape(-1, 2)))


def _far_off(misses: Floats) -> tuple[Message, ...]:
    """What is said where points (n, 2) px are far from where they should be."""
    squares = (misses**2).sum(axis=1)
    rms_px = float(np.sqrt(squares.mean()))
    if rms_px <= _LARGE_PX:
        return ()
    return (
        msg(
            "the points are off by {px:.0f} px, point {number} by most; check its place",
            px=rms_px,
            number=int(squares.argmax()) + 1,
        ),
    )


def floor_by_distances(
    camera: Camera, pixels: Floats, distances: Sequence[tuple[int, int, float]]
) -> FloorEstimate:
    """The floor through points (n, 2) px between which distances are known.

    Args:
        distances: numbers of two points, from 0, and the metres between them; four or more.

    Raises:
        CalibrationError: too few distances, or none of the floors has them.
    """
    pixels = np.asarray(pixels, float).reshape(-1, 2)
    if len(distances) < _FEWEST:
        raise CalibrationError(
            "floor: {count} distances between points; give {fewest} or more, to all sides",
            count=len(distances),
            fewest=_FEWEST,
        )
    one, other = (np.array([pair[side] for pair in distances], int) for side in (0, 1))
    metres = np.array([pair[2] for pair in distances], float)
    if not (np.isfinite(metres).all() and (metres > 0).all()):
        raise CalibrationError("floor: a distance is not above 0 m; check what was typed")
    rays = np.column_stack((_rays(camera, pixels), np.ones(len(pixels))))

    def misses(state: Floats) -> Floats:
        places = _on_plane(rays, state)
        return np.asarray(np.linalg.norm(places[one] - places[other], axis=1) / metres - 1.0)

    starts = [np.array([tilt, 0.0, np.log(3.0)]) for tilt in np.deg2rad((15, 35, 60, 85))]
    found = min((_LEAST_SQUARES(misses, start) for start in starts), key=lambda fit: fit.cost)
    if not np.isfinite(found.cost) or np.sqrt(2 * found.cost / len(metres)) > 0.3:
        raise CalibrationError("floor: no floor has these distances; check points and metres")
    up, height_m = _up_of_state(found.x), float(np.exp(found.x[2]))
    check_above(height_m)
    share = max(float(np.sqrt(2 * found.cost / max(len(metres) - 3, 1))), 0.005)
    spread = np.sqrt(np.diag(np.linalg.pinv(found.jac.T @ found.jac))) * share
    lean_deg = float(np.rad2deg(np.hypot(*spread[:2]) / np.sqrt(2)))
    return estimate_of(up, height_m, "points", float(spread[2] * height_m), lean_deg)


def _check(pixels: Floats, places: Floats) -> None:
    if len(pixels) < _FEWEST:
        raise CalibrationError(
            "floor: {points}; give {fewest} or more that are not on a line",
            points=count_msg(len(pixels), "{n} point", "{n} points"),
            fewest=_FEWEST,
        )
    if not (np.isfinite(pixels).all() and np.isfinite(places).all()):
        raise CalibrationError("floor: a point has no finite pixel or place; check what was typed")
    for table, what in ((pixels, msg("pixels")), (places, msg("places"))):
        spread = np.linalg.svd(table - table.mean(axis=0), compute_uv=False)
        if spread[1] <= _FLATTEST * spread[0]:
            raise CalibrationError(
                "floor: the {what} of the points lie on a line; give one beside it", what=what
            )


def _rays(camera: Camera, pixels: Floats) -> Floats:
    rays = camera.undistort(pixels)
    if not np.isfinite(rays).all():
        raise CalibrationError("floor: a point is outside of what the lens shows; leave it out")
    return rays


def _first_pose(rays: Floats, places: Floats) -> Floats:
    """(6,) rotation vector and translation, camera from floor, of the pose nearest to the rays."""
    # The floor's z is down here, so that (x, y, z) with x right and y towards the camera is
    # right-handed; which of the two sides is up follows from where the camera is.
    world = np.column_stack((places, np.zeros(len(places))))
    best: Floats | None = None
    least = np.inf
    count, turns, shifts, errors = cv2.solvePnPGeneric(
        world[:, None], rays[:, None], np.eye(3), np.zeros(5), flags=cv2.SOLVEPNP_IPPE
    )
    for turn, shift, error in zip(turns, shifts, np.ravel(errors), strict=True):
        if float(shift[2, 0]) > 0 and float(error) < least:
            best, least = np.concatenate((turn.ravel(), shift.ravel())), float(error)
    if not count or best is None:
        raise CalibrationError("floor: no camera sees these points so; check their order")
    return best


def _seen(state: Floats, places: Floats) -> Floats:
    rotation, _ = cv2.Rodrigues(state[:3])
    points = np.column_stack((places, np.zeros(len(places)))) @ rotation.T + state[3:]
    return np.asarray(points[:, :2] / np.where(points[:, 2:] > 1e-6, points[:, 2:], 1e-6))


def _floor_of(state: Floats) -> tuple[Floats, float]:
    """The direction up (3,) in camera axes, and the camera's height."""
    rotation, _ = cv2.Rodrigues(state[:3])
    normal = np.asarray(rotation[:, 2], float)
    height_m = float(-normal @ state[3:])
    return (normal, height_m) if height_m > 0 else (-normal, -height_m)


def _sigmas(state: Floats, covariance: Floats) -> tuple[float, float]:
    """Of the height in m and of the direction up in degrees, by how the pose may differ."""
    up, height_m = _floor_of(state)
    heights, leans = 0.0, 0.0
    values, directions = np.linalg.eigh(covariance)
    for value, direction in zip(np.maximum(values, 0.0), directions.T, strict=True):
        other_up, other_m = _floor_of(state + np.sqrt(value) * direction)
        heights += (other_m - height_m) ** 2
        leans += float(np.arccos(np.clip(up @ other_up, -1.0, 1.0))) ** 2
    return float(np.sqrt(heights)), float(np.rad2deg(np.sqrt(leans / 2)))


def _up_of_state(state: Floats) -> Floats:
    tilt, roll = state[:2]
    return np.array([-np.cos(tilt) * np.sin(roll), -np.cos(tilt) * np.cos(roll), -np.sin(tilt)])


def _on_plane(rays: Floats, state: Floats) -> Floats:
    """(n, 3) m where rays meet the floor; far away where they do not."""
    down = -(rays @ _up_of_state(state))
    return np.asarray(rays * (np.exp(state[2]) / np.where(down > 1e-3, down, 1e-3))[:, None])
