"""The floor from a camera's pose in a file: R and t, or a 4 x 4 matrix, of any convention."""

from __future__ import annotations

import itertools
import json
import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import cv2
import numpy as np

from tracking.arrays import Floats
from tracking.calibration.floor.estimate import FloorEstimate, check_above, estimate_of
from tracking.errors import CalibrationError
from tracking.geometry import Camera
from tracking.geometry.calibration_file_text import parse_yaml, read_text
from tracking.geometry.tsai_calibration import is_tsai, pose_of_tsai
from tracking.translation import msg

Direction = Literal["camera-from-world", "world-from-camera"]
Axes = Literal["opencv", "opengl"]
Up = Literal["z", "-z", "y", "-y"]
_ROTATION = ("R", "rotation", "rotation_matrix", "rmat")
_VECTOR = ("rvec", "rotation_vector")
_SHIFT = ("t", "T", "tvec", "translation", "position")
_WHOLE = ("pose", "matrix", "extrinsic", "extrinsics", "transform", "T_cw", "T_wc")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_TSAI = "camera-from-world opencv z mm"
_TALLEST_M = 60.0
_MM = 1000.0
_ORTHOGONAL = 0.02
_DEEPEST = 3
"""Tables within tables that a pose is looked for in."""
_USUAL_HEIGHT_M, _HEIGHT_SPREAD = 4.0, 1.0
"""Of cameras over a floor, and by which factor (as a logarithm) they usually differ from it."""
_USUAL_ROLL_RAD, _STEEP = 0.15, 0.9
"""Cameras are hardly rolled; those that look down steeply (sine of the tilt) may be anyhow."""
_UPS: Mapping[Up, tuple[float, float, float]] = {
    "z": (0, 0, 1),
    "-z": (0, 0, -1),
    "y": (0, 1, 0),
    "-y": (0, -1, 0),
}
_OPENCV_FROM = {"opencv": np.eye(3), "opengl": np.diag([1.0, -1.0, -1.0])}


@dataclass(frozen=True, slots=True)
class PoseConvention:
    """How a pose is meant.

    Attributes:
        direction: what the matrix takes to what. axes: of the camera: OpenCV's look along +z, y
            down; OpenGL's along -z, y up. up: the world's axis that points up.
        unit_m: metres of one unit of the translation.
    """

    direction: Direction
    axes: Axes
    up: Up
    unit_m: float

    @property
    def words(self) -> str:
        """As it is typed."""
        unit = "m" if self.unit_m == 1.0 else "mm"
        return f"{self.direction} {self.axes} {self.up} {unit}"


_DIRECTIONS: tuple[Direction, ...] = ("camera-from-world", "world-from-camera")
_AXES: tuple[Axes, ...] = ("opencv", "opengl")
CONVENTIONS = tuple(
    PoseConvention(direction, axes, up, unit_m)
    for direction, axes, up, unit_m in itertools.product(_DIRECTIONS, _AXES, _UPS, (1.0, 1 / _MM))
)
"""The likelier ones first."""


def floor_by_pose(path: Path, camera: Camera | None = None, convention: str = "") -> FloorEstimate:
    """The floor from a pose file: JSON, TOML, YAML, or text of 12 or 16 numbers.

    Of all conventions by which the camera is above the floor and looks at it, the one with the
    least roll and a usual height is taken; where others give another floor, that is told.

    Args:
        camera: whose images they are, to see that the floor is in sight; None: not looked at.
        convention: words such as "world-from-camera opengl y mm", each optional; they decide.

    Raises:
        CalibrationError: no pose is in the file, or by no convention the camera is above a floor.
    """
    rotation, shift = _read(path)
    if not convention and is_tsai(read_text(path)):
        convention = _TSAI
    found = [
        (one, floor)
        for one in _named(convention)
        if (floor := _floor(rotation, shift, one)) is not None and _looks_at_it(floor[0], camera)
    ]
    if not found:
        raise CalibrationError(
            "{path}: by no convention this pose stands above a floor that it sees; check it, or "
            "name the convention",
            option="--convention",
            path=path,
        )
    found.sort(key=lambda one: _oddity(*one[1]))  # stable: the likelier convention first
    meant, (up, height_m) = found[0]
    check_above(height_m)
    notes = [msg("{file} is read as {told}", file=path.name, told=meant.words)]
    others = [one for one, floor in found[1:] if _differs(floor, (up, height_m))]
    if others:
        note = msg(
            "it could also be {told}; if the floor is wrong, name the convention",
            told=others[0].words,
        )
        notes.append(note)
    return estimate_of(up, height_m, "pose", 0.0, 0.0, tuple(notes))


def _named(convention: str) -> Iterator[PoseConvention]:
    words = set(convention.lower().replace(",", " ").split())
    known = {"camera-from-world", "world-from-camera", "opencv", "opengl", *_UPS, "m", "mm"}
    if words - known:
        raise CalibrationError(
            "convention: {word} is none; known are {known}",
            option="--convention",
            word=sorted(words - known)[0],
            known=" ".join(sorted(known)),
        )
    for one in CONVENTIONS:
        said = {one.direction, one.axes, one.up, "m" if one.unit_m == 1.0 else "mm"}
        if words <= said:
            yield one


