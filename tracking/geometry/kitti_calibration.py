"""KITTI's calibration text: projection matrices of rectified cameras."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.stereo_calibration import StereoCalibration

_LINE = re.compile(r"^P(?:_rect_)?0?([0-3]):(.*)$", re.MULTILINE)
_SIZE = re.compile(r"^S_rect_0?2:\s*(\S+)\s+(\S+)\s*$", re.MULTILINE)


def is_kitti(text: str) -> bool:
    """Whether the text holds KITTI's projection matrices."""
    return _LINE.search(text) is not None


def calibration_of_kitti(text: str, where: Path, size: tuple[int, int] | None) -> StereoCalibration:
    """The colour cameras 2 and 3, or the grey ones 0 and 1 where only those are given.

    KITTI's images are rectified: of the offset between the cameras only the part along the rows
    is real, the rest is what its calibration left over.
    """
    projections = {int(number): _projection(row, where) for number, row in _LINE.findall(text)}
    first, second = (2, 3) if 2 in projections else (0, 1)
    if first not in projections:
        raise CalibrationError(
            "{where}: neither P2 nor P0 is given; give KITTI's calib.txt", where=where
        )
    size = _size(text, where) or size
    if size is None:
        raise CalibrationError(
            "{where}: says no image size; open it with its recording", where=where
        )
    left = projections[first]
    camera = Camera(left[:, :3], np.zeros(0), *size)
    if second not in projections:
        return StereoCalibration.of_one(camera)
    right = projections[second]
    translation = np.array([right[0, 3] / right[0, 0] - left[0, 3] / left[0, 0], 0.0, 0.0])
    return StereoCalibration(
        camera, Camera(right[:, :3], np.zeros(0), *size), np.eye(3), translation
    )


def _projection(row: str, where: Path) -> Floats:
    try:
        projection = np.array([float(number) for number in row.split()]).reshape(3, 4)
    except ValueError as error:
        raise CalibrationError("{where}: a projection is not 12 numbers", where=where) from error
    if not np.isfinite(projection).all() or projection[0, 0] == 0:
        raise CalibrationError("{where}: a projection is not 12 finite numbers", where=where)
    return projection


def _size(text: str, where: Path) -> tuple[int, int] | None:
    found = _SIZE.search(text)
    if found is None:
        return None
    try:
        return int(float(found[1])), int(float(found[2]))
    except (ValueError, OverflowError) as error:
        raise CalibrationError("{where}: S_rect_02 is not a size in pixels", where=where) from error
