"""A rough calibration of a pair from what it films: no board, no file."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry import Camera, StereoCalibration
from tracking.progress import Progress, no_progress
from tracking.recording.frame import Image
from tracking.recording.places import open_pictures
from tracking.recording.spread_frames import spread_frames

_CV: Any = cv2
"""The stubs lack parts of OpenCV 5."""
_FRAMES = 12
"""Instants that points are matched at, evenly over the footage: those of one lie in few places."""
_POINTS = 2000
_RATIO = 0.75
"""D. Lowe's: a match must be so much nearer than the next best one."""
_RANSAC_PX = 1.5
_FEWEST = 60
"""Matched points on which the two views agree, over all instants."""
_LEAST_SHARE = 0.3
_FEWEST_TO_LOOK = 16
"""Of matches for a first look at how two cameras stand."""
_USUAL_FOV_DEG = 65.0
_NARROWEST_DEG, _WIDEST_DEG = 5.0, 150.0
_LEVEL_PX, _PARALLEL_ROUNDS = 25.0, 2
"""Rows of a point in two cameras side by side differ by the same but for so much."""
_AS_GOOD = 0.98
"""Of the points that agree on the best pose, those that must on that of cameras side by side."""
_LOSS_PX = 0.5
"""Errors of matched points beyond which they count less."""


@dataclass(frozen=True, slots=True)
class RoughRequest:
    """What is known of a pair.

    Attributes:
        left, right: videos, image folders or patterns. fov_deg: horizontal field of view.
        baseline_m: distance of the cameras.
    """

    left: str
    right: str
    fov_deg: float
    baseline_m: float


@dataclass(frozen=True, slots=True, eq=False)
class RoughCalibration:
    """A pair as matched points say.

    Attributes:
        calibration: marked as rough. matches: points matched; inlier_share: of these, on which the
            two views agree. row_error_px: mean distance of matched points from their epipolar line.
        fov_deg: as asked.
    """

    calibration: StereoCalibration
    matches: int
    inlier_share: float
    row_error_px: float
    fov_deg: float


def calibrate_roughly(request: RoughRequest, progress: Progress = no_progress) -> RoughCalibration:
    """The pose of the right camera from points matched in several instants.

    Both cameras are taken to be alike and without distortion, the principal point in the middle.
    Pose by the essential matrix (five points, RANSAC), refined over all agreeing points; or refined
    from cameras side by side, where as many agree on that: a flat floor alone leaves it open.

    Raises:
        RecordingError: images cannot be read.
        CalibrationError: the two do not show the same place, or not side by side.
    """
    _check(request.fov_deg, request.baseline_m)
    points, size = _matched(request, progress)
    return _of_points(MatchedViews(points, size), request.fov_deg, request.baseline_m)


def calibrate_images_roughly(
    views: Sequence[tuple[Image, Image]],
    fov_deg: float,
    baseline_m: float,
    progress: Progress = no_progress,
) -> RoughCalibration:
    """The same as `calibrate_roughly`, from images (left, right) of several instants.

    Raises:
        CalibrationError: the two do not show the same place, or not side by side.
    """
    _check(fov_deg, baseline_m)
    found = []
    for done, view in enumerate(views):
        found.append(_matches(*view))
        progress(done + 1, len(views))
    height, width = views[0][0].shape[:2]
    points = MatchedViews(np.concatenate(found), (width, height))
    return _of_points(points, fov_deg, baseline_m)


def calibrate_one_roughly(size: tuple[int, int], fov_deg: float) -> StereoCalibration:
    """One camera of images of this size (width, height); see :func:`rough_camera`.

    Raises:
        CalibrationError: no camera has such a field of view.
    """
    return StereoCalibration.of_one(rough_camera(size, fov_deg), rough=True)


def rough_camera(size: tuple[int, int], fov_deg: float) -> Camera:
    """A camera of this horizontal field of view, without distortion.

    Args:
        size: width and height in px.

    Raises:
        CalibrationError: no camera has such a field of view.
    """
    _check(fov_deg, 1.0)
    focal_px = 0.5 * size[0] / np.tan(np.deg2rad(fov_deg) / 2)
    matrix = np.array(
        [[focal_px, 0, (size[0] - 1) / 2], [0, focal_px, (size[1] - 1) / 2], [0, 0, 1]]
    )
    return Camera(matrix, np.zeros(5), *size)


