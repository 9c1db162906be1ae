"""Calibration files told apart by what they hold."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from tracking.errors import CalibrationError
from tracking.geometry.calibration_file_text import parse_xml, parse_yaml, read_text
from tracking.geometry.colmap_calibration import calibration_of_colmap, is_colmap
from tracking.geometry.json_calibration import calibration_of_json, parsed
from tracking.geometry.kalibr_calibration import (
    calibration_of_camchain,
    calibration_of_euroc,
    is_camchain,
    is_euroc,
)
from tracking.geometry.kitti_calibration import calibration_of_kitti, is_kitti
from tracking.geometry.opencv_calibration import calibration_of_opencv
from tracking.geometry.ros_calibration import calibration_of_ros, is_ros
from tracking.geometry.stereo_calibration import StereoCalibration
from tracking.geometry.tsai_calibration import calibration_of_tsai, is_tsai
from tracking.geometry.zed_calibration import calibration_of_zed, is_zed

_ROUGH = re.compile(r"^rough:\s*1\s*$", re.MULTILINE)


def read_calibration(
    paths: Sequence[Path], size: tuple[int, int] | None = None
) -> StereoCalibration:
    """The calibration in one file, or in a pair of files.

    Known are OpenCV FileStorage YAML and XML (one file, or intrinsics and extrinsics), KITTI's
    calib.txt, ROS camera_info YAML (left, right), EuRoC's sensor.yaml (left, right), Kalibr's
    camchain, COLMAP's cameras.txt, a ZED's SN*.conf, an OAK's calib.json, Tsai's XML of PETS and
    TUD, MATLAB's stereoParams as JSON, and JSON or TOML with K, D, R and t; they are told by their
    contents. Lengths are metres where the kind has no unit of its own. Nothing in the files is
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
        plain = _of_text(texts[0], paths[0], size)
        if plain is not None:
            return plain
        files = [(path, _values(path, text)) for path, text in zip(paths, texts, strict=True)]
        if all(is_ros(values) for _, values in files):
            return calibration_of_ros(files, size)
        if all(is_euroc(values) for _, values in files):
            return calibration_of_euroc(files, size)
        if is_camchain(files[0][1]):
            return calibration_of_camchain(files[0][1], paths[0], size)
        merged = {name: value for _, values in files for name, value in values.items()}
        return calibration_of_opencv(merged, paths[0], size)
    except CalibrationError as error:
        if error.reason.values.keys() & {"path", "where"}:  # it names the file
            raise
        raise CalibrationError("{path}: {error}", path=paths[0], error=error) from error


def _of_text(text: str, path: Path, size: tuple[int, int] | None) -> StereoCalibration | None:
    """The calibration of a file that is neither YAML nor XML; None where it is one of these."""
    if is_kitti(text):
        return calibration_of_kitti(text, path, size)
    if is_zed(text):
        return calibration_of_zed(text, path, size)
    if is_colmap(text):
        return calibration_of_colmap(text, path)
    if is_tsai(text):
        return calibration_of_tsai(text, path, size)
    values = parsed(text)
    return None if values is None else calibration_of_json(values, path, size)


def _values(path: Path, text: str) -> dict[str, Any]:
    if text.lstrip()[:1] == "<":
        return parse_xml(text, path)
    return parse_yaml(text, path)


def calibration_text(paths: Sequence[Path]) -> str:
    """The text of calibration files, one after the other, to be kept beside what used them."""
    return "\n".join(read_text(path) for path in paths)


def says_rough(text: str) -> bool:
    """Whether a calibration file's text says that it is rough: metres may be off by a tenth."""
    return _ROUGH.search(text) is not None


def calibration_kind(paths: Sequence[Path]) -> str:
    """The program or format that a calibration file is of, by its contents; to be shown.

    Raises:
        CalibrationError: it cannot be read.
    """
    text = read_text(paths[0])
    by_text = (("KITTI", is_kitti), ("ZED", is_zed), ("COLMAP", is_colmap), ("Tsai", is_tsai))
    for kind, is_kind in by_text:
        if is_kind(text):
            return kind
    values = parsed(text)
    if values is not None:
        return "JSON" if text.lstrip().startswith(("{", "[{")) else "TOML"
    values = _values(paths[0], text)
    for kind, has in (("ROS", is_ros), ("EuRoC", is_euroc), ("Kalibr", is_camchain)):
        if has(values):
            return kind
    return "OpenCV"
