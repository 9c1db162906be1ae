"""The floor by stereo: the plane below everything else, from empty or busy footage."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.calibration.floor.empty_scene import (
    EmptyScene,
    Gray,
    empty_depth,
    empty_scene,
    pixel_grid,
)
from tracking.calibration.floor.estimate import FloorEstimate, check_above, estimate_of
from tracking.errors import CalibrationError
from tracking.geometry import Rectification
from tracking.progress import Progress, no_progress, stage_of
from tracking.recording import Recording
from tracking.translation import Message, msg

_READING, _SEARCHED = 0.7, 0.95
"""Shares of the time when the frames are read, and when the plane is found."""
_RANSAC_ROUNDS = 400
_INLIER_SHARE = 0.0006
"""Of the image's width (half a pixel of 640): what is farther off is not on the plane. A wall or a
pillar is as close at its foot, so that more would tilt the floor."""
_LEAST_SHARE = 0.06
"""Of the pixels with a disparity: a plane of fewer is no floor."""
_BELOW_PX = 2.0
"""A point whose disparity is that much less than the plane's lies below it, and speaks against the
plane as much as one on it speaks for it: errors of matching are few, a table has a floor below."""
_STEEPEST_DEG, _BEYOND_DEG = 70.0, 10.0
"""Roll, and how far a camera may look up, or backward: a wall is no floor."""
_REFINE_ROUNDS = 12
_BAND_PX = (1.5, 10.0)
"""Finest and coarsest pattern that is aligned."""
_APART_PX = 13
"""Width of what is left out around points above the floor."""
_HUBER = 6.0
"""Grey levels, after taking out slow changes of brightness."""
_BLOCKS = 16
"""Of the image's width: each says by itself how far it is off the plane."""
_LEAST_IN_BLOCK, _FEWEST_BLOCKS = 0.3, 8
"""Share of a block that must be floor; blocks that make a plane."""
_LEAST_SEEN = 0.15
"""Share of the image's blocks on the floor below which it is told to be doubtful."""
_TUKEY, _TUKEY_ROUNDS, _LEAST_SCATTER_PX = 4.7, 15, 0.02
"""J. Tukey's bound in deviations; rounds of weighting; a scatter that no footage is below."""
_CALIBRATION_PX = 0.05
"""Disparities of a good calibration err by so much over the image."""


def floor_by_stereo(recording: Recording, progress: Progress = no_progress) -> FloorEstimate:
    """The floor of a recording with two calibrated cameras, or one with depth.

    A plane in the world is one in disparities, too: `d = a u + b v + c`. It is found by RANSAC in
    the median of frames spread over the recording, so that people who move are not in it, as the
    plane with the most points that has hardly any below it; and refined by aligning the images
    over it, brightness by brightness; or, of depth, by the median of each block of it.

    Raises:
        CalibrationError: there are no two calibrated cameras and no depth, or no floor is seen.
        RecordingError: a frame cannot be read.
    """
    calibration = recording.calibration
    if recording.has_depth and recording.rectification is not None:
        return _by_depth(recording, recording.rectification, progress)
    if not recording.is_stereo or calibration is None or calibration.right is None:
        raise CalibrationError(
            "{path}: the floor by stereo needs two calibrated cameras; give their calibration, or "
            "find it by points or people",
            path=recording.path,
        )
    rectification = Rectification(calibration, None)
    views = empty_scene(recording, rectification, stage_of(progress, 0.0, _READING))
    plane = _search(views, rectification, stage_of(progress, _READING, _SEARCHED))
    plane, blocks = _refined(views, plane)
    return _estimate(plane, blocks, rectification)


def _by_depth(
    recording: Recording, rectification: Rectification, progress: Progress
) -> FloorEstimate:
    """The floor in the median of depth, as disparities of the camera's imagined partner."""
    views = empty_depth(recording, rectification, stage_of(progress, 0.0, _READING))
    plane = _search(views, rectification, stage_of(progress, _READING, _SEARCHED))
    blocks = np.zeros((0, 4))
    for _ in range(_REFINE_ROUNDS):
        blocks = _depth_offsets(views, plane)
        if len(blocks) < _FEWEST_BLOCKS:
            raise _nothing_seen()
        plane = plane + _robust_plane(blocks)
    return _estimate(plane, blocks, rectification)