def _of_points(views: MatchedViews, fov_deg: float, baseline_m: float) -> RoughCalibration:
    camera = rough_camera(views.size, fov_deg)
    focal_px = float(camera.matrix[0, 0])
    rays = (views.points - camera.matrix[:2, 2]) / focal_px
    rotation, direction, agreeing = _pose(rays, focal_px)
    share = float(agreeing.mean())
    if agreeing.sum() < _FEWEST or share < _LEAST_SHARE:
        raise CalibrationError(
            "calibration: the two cameras agree on {count} of {all} matched points; do they show "
            "the same place? A board is surer",
            count=int(agreeing.sum()),
            all=len(rays),
        )
    rotation, direction = _refined(rays[agreeing], rotation, direction, focal_px)
    parallel = _refined_from_parallel(rays, focal_px)
    # A flat scene leaves the pose open: of two that explain it, cameras were put up side by side.
    if parallel is not None:
        level = _agreeing(rays, *parallel, focal_px)
        if level.sum() >= _AS_GOOD * _agreeing(rays, rotation, direction, focal_px).sum():
            (rotation, direction), agreeing = parallel, level
            share = float(agreeing.mean())
            if _are_swapped(rays[agreeing], rotation):
                direction = -direction
    if direction[0] > 0 and abs(direction[0]) > max(abs(direction[1]), abs(direction[2])):
        raise CalibrationError("calibration: the right camera stands left; swap left and right")
    calibration = StereoCalibration(camera, camera, rotation, direction * baseline_m, rough=True)
    error_px = float(np.abs(_misses(rays[agreeing], rotation, direction) * focal_px).mean())
    return RoughCalibration(calibration, len(rays), share, error_px, fov_deg)


@dataclass(frozen=True, slots=True, eq=False)
class MatchedViews:
    """Points (n, 2, 2) px in images of two cameras, and the images' width and height."""

    points: Floats
    size: tuple[int, int]


@dataclass(frozen=True, slots=True, eq=False)
class RelativePose:
    """How the second camera stands to the first, by matched points.

    Attributes:
        direction: (3,) unit vector, x_second = rotation @ x_first + direction times some length: a
            second camera on the right has a negative first number. agreeing: points that agree.
        roll_deg: by which the second camera is turned about its axis.
        shift_px: (2,) by which points are farther right, farther down in the first image: usual
            ones of those that agree. row_scatter_px: of the second number.
    """

    direction: Floats
    agreeing: int
    roll_deg: float
    shift_px: Floats
    row_scatter_px: float


def match_images(views: Sequence[tuple[Image, Image]]) -> MatchedViews:
    """Points matched between the images of each pair; all of one size."""
    points = np.concatenate([_matches(one, other) for one, other in views])
    height, width = views[0][0].shape[:2]
    return MatchedViews(points, (width, height))


def pose_of_matches(views: MatchedViews) -> RelativePose | None:
    """The pose on which most points agree, for cameras of a usual field of view; None: too few."""
    focal_px = 0.5 * views.size[0] / np.tan(np.deg2rad(_USUAL_FOV_DEG) / 2)
    rays = (views.points - (np.array(views.size) - 1) / 2) / focal_px
    if len(rays) < _FEWEST_TO_LOOK:
        return None
    rotation, direction, agreeing = _pose(rays, focal_px, _FEWEST_TO_LOOK)
    roll_deg = float(np.rad2deg(np.arctan2(rotation[1, 0], rotation[0, 0])))
    shift = (views.points[:, 0] - views.points[:, 1])[agreeing]
    usual = np.median(shift, axis=0) if len(shift) else np.zeros(2)
    scatter = float(np.median(np.abs(shift[:, 1] - usual[1]))) if len(shift) else np.inf
    return RelativePose(direction, int(agreeing.sum()), roll_deg, usual, scatter)


def _check(fov_deg: float, baseline_m: float) -> None:
    if not _NARROWEST_DEG <= fov_deg <= _WIDEST_DEG:
        raise CalibrationError(
            "calibration: a field of view of {fov:g} degrees; give {low:g} to {high:g}",
            option="--fov",
            fov=fov_deg,
            low=_NARROWEST_DEG,
            high=_WIDEST_DEG,
        )
    if not 1e-3 <= baseline_m <= 20.0:
        raise CalibrationError(
            "calibration: cameras {baseline:g} m apart; give their distance in metres",
            option="--baseline",
            baseline=baseline_m,
        )


def _matched(request: RoughRequest, progress: Progress) -> tuple[Floats, tuple[int, int]]:
    """(n, 2, 2) px of points in the left and the right image, and the images' size."""
    left, right = (open_pictures(Path(name), name) for name in (request.left, request.right))
    try:
        if left.size != right.size:
            raise CalibrationError(
                "calibration: the two cameras' images differ in size; give a pair of one size"
            )
        count = min(left.frame_count, right.frame_count)
        found = [
            _matches(*(side.read(number) for side in (left, right)))
            for number in spread_frames(count, _FRAMES, progress)
        ]
    finally:
        left.close()
        right.close()
    return np.concatenate(found), left.size


