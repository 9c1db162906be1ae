"""OpenCV's calibration files: M1 D1 M2 D2 R T by name."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.stereo_calibration import StereoCalibration

_SINGLE_NAMES = {"camera_matrix": "M1", "distortion_coefficients": "D1"}
"""Names that OpenCV's sample for one camera writes, and ours."""
FISHEYE = "equidistant"
"""The fisheye model under `distortion_model`, as ROS calls it."""


def calibration_of_opencv(
    values: Mapping[str, Any], where: Path, size: tuple[int, int] | None
) -> StereoCalibration:
    """The calibration of one file's values, or of an intrinsics and extrinsics pair's.

    Args:
        values: by name; matrices are 2-D arrays.
        where: the file, for messages.
        size: width and height to take where the file does not say them.
    """
    values = {_SINGLE_NAMES.get(name, name): value for name, value in values.items()}
    size = _size(values, where, size)
    left = _camera(values, "1", where, size)
    rough = str(values.get("rough", "0")) == "1"
    if not {"M2", "D2", "R", "T"} & set(values):
        return StereoCalibration.of_one(left, rough=rough)
    right = _camera(values, "2", where, size)
    return StereoCalibration(
        left, right, _matrix(values, "R", where), _matrix(values, "T", where).ravel(), rough
    )


def _camera(values: Mapping[str, Any], side: str, where: Path, size: tuple[int, int]) -> Camera:
    distortion = _matrix(values, f"D{side}", where) if f"D{side}" in values else np.zeros(0)
    fisheye = values.get("distortion_model") == FISHEYE
    return Camera(_matrix(values, f"M{side}", where), distortion, *size, fisheye=fisheye)


def _matrix(values: Mapping[str, Any], name: str, where: Path) -> Floats:
    value = values.get(name)
    if not isinstance(value, np.ndarray):
        raise CalibrationError(
            "{where}: {name} is missing or no matrix; a calibration needs M1 D1 M2 D2 R T (one "
            "camera: M1 D1)",
            where=where,
            name=name,
        )
    return value


def _size(values: Mapping[str, Any], where: Path, size: tuple[int, int] | None) -> tuple[int, int]:
    if "image_width" not in values and "image_height" not in values:
        if size is not None:
            return size
        raise CalibrationError(
            "{where}: says no image size; add image_width and image_height", where=where
        )
    try:
        return int(values["image_width"]), int(values["image_height"])
    except (KeyError, TypeError, ValueError, OverflowError) as error:
        raise CalibrationError(
            "{where}: image_width and image_height are not both whole numbers", where=where
        ) from error
