"""Calibration files told apart by what they hold."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tracking.errors import CalibrationError
from tracking.geometry.calibration_file_text import parse_xml, parse_yaml, read_text
from tracking.geometry.kitti_calibration import calibration_of_kitti, is_kitti
from tracking.geometry.opencv_calibration import calibration_of_opencv
from tracking.geometry.ros_calibration import calibration_of_ros, is_ros
from tracking.geometry.stereo_calibration import StereoCalibration


def read_calibration(
    paths: Sequence[Path], size: tuple[int, int] | None = None
) -> StereoCalibration:
    """The calibration in one file, or in a pair of files.

    Known are OpenCV FileStorage YAML and XML (one file, or intrinsics and extrinsics), KITTI's
    calib.txt and ROS camera_info YAML (left, right). Lengths are metres. Nothing in the files is
    trusted: sizes, depth and numbers are capped and checked.

    Args:
        paths: one or two files.
        size: width and height in px of the recording, for files that do not say them.

    Raises:
        CalibrationError: unreadable, incomplete or not a possible calibration.
    """
    if not 1 <= len(paths) <= 2:
        raise CalibrationError(
            "calibration: {count} files given; give one, or a pair", count=len(paths)
        )
    texts = [read_text(path) for path in paths]
    try:
        if is_kitti(texts[0]):
            return calibration_of_kitti(texts[0], paths[0], size)
        files = [(path, _values(path, text)) for path, text in zip(paths, texts, strict=True)]
        if all(is_ros(values) for _, values in files):
            return calibration_of_ros(files, size)
        merged = {name: value for _, values in files for name, value in values.items()}
        return calibration_of_opencv(merged, paths[0], size)
    except CalibrationError as error:
        if error.reason.values.keys() & {"path", "where"}:  # it names the file
            raise
        raise CalibrationError("{path}: {error}", path=paths[0], error=error) from error


def _values(path: Path, text: str) -> dict[str, Any]:
    if text.lstrip()[:1] == "<":
        return parse_xml(text, path)
    return parse_yaml(text, path)


def calibration_text(paths: Sequence[Path]) -> str:
    """The text of calibration files, one after the other, to be kept beside what used them."""
    return "\n".join(read_text(path) for path in paths)
