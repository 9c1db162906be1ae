"""Kalibr's camchain YAML, and EuRoC's sensor.yaml, one file per camera."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.file_values import camera_of, numbers, pose_of, size_of
from tracking.geometry.stereo_calibration import StereoCalibration

_PINHOLE = "pinhole"


def is_camchain(values: Mapping[str, Any]) -> bool:
    """Whether these are the values of a camchain."""
    first = values.get("cam0")
    return isinstance(first, Mapping) and "intrinsics" in first


def is_euroc(values: Mapping[str, Any]) -> bool:
    """Whether these are the values of a sensor.yaml of a camera."""
    return "T_BS" in values and "intrinsics" in values


def calibration_of_camchain(
    values: Mapping[str, Any], where: Path, size: tuple[int, int] | None
) -> StereoCalibration:
    """Cameras 0 and 1 of a chain; `T_cn_cnm1` of the second takes points from the first."""
    left = _camera(values["cam0"], where, size)
    other = values.get("cam1")
    if not isinstance(other, Mapping):
        return StereoCalibration.of_one(left)
    rotation, shift = pose_of(other, "T_cn_cnm1", where)
    return _pair(left, _camera(other, where, size), rotation, shift)


def calibration_of_euroc(
    files: Sequence[tuple[Path, Mapping[str, Any]]], size: tuple[int, int] | None
) -> StereoCalibration:
    """One camera, or the left and the right one; `T_BS` takes points from each to the body."""
    cameras = [_camera(values, where, size) for where, values in files]
    if len(cameras) == 1:
        return StereoCalibration.of_one(cameras[0])
    (left_turn, left_place), (right_turn, right_place) = (
        pose_of(values, "T_BS", where) for where, values in files
    )
    rotation = right_turn.T @ left_turn
    left, right = cameras
    return _pair(left, right, rotation, right_turn.T @ (left_place - right_place))


def _pair(left: Camera, right: Camera, rotation: Floats, shift: Floats) -> StereoCalibration:
    """The pair, its right camera on the right: either of the two may be the first in a file."""
    if float((rotation.T @ shift)[0]) > 0:  # the second camera stands left of the first
        return StereoCalibration(right, left, rotation.T, -rotation.T @ shift)
    return StereoCalibration(left, right, rotation, shift)


def _camera(values: Mapping[str, Any], where: Path, size: tuple[int, int] | None) -> Camera:
    model = str(values.get("camera_model", _PINHOLE))
    if model != _PINHOLE:
        raise CalibrationError(
            "{where}: camera model {model} is not known; calibrate as a pinhole",
            where=where,
            model=model[:40],
        )
    name = "distortion_coeffs" if "distortion_coeffs" in values else "distortion_coefficients"
    distortion = numbers(values, name, where) if name in values else np.zeros(0)
    return camera_of(
        numbers(values, "intrinsics", where, 4),
        distortion,
        str(values.get("distortion_model") or ""),
        size_of(values, "resolution", where, size),
        where,
    )
