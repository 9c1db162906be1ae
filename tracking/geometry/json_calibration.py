"""Calibrations in JSON or TOML: OAK's calib.json, MATLAB's stereoParams, and plain K, D, R, t."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.file_values import numbers
from tracking.geometry.stereo_calibration import StereoCalibration

_CM, _MM = 1e-2, 1e-3
_LONGEST_M = 5.0
"""A distance of two cameras that is longer is in millimetres."""
_MATRIX = ("K", "camera_matrix", "matrix", "mtx", "intrinsic", "intrinsics", "M")
_LENS = ("D", "dist_coeffs", "dist", "distortion", "distortion_coefficients", "distCoeffs")
_SIDES = (("left", "right"), ("cam0", "cam1"), ("camera0", "camera1"), ("camera1", "camera2"))
_NUMBERED = ("1", "2")
_TURN, _SHIFT = ("R", "rotation", "rotation_matrix"), ("T", "t", "translation", "tvec")
_SIZE = ("image_size", "size", "resolution", "imageSize", "img_size")


def parsed(text: str) -> Mapping[str, Any] | None:
    """The values of JSON or TOML; None where the text is neither."""
    for read in (json.loads, tomllib.loads):
        try:
            values = read(text)
        except (ValueError, RecursionError):
            continue
        return values if isinstance(values, Mapping) else None
    return None


def calibration_of_json(
    values: Mapping[str, Any], where: Path, size: tuple[int, int] | None
) -> StereoCalibration:
    """The calibration in these values.

    Raises:
        CalibrationError: there is none, or it is incomplete.
    """
    if "cameraData" in values:
        return _of_oak(values, where)
    if "CameraParameters1" in values:
        return _of_matlab(values, where)
    for left, right in _SIDES:
        if isinstance(values.get(left), Mapping):
            other = values.get(right)
            own = _plain_camera(values[left], "", where, _size(values, size, where))
            if not isinstance(other, Mapping):
                return StereoCalibration.of_one(own)
            pair = {**values, **{name: other[name] for name in (*_TURN, *_SHIFT) if name in other}}
            return _pair(
                own, _plain_camera(other, "", where, _size(values, size, where)), pair, where
            )
    shared = _size(values, size, where)
    one, two = _NUMBERED
    if any(name + one in values for name in _MATRIX):
        left_camera = _plain_camera(values, one, where, shared)
        if not any(name + two in values for name in _MATRIX):
            return StereoCalibration.of_one(left_camera)
        return _pair(left_camera, _plain_camera(values, two, where, shared), values, where)
    return StereoCalibration.of_one(_plain_camera(values, "", where, shared))


def _named(values: Mapping[str, Any], names: tuple[str, ...], ending: str = "") -> str | None:
    return next((name + ending for name in names if name + ending in values), None)


def _size(
    values: Mapping[str, Any], size: tuple[int, int] | None, where: Path
) -> tuple[int, int] | None:
    name = _named(values, _SIZE)
    if name is not None:
        width, height = numbers(values, name, where, 2)
        return int(width), int(height)
    if "width" in values and "height" in values:
        return int(numbers(values, "width", where, 1)[0]), int(
            numbers(values, "height", where, 1)[0]
        )
    return size


def _plain_camera(
    values: Mapping[str, Any], ending: str, where: Path, size: tuple[int, int] | None
) -> Camera:
    size = _size(values, size, where)
    if size is None:
        raise CalibrationError(
            "{where}: says no image size; open it with its recording", where=where
        )
    lens = _named(values, _LENS, ending)
    distortion = numbers(values, lens, where) if lens is not None else np.zeros(0)
    name = _named(values, _MATRIX, ending)
    if name is None:
        main = [numbers(values, key, where, 1)[0] for key in ("fx", "fy", "cx", "cy")]
    else:
        held = numbers(values, name, where)
        if held.size not in (4, 9):
            raise CalibrationError(
                "{where}: {name} is no camera matrix of 3 x 3 numbers", where=where, name=name
            )
        main = list(held[[0, 4, 2, 5]] if held.size == 9 else held)
    return _pinhole(np.array(main, float), distortion, size)


def _pinhole(main: Floats, distortion: Floats, size: tuple[int, int]) -> Camera:
    fx, fy, cx, cy = main
    return Camera(np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]]), distortion, *size)


def _pair(left: Camera, right: Camera, values: Mapping[str, Any], where: Path) -> StereoCalibration:
    turn, shift = _named(values, _TURN), _named(values, _SHIFT)
    if turn is None or shift is None:
        raise CalibrationError(
            "{where}: two cameras, but not how they stand: R or T is missing", where=where
        )
    rotation, translation = numbers(values, turn, where, 9), numbers(values, shift, where, 3)
    if np.linalg.norm(translation) > _LONGEST_M:
        translation = translation * _MM
    return StereoCalibration(left, right, rotation.reshape(3, 3), translation)


def _of_oak(values: Mapping[str, Any], where: Path) -> StereoCalibration:
    """The stereo pair of an OAK: sockets by number, extrinsics in centimetres."""
    try:
        cameras = {int(number): data for number, data in values["cameraData"]}
        stereo = values.get("stereoConfigData", {})
        left_number = int(stereo.get("leftCameraSocket", 1))
        right_number = int(stereo.get("rightCameraSocket", 2))
        left, right = cameras[left_number], cameras[right_number]
        first, second = (_oak_camera(data, where) for data in (left, right))
        pose, back = left["extrinsics"], right["extrinsics"]
        if int(pose.get("toCameraSocket", -1)) == right_number:
            turn, shift = _oak_pose(pose, where)
        elif int(back.get("toCameraSocket", -1)) == left_number:
            other, off = _oak_pose(back, where)
            turn, shift = other.T, -other.T @ off
        else:
            raise KeyError("extrinsics")
    except (KeyError, TypeError, ValueError, OverflowError, AttributeError) as error:
        raise CalibrationError(
            "{where}: the pair of cameras is not complete in cameraData; export it again",
            where=where,
        ) from error
    return StereoCalibration(first, second, turn, shift)


def _oak_camera(data: Mapping[str, Any], where: Path) -> Camera:
    size = int(data["width"]), int(data["height"])
    main = numbers(data, "intrinsicMatrix", where, 9)[[0, 4, 2, 5]]
    lens = numbers(data, "distortionCoeff", where)[:14]
    return _pinhole(main, lens if lens.size in (4, 5, 8, 12, 14) else np.zeros(0), size)


def _oak_pose(data: Mapping[str, Any], where: Path) -> tuple[Floats, Floats]:
    place = data["translation"]
    shift = np.array([float(place[axis]) for axis in "xyz"]) * _CM
    return numbers(data, "rotationMatrix", where, 9).reshape(3, 3), shift


def _of_matlab(values: Mapping[str, Any], where: Path) -> StereoCalibration:
    """MATLAB's `toStruct(stereoParams)`: rows times matrices, the first pixel's centre is 1, mm."""
    sides = [values.get(f"CameraParameters{number}") for number in _NUMBERED]
    cameras = [_matlab_camera(side, where) for side in sides if isinstance(side, Mapping)]
    if len(cameras) != len(_NUMBERED):
        raise CalibrationError("{where}: CameraParameters2 is missing", where=where)
    old = "RotationOfCamera2" in values
    if old:
        rotation = numbers(values, "RotationOfCamera2", where, 9).reshape(3, 3).T
        shift = numbers(values, "TranslationOfCamera2", where, 3)
    else:
        pose = values.get("PoseCamera2", {})
        pose = pose if isinstance(pose, Mapping) else {}
        rotation = numbers(pose, "R", where, 9).reshape(3, 3).T
        shift = -rotation @ numbers(pose, "Translation", where, 3)
    return StereoCalibration(cameras[0], cameras[1], rotation, _MM * shift)


def _matlab_camera(values: Mapping[str, Any], where: Path) -> Camera:
    height, width = numbers(values, "ImageSize", where, 2)
    if "IntrinsicMatrix" in values:
        matrix = numbers(values, "IntrinsicMatrix", where, 9).reshape(3, 3).T
    else:
        matrix = numbers(values, "K", where, 9).reshape(3, 3)
    radial = numbers(values, "RadialDistortion", where)
    tangential = numbers(values, "TangentialDistortion", where, 2)
    lens = np.concatenate((radial[:2], tangential, radial[2:3]))
    main = matrix[[0, 1, 0, 1], [0, 1, 2, 2]] - (0.0, 0.0, 1.0, 1.0)
    return _pinhole(main, lens, (int(width), int(height)))