def _matches(left: NDArray[np.uint8], right: NDArray[np.uint8]) -> Floats:
    finder: Any = _CV.SIFT_create(_POINTS)
    (one, of_left), (other, of_right) = (
        finder.detectAndCompute(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), None)
        for image in (left, right)
    )
    if of_left is None or of_right is None or len(other) < 2:
        return np.zeros((0, 2, 2))
    nearest = cv2.BFMatcher().knnMatch(of_left, of_right, 2)
    pairs = [
        (one[best.queryIdx].pt, other[best.trainIdx].pt)
        for best, next_best in _both(nearest)
        if best.distance < _RATIO * next_best.distance
    ]
    return np.array(pairs, float).reshape(-1, 2, 2)


def _both(nearest: Any) -> Iterator[tuple[cv2.DMatch, cv2.DMatch]]:
    for found in nearest:
        if len(found) == 2:
            yield found[0], found[1]


def _pose(
    rays: Floats, focal_px: float, fewest: int = _FEWEST
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Rotation (3, 3), direction (3,) and which points (n,) agree with them."""
    if len(rays) < fewest:
        return np.eye(3), np.array([-1.0, 0, 0]), np.zeros(len(rays), bool)
    left, right = rays[:, 0].copy(), rays[:, 1].copy()
    cv2.setRNGSeed(0)
    essential, mask = cv2.findEssentialMat(
        left, right, np.eye(3), cv2.RANSAC, 0.999, _RANSAC_PX / focal_px
    )
    if essential is None or essential.shape != (3, 3):
        return np.eye(3), np.array([-1.0, 0, 0]), np.zeros(len(rays), bool)
    agreeing = mask.ravel() > 0
    _, rotation, direction, _ = _CV.recoverPose(
        essential, left[agreeing], right[agreeing], np.eye(3)
    )
    return rotation, direction.ravel(), agreeing


def _refined(
    rays: Floats, rotation: Floats, direction: Floats, focal_px: float
) -> tuple[Floats, Floats]:
    """The pose with the least distances of points from their epipolar lines."""

    def parts(state: Floats) -> tuple[Floats, Floats]:
        turn, _ = cv2.Rodrigues(state[:3])
        shift = direction + state[3:]
        return np.asarray(turn @ rotation), np.asarray(shift / np.linalg.norm(shift))

    def misses(state: Floats) -> Floats:
        return focal_px * _misses(rays, *parts(state))

    found = least_squares(misses, np.zeros(6), loss="soft_l1", f_scale=_LOSS_PX)
    return parts(found.x)


def _refined_from_parallel(rays: Floats, focal_px: float) -> tuple[Floats, Floats] | None:
    """The pose nearest to two cameras side by side that look the same way; None: too few points."""
    down = rays[:, 0, 1] - rays[:, 1, 1]
    near = np.abs(down - np.median(down)) * focal_px < _LEVEL_PX
    pose: tuple[Floats, Floats] = (np.eye(3), np.array([-1.0, 0.0, 0.0]))
    for _ in range(_PARALLEL_ROUNDS):
        if near.sum() < _FEWEST:
            return None
        pose = _refined(rays[near], *pose, focal_px)
        near = _agreeing(rays, *pose, focal_px)
    return pose


def _agreeing(
    rays: Floats, rotation: Floats, direction: Floats, focal_px: float
) -> NDArray[np.bool_]:
    """(n,) points near their epipolar lines."""
    return np.asarray(np.abs(_misses(rays, rotation, direction)) * focal_px < _RANSAC_PX)


def _are_swapped(rays: Floats, rotation: Floats) -> bool:
    """Whether most points lie farther left in the left camera, once both look the same way."""
    right = np.column_stack((rays[:, 1], np.ones(len(rays)))) @ rotation
    return bool(np.median(rays[:, 0, 0] - right[:, 0] / right[:, 2]) < 0)


def _misses(rays: Floats, rotation: Floats, direction: Floats) -> Floats:
    """(n,) Sampson distances, in the unit of rays (n, 2, 2)."""
    x, y, z = direction
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    essential = cross @ rotation
    left, right = (np.column_stack((rays[:, side], np.ones(len(rays)))) for side in (0, 1))
    lines, back = left @ essential.T, right @ essential
    norm = np.sqrt((lines[:, :2] ** 2).sum(axis=1) + (back[:, :2] ** 2).sum(axis=1))
    return np.asarray((right * lines).sum(axis=1) / np.maximum(norm, 1e-12))
