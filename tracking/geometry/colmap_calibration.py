"""COLMAP's cameras.txt: a line each camera."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.file_values import camera_of
from tracking.geometry.stereo_calibration import StereoCalibration

_LINE = re.compile(r"^\s*\d+\s+([A-Z_]+)\s+(\d+)\s+(\d+)\s+([-+.\deE \t]+)$", re.MULTILINE)
_FIRST_PIXEL = 0.5
"""COLMAP's first pixel reaches from 0 to 1; here its centre is 0."""
_ONE_FOCAL = frozenset(("SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "SIMPLE_RADIAL_FISHEYE"))
_FISHEYES = frozenset(("OPENCV_FISHEYE", "SIMPLE_RADIAL_FISHEYE"))
_COEFFICIENTS = {
    "SIMPLE_PINHOLE": 0,
    "PINHOLE": 0,
    "SIMPLE_RADIAL": 1,
    "RADIAL": 2,
    "OPENCV": 4,
    "FULL_OPENCV": 8,
    "OPENCV_FISHEYE": 4,
    "SIMPLE_RADIAL_FISHEYE": 1,
}


def is_colmap(text: str) -> bool:
    """Whether the text holds COLMAP's cameras."""
    found = _LINE.search(text)
    return found is not None and ("_" in found[1] or found[1] in ("PINHOLE", "RADIAL", "OPENCV"))


def calibration_of_colmap(text: str, where: Path) -> StereoCalibration:
    """The only camera. How several stand to each other is not in this file.

    Raises:
        CalibrationError: there are several, or the model is not known.
    """
    found = _LINE.findall(text)
    if len(found) != 1:
        raise CalibrationError(
            "{where}: holds {count} cameras, and COLMAP's poses have no metres; give a file with "
            "one camera, or a stereo calibration",
            where=where,
            count=len(found),
        )
    model, width, height, parameters = found[0]
    return StereoCalibration.of_one(_camera(model, width, height, parameters, where))


def _camera(model: str, width: str, height: str, parameters: str, where: Path) -> Camera:
    try:
        values = np.array([float(number) for number in parameters.split()])
        size = int(width), int(height)
    except (ValueError, OverflowError) as error:
        raise CalibrationError("{where}: a camera's line has no numbers", where=where) from error
    focals = 1 if model in _ONE_FOCAL else 2
    count = _COEFFICIENTS.get(model)
    if count is None or len(values) != focals + 2 + count:
        raise CalibrationError(
            "{where}: camera model {model} is not known, or has other parameters",
            where=where,
            model=model[:40],
        )
    fx, fy = values[0], values[focals - 1]
    cx, cy = values[focals : focals + 2] - _FIRST_PIXEL
    lens = "equidistant" if model in _FISHEYES else "radtan"
    return camera_of(
        np.array([fx, fy, cx, cy]), _filled(values[focals + 2 :], lens), lens, size, where
    )


def _filled(coefficients: Floats, lens: str) -> Floats:
    """As many as OpenCV has of them."""
    if coefficients.size in (0, 4, 8):
        return coefficients
    filled = np.zeros(4 if lens == "equidistant" else 5)
    filled[: coefficients.size] = coefficients
    return filled
