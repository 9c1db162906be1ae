"""ROS camera_info YAML, one file per camera."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.calibration_file_text import matrix
from tracking.geometry.camera import Camera
from tracking.geometry.stereo_calibration import StereoCalibration

_FISHEYE = "equidistant"
_MODELS = ("plumb_bob", "rational_polynomial", _FISHEYE, "")


def is_ros(values: Mapping[str, Any]) -> bool:
    """Whether these are the values of a camera_info file."""
    return isinstance(values.get("camera_matrix"), Mapping)


def calibration_of_ros(
    files: Sequence[tuple[Path, Mapping[str, Any]]], size: tuple[int, int] | None
) -> StereoCalibration:
    """The calibration of one camera_info, or of the left and the right camera's.

    Each camera's rectification_matrix turns it into common rectified axes, in which the right
    camera stands at -Tx / fx of its projection_matrix. R and T follow from that.
    """
    cameras = [_camera(where, values, size) for where, values in files]
    if len(cameras) == 1:
        return StereoCalibration.of_one(cameras[0])
    (left_where, left), (right_where, right) = files
    left_rotation = _matrix(left, "rectification_matrix", (3, 3), left_where)
    right_rotation = _matrix(right, "rectification_matrix", (3, 3), right_where)
    offsets = [_offset_m(values, where) for where, values in files]
    offset = np.array([offsets[1] - offsets[0], 0.0, 0.0])
    return StereoCalibration(
        cameras[0], cameras[1], right_rotation.T @ left_rotation, right_rotation.T @ offset
    )


def _camera(where: Path, values: Mapping[str, Any], size: tuple[int, int] | None) -> Camera:
    model = values.get("distortion_model", "")
    if model not in _MODELS:
        raise CalibrationError(
            "{where}: distortion model {model} is not known; calibrate with plumb_bob, "
            "rational_polynomial or equidistant",
            where=where,
            model=str(model)[:40],
        )
    distortion = _matrix(values, "distortion_coefficients", None, where).ravel()
    try:
        width, height = size if size and "image_width" not in values else (
            int(values["image_width"]), int(values["image_height"])
        )  # fmt: skip
    except (KeyError, TypeError, ValueError, OverflowError) as error:
        raise CalibrationError(
            "{where}: image_width and image_height are not both whole numbers", where=where
        ) from error
    named = _matrix(values, "camera_matrix", (3, 3), where)
    return Camera(named, distortion, width, height, fisheye=model == _FISHEYE)


def _offset_m(values: Mapping[str, Any], where: Path) -> float:
    projection = _matrix(values, "projection_matrix", (3, 4), where)
    if projection[0, 0] == 0:
        raise CalibrationError("{where}: projection_matrix has no focal length", where=where)
    return float(projection[0, 3] / projection[0, 0])


def _matrix(
    values: Mapping[str, Any], name: str, shape: tuple[int, int] | None, where: Path
) -> Floats:
    parts = values.get(name)
    try:
        if not isinstance(parts, Mapping):
            raise ValueError("missing")
        found = matrix(parts.get("rows"), parts.get("cols"), parts.get("data"))
        if shape is not None and found.shape != shape:
            raise ValueError(f"{found.shape[0]} x {found.shape[1]}")
    except (ValueError, TypeError, OverflowError) as error:
        raise CalibrationError(
            "{where}: {name} is not what camera_info has ({error}); calibrate again",
            where=where,
            name=name,
            error=error,
        ) from error
    return found
