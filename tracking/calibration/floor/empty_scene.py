"""The scene without the people who move in it: the median of frames over the recording."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Rectification
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.recording.spread_frames import spread_frames

_FRAMES = 15
"""Spread over the recording; their median has nobody in it who keeps moving."""
_DISPARITIES_SHARE = 0.2
"""Widest disparity looked for, of the image's width: nearer things are no floor."""
_BLOCK_PX = 7
_TEXTURE = 4.0
"""Local standard deviation of grey levels below which a disparity is made up."""

Gray = NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class EmptyScene:
    """The empty scene: rectified grey images (h, w), and the disparity with NaN where unknown."""

    left: Gray
    right: Gray
    disparity: Gray


def empty_scene(
    recording: Recording, rectification: Rectification, progress: Progress
) -> EmptyScene:
    """The median of frames spread over a recording, seen by both cameras.

    Raises RecordingError where a frame cannot be read.
    """
    lefts, rights = [], []
    for number in spread_frames(recording.frame_count, _FRAMES, progress):
        frame = recording.read(number, _partner(recording, number))
        assert frame.right is not None, "both cameras are there"
        left, right = rectification.rectify(frame.left, frame.right)
        lefts.append(cv2.cvtColor(left, cv2.COLOR_BGR2GRAY))
        rights.append(cv2.cvtColor(right, cv2.COLOR_BGR2GRAY))
    left, right = (np.median(side, axis=0).astype(np.uint8) for side in (lefts, rights))
    return EmptyScene(left.astype(np.float32), right.astype(np.float32), _disparity(left, right))


def empty_depth(
    recording: Recording, rectification: Rectification, progress: Progress
) -> EmptyScene:
    """The same of depth, as disparities of the camera's imagined partner."""
    seen = []
    for number in spread_frames(recording.frame_count, _FRAMES, progress):
        depth = recording.read(number).depth
        assert depth is not None, "there is depth beside the camera"
        seen.append(np.where(depth > 0, depth, np.inf))
    rows, columns = pixel_grid(seen[0].shape)
    recorded = rectification.recorded_from_rectified(
        np.column_stack((columns.ravel(), rows.ravel())).astype(float)
    )
    u, v = np.nan_to_num(recorded, nan=-9.0).astype(np.float32).T.reshape(2, *rows.shape)
    median = np.median(seen, axis=0).astype(np.float32)
    away = np.asarray(cv2.remap(median, u.copy(), v.copy(), cv2.INTER_NEAREST), np.float32)
    product = rectification.focal_px * rectification.baseline_m
    known = np.isfinite(away) & (away > 0)
    disparity = np.full(rows.shape, np.nan, np.float32)
    disparity[known] = product / away[known] + rectification.disparity_offset_px
    return EmptyScene(disparity, disparity, disparity)


def pixel_grid(shape: tuple[int, ...]) -> tuple[Gray, Gray]:
    """Row and column of each pixel."""
    rows, columns = np.indices(shape[:2])
    return rows.astype(np.float32), columns.astype(np.float32)


def _partner(recording: Recording, number: int) -> int:
    """The right picture of the same instant, where the manifest tells of a lag."""
    partner = number + (recording.right_lag or 0)
    return int(np.clip(partner, 0, recording.frame_count - 1))


def _disparity(left: NDArray[np.uint8], right: NDArray[np.uint8]) -> Gray:
    width = left.shape[1]
    count = max(16, int(width * _DISPARITIES_SHARE) // 16 * 16)
    matcher = cv2.StereoSGBM.create(
        minDisparity=-8,
        numDisparities=count,
        blockSize=_BLOCK_PX,
        P1=8 * _BLOCK_PX**2,
        P2=32 * _BLOCK_PX**2,
        disp12MaxDiff=1,
        uniquenessRatio=10,
        speckleWindowSize=100,
        speckleRange=2,
        mode=cv2.STEREO_SGBM_MODE_HH,
    )
    found = np.asarray(matcher.compute(left, right), np.float32) / 16.0
    mean = cv2.blur(left.astype(np.float32), (_BLOCK_PX, _BLOCK_PX))
    square = cv2.blur(left.astype(np.float32) ** 2, (_BLOCK_PX, _BLOCK_PX))
    textured = square - mean**2 > _TEXTURE**2
    return np.where((found > -8) & textured, found, np.float32(np.nan))
