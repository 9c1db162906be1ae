"""Tsai's camera model as PETS and TUD write it: an XML file of one camera, with its pose."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element, ParseError

import cv2
import numpy as np
from defusedxml.common import DefusedXmlException
from defusedxml.ElementTree import fromstring

from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.stereo_calibration import StereoCalibration

_TSAI = re.compile(r"<(?:\w+:)?Intrinsic\b[^<>]*\bfocal=", re.DOTALL)
_INTRINSIC = ("focal", "kappa1", "cx", "cy", "sx")
_GEOMETRY = ("dpx", "dpy")
_FITTED_SHARES = np.linspace(-0.5, 0.5, 21)
"""Of the image's width and height, where the lens is turned into OpenCV's."""
_LARGEST_R2 = 1e12
"""Squared tangents: a ray a millionth of a radian from the image's plane; lenses end before."""
_LEAST, _MOST = 1e-9, 1e9
"""Of numbers above 0, and of all: what no camera has, and arithmetic still holds."""


def is_tsai(text: str) -> bool:
    """Whether the text is of Tsai's model: intrinsics with a focal length in millimetres."""
    return _TSAI.search(text) is not None


def calibration_of_tsai(text: str, where: Path, size: tuple[int, int] | None) -> StereoCalibration:
    """The camera of a Tsai file; its pose is read by `floor --pose`.

    The focal length is in mm, sensor elements `dpx`, `dpy` are mm a pixel, `sx` stretches rows, and
    `kappa1` (1/mm2) leads from distorted to undistorted sensor coordinates: undistorted =
    distorted (1 + kappa1 r2). OpenCV's polynomial goes the other way and is fitted over the image.

    Args:
        size: width and height of the recording in px; None: as the file says.

    Raises:
        CalibrationError: incomplete, or the image's size is not known.
    """
    root = _root(text, where)
    inner = _numbers(root, "Intrinsic", _INTRINSIC, where)
    sensor = _numbers(root, "Geometry", _GEOMETRY, where)
    own = _size_told(root) or size
    if own is None:
        raise CalibrationError(
            "{where}: does not say the images' size; open it with its recording", where=where
        )
    if min(inner["focal"], inner["sx"], sensor["dpx"], sensor["dpy"]) < _LEAST:
        raise CalibrationError(
            "{where}: focal length, sx, dpx and dpy must be above 0", where=where
        )
    focal = inner["focal"] * np.array((inner["sx"] / sensor["dpx"], 1.0 / sensor["dpy"]))
    matrix = np.array(((focal[0], 0, inner["cx"]), (0, focal[1], inner["cy"]), (0, 0, 1.0)))
    # The plain camera first: it refuses what is no size or no matrix.
    plain = Camera(matrix, np.zeros(5), *own)
    lens = _lens(inner["kappa1"] * inner["focal"] ** 2, plain)
    if not np.isfinite(lens).all():
        raise CalibrationError(
            "{where}: Tsai's kappa1 bends the image out of sight; check the file", where=where
        )
    return StereoCalibration.of_one(replace(plain, distortion=lens))


def _lens(kappa: float, plain: Camera) -> np.ndarray:
    """(5,) OpenCV's k1 k2 p1 p2 k3 nearest to Tsai's kappa, which is in focal lengths here.

    Not finite where numbers do not hold so strong a distortion.
    """
    if kappa == 0.0:
        return np.zeros(5)
    u, v = np.meshgrid(*((_FITTED_SHARES + 0.5) * side for side in plain.size))
    pixels = np.column_stack((u.ravel(), v.ravel()))
    distorted = (pixels - plain.matrix[:2, 2]) / plain.matrix[[0, 1], [0, 1]]
    straight = distorted * (1.0 + kappa * (distorted**2).sum(axis=1))[:, None]
    r2 = (straight**2).sum(axis=1)
    if r2.max() > _LARGEST_R2:
        return np.full(5, np.nan)
    known = r2 > 1e-9
    ratio = np.sqrt((distorted[known] ** 2).sum(axis=1) / r2[known]) - 1.0
    powers = np.column_stack([r2[known] ** power for power in (1, 2, 3)])
    # Pixels count alike: errors at the edge are larger by the radius.
    weight = np.sqrt(r2[known])
    k1, k2, k3 = np.linalg.lstsq(powers * weight[:, None], ratio * weight, rcond=None)[0]
    return np.array((k1, k2, 0.0, 0.0, k3))


def pose_of_tsai(text: str, where: Path) -> tuple[np.ndarray, np.ndarray]:
    """Rotation (3, 3) and translation (3,), camera from world, in millimetres.

    Raises:
        CalibrationError: incomplete.
    """
    values = _numbers(_root(text, where), "Extrinsic", ("tx", "ty", "tz", "rx", "ry", "rz"), where)
    about_x, about_y, about_z = (
        cv2.Rodrigues(axis * values[key])[0]
        for axis, key in zip(np.eye(3), ("rx", "ry", "rz"), strict=True)
    )
    shift = np.array([values[key] for key in ("tx", "ty", "tz")])
    return np.asarray(about_z @ about_y @ about_x), shift


def _root(text: str, where: Path) -> Element:
    try:
        return fromstring(text.encode(), forbid_dtd=True)
    except (ParseError, DefusedXmlException, ValueError) as error:
        raise CalibrationError("{where}: not readable as XML", where=where) from error


def _numbers(root: Element, tag: str, names: tuple[str, ...], where: Path) -> dict[str, float]:
    """Attributes of the first element of this name, its name space left out."""
    found = next((each for each in root.iter() if _name(each) == tag), None)
    values = {} if found is None else found.attrib
    missing = [name for name in names if name not in values]
    if missing:
        raise CalibrationError(
            "{where}: Tsai's {tag} lacks {names}",
            where=where,
            tag=tag,
            names=", ".join(missing),
        )
    try:
        numbers = {name: float(values[name]) for name in names}
    except ValueError as error:
        raise CalibrationError(
            "{where}: Tsai's {tag} holds what is no number", where=where, tag=tag
        ) from error
    if not all(abs(number) <= _MOST for number in numbers.values()):
        raise CalibrationError(
            "{where}: Tsai's {tag} holds what is no number, or one too large", where=where, tag=tag
        )
    return numbers


def _size_told(root: Element) -> tuple[int, int] | None:
    geometry = next((each for each in root.iter() if _name(each) == "Geometry"), None)
    if geometry is None:
        return None
    try:
        width, height = (int(float(geometry.attrib[key])) for key in ("width", "height"))
    except (KeyError, ValueError, OverflowError):
        return None
    return (width, height) if min(width, height) > 0 else None


def _name(element: Element) -> str:
    return element.tag.rpartition("}")[2]