def _floor(rotation: Floats, shift: Floats, meant: PoseConvention) -> tuple[Floats, float] | None:
    """Up in OpenCV's camera axes and the height; None where the camera is not above."""
    up = np.array(_UPS[meant.up], float)
    if meant.direction == "camera-from-world":
        turn, centre = rotation, -rotation.T @ shift
    else:
        turn, centre = rotation.T, shift
    height_m = float(up @ centre) * meant.unit_m
    if not 0.05 <= height_m <= _TALLEST_M:
        return None
    return np.asarray(_OPENCV_FROM[meant.axes] @ turn @ up), height_m


def _looks_at_it(up: Floats, camera: Camera | None) -> bool:
    """Whether the floor is in the lower half of the image, and the image not upside down."""
    tilt = np.rad2deg(np.arcsin(np.clip(-up[2], -1, 1)))
    half_deg = 35.0
    if camera is not None:
        half_deg = float(np.rad2deg(np.arctan(camera.height / 2 / camera.matrix[1, 1])))
    upright = tilt > 60.0 or (-up[1] > abs(up[0]))
    return bool(tilt > -half_deg + 2.0 and upright)


def _oddity(up: Floats, height_m: float) -> float:
    """How unusual a mounting is: rolled, or at no height that cameras are put up at."""
    roll = np.arctan2(abs(up[0]), -up[1]) if abs(up[2]) < _STEEP else 0.0
    far = np.log(height_m / _USUAL_HEIGHT_M) / _HEIGHT_SPREAD
    return round(float((roll / _USUAL_ROLL_RAD) ** 2 + far**2), 3)


def _differs(one: tuple[Floats, float], other: tuple[Floats, float]) -> bool:
    return bool(one[0] @ other[0] < np.cos(np.deg2rad(1)) or abs(one[1] / other[1] - 1) > 0.01)


def _read(path: Path) -> tuple[Floats, Floats]:
    text = read_text(path)
    if is_tsai(text):
        return pose_of_tsai(text, path)
    values = _values(text, path)
    found = _from_mapping(values) if isinstance(values, Mapping) else _matrix_of(values)
    if found is None:
        raise CalibrationError(
            "{path}: holds no pose; give R (3 x 3) and t, or a 4 x 4 matrix, in JSON, TOML, YAML "
            "or as plain numbers",
            path=path,
        )
    rotation, shift = found
    _check_rotation(rotation, str(path))
    return rotation, shift


def _values(text: str, path: Path) -> Any:
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        pass
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError):
        pass
    if re.fullmatch(r"[\s\d.,;eE+\-\[\]()]*", text):
        return [float(number) for number in _NUMBER.findall(text)[:64]]
    return parse_yaml(text, path)


def _from_mapping(values: Mapping[str, Any], depth: int = 0) -> tuple[Floats, Floats] | None:
    rotation = next((values[name] for name in _ROTATION if name in values), None)
    vector = next((values[name] for name in _VECTOR if name in values), None)
    shift = next((values[name] for name in _SHIFT if name in values), None)
    if shift is not None and (rotation is not None or vector is not None):
        turn = _numbers(rotation if rotation is not None else vector)
        move = _numbers(shift)
        if turn is not None and move is not None and len(move) == 3:
            return _turned(turn, move)
    for name in _WHOLE:
        if name in values and (found := _matrix_of(values[name])) is not None:
            return found
    for value in values.values():
        if depth < _DEEPEST and isinstance(value, Mapping):
            deeper = _from_mapping(value, depth + 1)
            if deeper is not None:
                return deeper
    return None


def _turned(turn: Floats, move: Floats) -> tuple[Floats, Floats] | None:
    if len(turn) == 9:
        return turn.reshape(3, 3), move
    if len(turn) == 3:
        return np.asarray(cv2.Rodrigues(turn)[0], float), move
    return None


def _matrix_of(value: Any) -> tuple[Floats, Floats] | None:
    numbers = _numbers(value)
    if numbers is None or len(numbers) not in (12, 16):
        return None
    table = numbers.reshape(-1, 4)
    return table[:3, :3], table[:3, 3]


def _numbers(value: Any) -> Floats | None:
    try:
        table = np.array(value, float).ravel()
    except (TypeError, ValueError, OverflowError):
        return None
    return table if 0 < len(table) <= 64 and np.isfinite(table).all() else None


def _check_rotation(rotation: Floats, where: str) -> None:
    off = np.abs(rotation @ rotation.T - np.eye(3)).max()
    if off > _ORTHOGONAL or np.linalg.det(rotation) < 0:
        raise CalibrationError(
            "{where}: its rotation is none (it must be orthonormal, without a mirror); check it",
            where=where,
        )
