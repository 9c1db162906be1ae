"""What a calibration file holds and lacks for a recording, in words, before it is taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tracking.errors import CalibrationError
from tracking.geometry import Camera, StereoCalibration
from tracking.geometry.calibration_reader import calibration_kind
from tracking.recording.recording_calibration import read_with_text
from tracking.recording.tar_pictures import is_tar
from tracking.setup.files import is_container
from tracking.translation import Message, msg

_SAME_SHAPE = 0.01
"""Share by which the aspect ratios of two image sizes may differ and still be scaled."""


@dataclass(frozen=True, slots=True, eq=False)
class CalibrationFacts:
    """A calibration that was read for a recording.

    Attributes:
        calibration: in the size of the recording's images.
        read: what was read, in words. missing: what is not in it, and what that costs.
        scaled: it was made for images of another size.
    """

    calibration: StereoCalibration
    read: tuple[Message, ...]
    missing: tuple[Message, ...]
    scaled: bool


def read_facts(
    files: Sequence[Path],
    size: tuple[int, int],
    stereo: bool,
    topics: Sequence[str] = ("", "", ""),
) -> CalibrationFacts:
    """Read one file, or a pair, for images of this size (width, height).

    Args:
        files: a bag or a tar, too, which may hold its cameras' calibration.
        size: width and height of the images in px. stereo: whether two cameras are there.
        topics: of the cameras, where a file is a bag.

    Raises:
        CalibrationError: unreadable, incomplete, or of images of another shape.
    """
    calibration, _ = read_with_text(files, size, topics)
    own = calibration.left.size
    if abs(own[0] * size[1] / (own[1] * size[0]) - 1.0) > _SAME_SHAPE:
        raise CalibrationError(
            "{name}: made for {width} x {height} px, another shape than the cameras' {width2} x "
            "{height2} px; give the calibration of these cameras",
            name=files[0].name,
            width=own[0],
            height=own[1],
            width2=size[0],
            height2=size[1],
        )
    scaled = calibration.scaled_to(size) if own != size else calibration
    kind = _kind(files)
    read = [
        msg("{kind}, for images of {width} x {height} px", kind=kind, width=own[0], height=own[1])
    ]
    if own != size:
        read.append(
            msg("scaled to the cameras' {width} x {height} px", width=size[0], height=size[1])
        )
    read += facts_of(scaled)
    return CalibrationFacts(scaled, tuple(read), tuple(_missing(scaled, stereo)), own != size)


def _kind(files: Sequence[Path]) -> str:
    """The program that a calibration is of; of a bag ROS, as its camera_info is."""
    if is_container(files[0]):
        return "OAK" if is_tar(files[0]) else "ROS"
    return calibration_kind(files)


def facts_of(calibration: StereoCalibration) -> list[Message]:
    """Lenses and baseline, in words."""
    told = [
        msg(
            "left camera: focal length {focal:.0f} px, field of view {fov:.0f} degrees",
            focal=calibration.left.matrix[0, 0],
            fov=field_of_view_deg(calibration.left),
        )
    ]
    if calibration.right is not None:
        told.append(msg("cameras {metres:.3f} m apart", metres=calibration.baseline_m))
    told.append(_lens(calibration.left))
    return told


def field_of_view_deg(camera: Camera) -> float:
    """Horizontal field of view in degrees, along the middle row."""
    y = camera.matrix[1, 2]
    rays = camera.undistort(np.array([[0.0, y], [camera.width - 1.0, y]]))
    if not np.isfinite(rays).all():
        return float(np.rad2deg(2 * np.arctan(0.5 * camera.width / camera.matrix[0, 0])))
    low, high = np.arctan(rays[:, 0])
    return float(np.rad2deg(high - low))


def _lens(camera: Camera) -> Message:
    if camera.fisheye:
        return msg("a fisheye lens")
    bent = bool(np.any(camera.distortion != 0.0))
    return msg("distortion of the lens is known") if bent else msg("no distortion of the lens")


def _missing(calibration: StereoCalibration, stereo: bool) -> list[Message]:
    missing = []
    if stereo and calibration.right is None:
        missing.append(
            msg("the right camera is missing: there is no depth; add its file, or use a board")
        )
    if not stereo and calibration.right is not None:
        missing.append(msg("of its two cameras the left one is used"))
    if calibration.rough:
        missing.append(msg("it is rough: metres may be off by a tenth"))
    return missing
