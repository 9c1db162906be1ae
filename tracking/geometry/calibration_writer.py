"""A calibration into OpenCV's YAML."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracking.arrays import Floats
from tracking.atomic_output import replace_with
from tracking.errors import OutputError
from tracking.geometry.camera import Camera
from tracking.geometry.opencv_calibration import FISHEYE
from tracking.geometry.stereo_calibration import StereoCalibration

_NUMBERS_A_LINE = 4


def write_calibration(path: Path, calibration: StereoCalibration) -> None:
    """Write OpenCV FileStorage YAML with M1 D1 M2 D2 R T, image_width and image_height.

    A fisheye has `distortion_model: equidistant`, as ROS calls it, a rough calibration `rough: 1`.

    The file appears whole or not at all. Numbers read back exactly.

    Raises:
        OutputError: the file cannot be written.
    """
    try:
        replace_with(path, format_calibration(calibration).encode())
    except OutputError as error:
        raise error.advising("choose another folder") from error


def format_calibration(calibration: StereoCalibration) -> str:
    """The text of the file."""
    left, right = calibration.left, calibration.right
    parts = ["%YAML 1.2\n---\n", _matrix("M1", left.matrix), _matrix("D1", _coefficients(left))]
    if right is not None:
        parts += [
            _matrix("M2", right.matrix),
            _matrix("D2", _coefficients(right)),
            _matrix("R", calibration.rotation),
            _matrix("T", calibration.translation[:, None]),
        ]
    parts.append(f"image_width: {left.width}\nimage_height: {left.height}\n")
    if left.fisheye:
        parts.append(f"distortion_model: {FISHEYE}\n")
    if calibration.rough:
        parts.append("rough: 1\n")
    return "".join(parts)


def _coefficients(camera: Camera) -> Floats:
    """Its distortion; zeros where there is none, as OpenCV refuses an empty matrix."""
    return camera.distortion if camera.distortion.size else np.zeros(4 if camera.fisheye else 5)


def _matrix(name: str, values: Floats) -> str:
    table = np.atleast_2d(values)
    numbers = [_number(value) for value in table.ravel()]
    lines = [
        ", ".join(numbers[i : i + _NUMBERS_A_LINE]) for i in range(0, len(numbers), _NUMBERS_A_LINE)
    ]
    return (
        f"{name}: !!opencv-matrix\n   rows: {table.shape[0]}\n   cols: {table.shape[1]}\n"
        f"   dt: d\n   data: [ {(',' + chr(10) + '       ').join(lines)} ]\n"
    )


def _number(value: float) -> str:
    """The shortest text that reads back as the same number, in OpenCV's style."""
    text = repr(float(value))
    return text[:-1] if text.endswith(".0") else text
