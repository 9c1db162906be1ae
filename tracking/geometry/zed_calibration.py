"""Stereolabs' SN*.conf: a ZED's factory calibration, a section for each resolution."""

from __future__ import annotations

import configparser
from pathlib import Path

import cv2
import numpy as np

from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.file_values import camera_of
from tracking.geometry.stereo_calibration import StereoCalibration

_RESOLUTIONS = {
    (2208, 1242): "2K",
    (1920, 1080): "FHD",
    (1920, 1200): "FHD1200",
    (1280, 720): "HD",
    (960, 600): "SVGA",
    (672, 376): "VGA",
}
_MM = 1e-3


def is_zed(text: str) -> bool:
    """Whether the text is a ZED's."""
    return "[STEREO]" in text and "[LEFT_CAM_" in text


def calibration_of_zed(text: str, where: Path, size: tuple[int, int] | None) -> StereoCalibration:
    """Both cameras at the recording's resolution; lengths are in millimetres.

    Raises:
        CalibrationError: the size is none of a ZED's, or its section is incomplete.
    """
    name = _RESOLUTIONS.get(size) if size is not None else None
    if size is None or name is None:
        raise CalibrationError(
            "{where}: holds no calibration of this image size; open it with a recording of {sizes}",
            where=where,
            sizes=", ".join(f"{width}x{height}" for width, height in _RESOLUTIONS),
        )
    parser = configparser.ConfigParser(interpolation=None, strict=False)
    try:
        parser.read_string(text)
        sections = [dict(parser[f"{side}_CAM_{name}"]) for side in ("LEFT", "RIGHT")]
        stereo = dict(parser["STEREO"])
        left, right = (_camera(section, size, where) for section in sections)
        turn = [float(stereo.get(f"{key}_{name}".lower(), "0")) for key in ("RX", "CV", "RZ")]
        shift = [float(stereo.get(key, "0")) for key in ("baseline", "ty", "tz")]
    except (configparser.Error, KeyError, ValueError) as error:
        raise CalibrationError(
            "{where}: its section of {name} is incomplete", where=where, name=name
        ) from error
    rotation = np.asarray(cv2.Rodrigues(np.array(turn))[0], float)
    return StereoCalibration(left, right, rotation, -_MM * np.array(shift))


def _camera(section: dict[str, str], size: tuple[int, int], where: Path) -> Camera:
    main = np.array([float(section[key]) for key in ("fx", "fy", "cx", "cy")])
    lens = np.array([float(section.get(key, "0")) for key in ("k1", "k2", "p1", "p2", "k3")])
    return camera_of(main, lens, "", size, where)
