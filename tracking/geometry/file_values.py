"""Numbers out of the values of calibration files, checked."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera

_MOST_NUMBERS = 64
_NO_MODEL = frozenset(("", "none", "null"))
RADTAN = frozenset(("radtan", "radial-tangential", "plumb_bob", "radial_tangential", *_NO_MODEL))
FISHEYE = frozenset(("equidistant", "kannala_brandt", "fisheye", "equi"))


def numbers(values: Mapping[str, Any], name: str, where: Path, count: int | None = None) -> Floats:
    """The numbers under a name, flat, so many of them where `count` is given.

    Raises:
        CalibrationError: it is missing, or no such list.
    """
    try:
        found = np.array(values[name], float).ravel()
    except (KeyError, TypeError, ValueError, OverflowError) as error:
        raise _no_numbers(where, name) from error
    wrong = found.size > _MOST_NUMBERS or not np.isfinite(found).all()
    if wrong or (count is not None and found.size != count):
        raise _no_numbers(where, name)
    return found


def _no_numbers(where: Path, name: str) -> CalibrationError:
    return CalibrationError(
        "{where}: {name} is missing or no list of numbers", where=where, name=name
    )


def camera_of(
    focal_centre: Floats,
    distortion: Floats,
    model: str,
    size: tuple[int, int] | None,
    where: Path,
) -> Camera:
    """A camera of fx, fy, cx, cy (4,) and the coefficients of a named lens model.

    Raises:
        CalibrationError: the model is not known, the size is not told, or the numbers make none.
    """
    if size is None:
        raise CalibrationError(
            "{where}: says no image size; open it with its recording", where=where
        )
    model = model.lower()
    if model not in RADTAN | FISHEYE:
        raise CalibrationError(
            "{where}: lens model {model} is not known; calibrate with a pinhole and radtan or "
            "equidistant distortion",
            where=where,
            model=model[:40],
        )
    fx, fy, cx, cy = focal_centre
    matrix = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
    return Camera(matrix, distortion, *size, fisheye=model in FISHEYE)


def size_of(
    values: Mapping[str, Any], name: str, where: Path, otherwise: tuple[int, int] | None
) -> tuple[int, int] | None:
    """Width and height under a name; `otherwise` where there is none."""
    if name not in values:
        return otherwise
    width, height = numbers(values, name, where, 2)
    return int(width), int(height)


def pose_of(values: Mapping[str, Any], name: str, where: Path) -> tuple[Floats, Floats]:
    """Rotation (3, 3) and translation (3,) of a 4 x 4 matrix, plain or with rows, cols and data."""
    held = values.get(name)
    if isinstance(held, Mapping):
        values, name = held, "data"
    matrix = numbers(values, name, where, 16).reshape(4, 4)
    return matrix[:3, :3], matrix[:3, 3]