def _depth_offsets(views: EmptyScene, plane: Floats) -> Floats:
    """(k, 4) middle u, v of each block of the floor, by how much it is off (px), and its size."""
    rows, columns = pixel_grid(views.disparity.shape)
    off = views.disparity - (plane[0] * columns + plane[1] * rows + plane[2])
    with np.errstate(invalid="ignore"):
        near = np.abs(off) < _INLIER_SHARE * off.shape[1]
    side = max(off.shape[1] // _BLOCKS, 8)
    found = []
    for top in range(0, off.shape[0], side):
        for begin in range(0, off.shape[1], side):
            part = np.s_[top : top + side, begin : begin + side]
            inside = near[part]
            if inside.mean() >= _LEAST_IN_BLOCK:
                middle = (float(columns[part][inside].mean()), float(rows[part][inside].mean()))
                found.append((*middle, float(np.median(off[part][inside])), float(inside.sum())))
    return np.array(found).reshape(-1, 4)


def _search(views: EmptyScene, rectification: Rectification, progress: Progress) -> Floats:
    """(3,) a, b, c of the floor's disparities."""
    v, u = np.nonzero(np.isfinite(views.disparity))
    if len(u) < 500:
        raise _nothing_seen()
    d = views.disparity[v, u].astype(float)
    points = np.column_stack((u, v, np.ones(len(u)))).astype(float)
    random = np.random.default_rng(0)
    chosen = random.choice(len(u), min(len(u), 20_000), replace=False)
    points, d = points[chosen], d[chosen]
    best, most = None, _LEAST_SHARE * len(d)
    near_px = _INLIER_SHARE * views.left.shape[1]
    for done, rows in enumerate(random.integers(0, len(d), (_RANSAC_ROUNDS, 3))):
        progress(done, _RANSAC_ROUNDS)
        try:
            plane = np.linalg.solve(points[rows], d[rows])
        except np.linalg.LinAlgError:
            continue
        found = _supported(points, d, plane, rectification, (most, near_px))
        if found is not None:
            best, most = found
    if best is None:
        raise _nothing_seen()
    return best


def _supported(
    points: Floats,
    d: Floats,
    plane: Floats,
    rectification: Rectification,
    least: tuple[float, float],
) -> tuple[Floats, float] | None:
    """The plane fitted to its points, and their number; None if it is no floor, or of fewer."""
    most, near_px = least
    if not _may_be_floor(plane, rectification):
        return None
    for _ in range(2):
        off = d - points @ plane
        near = np.abs(off) < near_px
        if near.sum() <= max(most, 3):
            return None
        plane = np.asarray(np.linalg.lstsq(points[near], d[near], rcond=None)[0], np.float64)
    off = d - points @ plane
    near = np.abs(off) < near_px
    # Only where the floor would be seen: above the horizon everything is farther than it.
    seen = points @ plane > rectification.disparity_offset_px + 1.0
    below = ((off < -_BELOW_PX) & seen).sum()
    score = float(near.sum()) - float(below)
    return (plane, score) if score > most and _may_be_floor(plane, rectification) else None


def _may_be_floor(plane: Floats, rectification: Rectification) -> bool:
    up, height_m = _plane_in_camera(plane, rectification)
    if not np.isfinite(height_m) or not 0.2 < height_m < 60.0:
        return False
    tilt, roll = np.arcsin(-up[2]), np.arctan2(-up[0], -up[1])
    limit = np.deg2rad(_STEEPEST_DEG)
    looks_down = tilt > np.deg2rad(60.0)
    # Steep ones may be of any roll, but not upside down: that is a wall before the camera.
    upright = up[1] < np.sin(np.deg2rad(_BEYOND_DEG))
    turned_well = (looks_down and upright) or abs(roll) < limit
    return bool(-np.deg2rad(_BEYOND_DEG) < tilt and turned_well)


def _plane_in_camera(plane: Floats, rectification: Rectification) -> tuple[Floats, float]:
    """The direction up (3,) in the recorded left camera's axes, and its height in metres.

    With `d - offset = f B / Z`, `u = f X / Z + cx`: `a X f + b Y f + (a cx + b cy + c - offset) Z
    = f B`, a plane at the distance f B over the length of its normal.
    """
    a, b, c = plane
    cx, cy = rectification.principal
    focal, offset = rectification.focal_px, rectification.disparity_offset_px
    normal = np.array([a * focal, b * focal, a * cx + b * cy + c - offset])
    length = float(np.linalg.norm(normal))
    if length < 1e-9:
        return np.array([0.0, -1.0, 0.0]), np.inf
    height_m = focal * rectification.baseline_m / length
    return rectification.recorded_axes(-normal / length), height_m


def _refined(views: EmptyScene, plane: Floats) -> tuple[Floats, Floats]:
    """The plane over which the images agree best, and the blocks (k, 4) of it.

    Each block of the image says by how much it is off; the plane goes through what most say, as
    some hold the foot of a wall or of a pillar.
    """
    left, right = (_band(image) for image in (views.left, views.right))
    slope = np.asarray(0.5 * cv2.Sobel(right, cv2.CV_32F, 1, 0, ksize=1), np.float32)
    blocks = np.zeros((0, 4))
    for _ in range(_REFINE_ROUNDS):
        blocks = _block_offsets(views, (left, right, slope), plane)
        if len(blocks) < _FEWEST_BLOCKS:
            raise _nothing_seen()
        step = _robust_plane(blocks)
        plane = plane + step
        if np.abs(step @ (left.shape[1], left.shape[0], 1.0)) < 1e-3:
            break
    return plane, blocks


def _block_offsets(views: EmptyScene, images: tuple[Gray, Gray, Gray], plane: Floats) -> Floats:
    """(k, 4) middle u, v of each block of the floor, its own offset (px), and its weight."""
    left, right, slope = images
    rows, columns = pixel_grid(left.shape)
    mask = _floor_mask(views, plane, rows, columns)
    miss = left - _warped(right, plane, rows, columns)
    along = -_warped(slope, plane, rows, columns)
    side = max(left.shape[1] // _BLOCKS, 8)
    found = []
    for top in range(0, left.shape[0], side):
        for begin in range(0, left.shape[1], side):
            part = np.s_[top : top + side, begin : begin + side]
            inside = mask[part]
            if inside.mean() < _LEAST_IN_BLOCK:
                continue
            error, gradient = miss[part][inside].astype(float), along[part][inside].astype(float)
            weight = np.minimum(1.0, _HUBER / np.maximum(np.abs(error), 1e-6))
            told = float((weight * gradient**2).sum())
            offset = float((weight * gradient * error).sum()) / max(told, 1e-6)
            u, v = columns[part][inside].mean(), rows[part][inside].mean()
            found.append((float(u), float(v), offset, told))
    return np.array(found).reshape(-1, 4)


def _robust_plane(blocks: Floats) -> Floats:
    """(3,) the plane through the offsets of most blocks: Tukey's weights on their own scatter."""
    points = np.column_stack((blocks[:, :2], np.ones(len(blocks))))
    weight = np.ones(len(blocks))
    plane = np.array([0.0, 0.0, float(np.median(blocks[:, 2]))])
    for _ in range(_TUKEY_ROUNDS):
        off = blocks[:, 2] - points @ plane
        scale = max(1.4826 * float(np.median(np.abs(off))), _LEAST_SCATTER_PX)
        weight = np.clip(1.0 - (off / (_TUKEY * scale)) ** 2, 0.0, None) ** 2
        root = np.sqrt(weight)
        plane = np.linalg.lstsq(points * root[:, None], blocks[:, 2] * root, rcond=None)[0]
    return np.asarray(plane)


def _band(image: Gray) -> Gray:
    """The image without slow changes of brightness and without its finest pattern.

    Shifted by parts of a pixel, that would be smoothed by interpolation alone, and draw shifts to
    whole pixels.
    """
    fine, coarse = (cv2.GaussianBlur(image, (0, 0), sigma) for sigma in _BAND_PX)
    return np.asarray(fine - coarse, np.float32)


def _floor_mask(views: EmptyScene, plane: Floats, rows: Gray, columns: Gray) -> NDArray[np.bool_]:
    wanted = plane[0] * columns + plane[1] * rows + plane[2]
    height, width = views.left.shape
    near_px = _INLIER_SHARE * width
    with np.errstate(invalid="ignore"):
        near = np.abs(views.disparity - wanted) < near_px
    source = columns - wanted
    inside = (source > 2) & (source < width - 3) & (rows > 2) & (rows < height - 3)
    # The patterns that are aligned reach a little beyond each pixel: not onto walls and pillars.
    off = (views.disparity - wanted > near_px).astype(np.uint8)
    off = cv2.dilate(cv2.medianBlur(off, 5), np.ones((_APART_PX, _APART_PX), np.uint8))
    return np.asarray(near & inside & (off == 0))


def _warped(image: Gray, plane: Floats, rows: Gray, columns: Gray) -> Gray:
    wanted = (plane[0] * columns + plane[1] * rows + plane[2]).astype(np.float32)
    return np.asarray(cv2.remap(image, columns - wanted, rows, cv2.INTER_CUBIC), np.float32)


def _estimate(plane: Floats, blocks: Floats, rectification: Rectification) -> FloorEstimate:
    """The floor, as sure as its halves agree and a calibration is good."""
    up, height_m = _plane_in_camera(plane, rectification)
    check_above(height_m)
    leans, heights = [], []
    for half in _halves(blocks):
        own_up, own_m = _plane_in_camera(plane + _robust_plane(blocks[half]), rectification)
        leans.append(np.rad2deg(np.arccos(np.clip(up @ own_up, -1.0, 1.0))))
        heights.append(own_m - height_m)
    # A half tells the plane about half as well as the whole.
    lean_deg = float(np.mean(leans)) / 2 if leans else 5.0
    off_m = float(np.mean(np.abs(heights))) / 2 if heights else 0.05 * height_m
    u, v = blocks[:, 0].mean(), blocks[:, 1].mean()
    usual_px = float(plane @ (u, v, 1.0)) - rectification.disparity_offset_px
    share = _CALIBRATION_PX / max(usual_px, 1e-3)
    own_deg = float(np.rad2deg(share * rectification.focal_px / (rectification.size[0] / 4)))
    sigmas = float(np.hypot(off_m, share * height_m)), float(np.hypot(lean_deg, own_deg))
    return estimate_of(up, height_m, "stereo", *sigmas, _notes(len(blocks), rectification.size))


def _notes(count: int, size: tuple[int, int]) -> tuple[Message, ...]:
    """What is odd about a floor that so many blocks of the image are on."""
    side = max(size[0] // _BLOCKS, 8)
    share = count / (-(-size[0] // side) * -(-size[1] // side))
    if share >= _LEAST_SEEN:
        return ()
    note = msg(
        "only {share:.0%} of the image lies on this floor: look at the grid before you trust it",
        share=share,
    )
    return (note,)


def _halves(blocks: Floats) -> list[NDArray[np.bool_]]:
    """The blocks to the left, to the right, above and below, where there are enough."""
    sides = [side for axis in (0, 1) for side in (blocks[:, axis] < np.median(blocks[:, axis]),)]
    both = [half for side in sides for half in (side, ~side)]
    return [half for half in both if half.sum() >= _FEWEST_BLOCKS // 2]


def _nothing_seen() -> CalibrationError:
    return CalibrationError(
        "floor: no plane below everything else is seen by both cameras; it may lack texture or "
        "light, or the calibration does not fit. Give points on it, or type it"
    )
