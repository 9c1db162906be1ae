"""One camera's lens fitted to views of a board, and two cameras to each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import cv2
import numpy as np

from tracking.arrays import Floats
from tracking.calibration.boards.detection import BoardView
from tracking.errors import CalibrationError

_CV: Any = cv2
"""The stubs know neither the shapes nor all the forms of these calls."""
LensKind = Literal["standard", "fisheye"]
_CRITERIA = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 200, 1e-8)
_FEW_TERMS_BELOW = 0.35
"""Share of the image in which corners fell, below which k3 is not fitted: it is made up there."""
_FEW_FISHEYE_TERMS_BELOW = 0.7
"""The same of k3 and k4 of a fisheye, which only the corners tell."""
_FEW_FISHEYE_TERMS = cv2.CALIB_FIX_K3 | cv2.CALIB_FIX_K4
_K3 = 4
"""Its place among OpenCV's coefficients."""
_FISHEYE = cv2.CALIB_RECOMPUTE_EXTRINSIC | cv2.CALIB_FIX_SKEW


@dataclass(frozen=True, slots=True, eq=False)
class LensFit:
    """A camera fitted to views.

    Attributes:
        matrix: (3, 3) px. distortion: (5,) or, of a fisheye, (4,).
        rms_px: over all points. view_rms_px: (views,) of each view.
        rotations: (views, 3, 3) camera from board.
    """

    matrix: Floats
    distortion: Floats
    rms_px: float
    view_rms_px: Floats
    rotations: Floats


@dataclass(frozen=True, slots=True, eq=False)
class PairFit:
    """Two cameras fitted together.

    Attributes:
        left, right: matrix and distortion of each.
        rotation: (3, 3), translation: (3,), x_right = rotation @ x_left + translation.
        rms_px: over all points of both. view_rms_px: (views,) of each pair.
    """

    left: tuple[Floats, Floats]
    right: tuple[Floats, Floats]
    rotation: Floats
    translation: Floats
    rms_px: float
    view_rms_px: Floats


Points = tuple[list[Floats], list[Floats]]


def fit_lens(
    views: Sequence[BoardView],
    places: Floats,
    size: tuple[int, int],
    lens: LensKind,
    covered: float,
) -> LensFit:
    """The camera that sees these views with the least error.

    Args:
        places: (n, 3) of the board. size: width and height in px.
        covered: share of the image in which points fell.

    Raises:
        CalibrationError: no camera sees them so.
    """
    world, image = _points(views, places)
    try:
        if lens == "fisheye":
            return _fit_fisheye(world, image, size, covered)
        return _fit_standard(world, image, size, covered)
    except cv2.error as error:
        raise _no_camera(error) from error


def fit_pair(
    left: Sequence[BoardView],
    right: Sequence[BoardView],
    places: Floats,
    size: tuple[int, int],
    fits: tuple[LensFit, LensFit],
    lens: LensKind,
) -> PairFit:
    """Both cameras and how they stand, refined together from each one's own fit.

    Args:
        left, right: views of the same boards, with the same points.

    Raises:
        CalibrationError: no two cameras see them so.
    """
    world, seen_left = _points(left, places)
    _, seen_right = _points(right, places)
    one, other = fits
    try:
        if lens == "fisheye":
            return _fit_fisheye_pair(world, seen_left, seen_right, size, fits)
        flags = cv2.CALIB_USE_INTRINSIC_GUESS
        flags |= cv2.CALIB_FIX_K3 if not one.distortion[_K3] else 0
        rms, m1, d1, m2, d2, rotation, translation, _, _, _, _, per_view = (
            _CV.stereoCalibrateExtended(
                *([np.float32(part) for part in parts] for parts in (world, seen_left, seen_right)),
                one.matrix.copy(),
                one.distortion[None].copy(),
                other.matrix.copy(),
                other.distortion[None].copy(),
                size,
                np.eye(3),
                np.zeros((3, 1)),
                flags=flags,
                criteria=_CRITERIA,
            )
        )
    except cv2.error as error:
        raise _no_camera(error) from error
    per_pair = np.sqrt((np.asarray(per_view).reshape(len(world), 2) ** 2).mean(axis=1))
    return PairFit(
        (m1, d1.ravel()), (m2, d2.ravel()), rotation, translation.ravel(), float(rms), per_pair
    )


def _points(views: Sequence[BoardView], places: Floats) -> Points:
    return [places[view.point] for view in views], [view.pixel for view in views]


def _fit_standard(
    world: list[Floats], image: list[Floats], size: tuple[int, int], covered: float
) -> LensFit:
    flags = cv2.CALIB_FIX_K3 if covered < _FEW_TERMS_BELOW else 0
    rms, matrix, distortion, turns, _, _, _, per_view = _CV.calibrateCameraExtended(
        [np.float32(part) for part in world],
        [np.float32(part) for part in image],
        size,
        None,
        None,
        flags=flags,
        criteria=_CRITERIA,
    )
    rotations = np.array([cv2.Rodrigues(turn)[0] for turn in turns])
    return LensFit(matrix, distortion.ravel()[:5], float(rms), per_view.ravel(), rotations)


def _fit_fisheye(
    world: list[Floats], image: list[Floats], size: tuple[int, int], covered: float
) -> LensFit:
    objects = [np.asarray(part, np.float64).reshape(1, -1, 3) for part in world]
    seen = [np.asarray(part, np.float64).reshape(1, -1, 2) for part in image]
    flags = _FISHEYE | (_FEW_FISHEYE_TERMS if covered < _FEW_FISHEYE_TERMS_BELOW else 0)
    rms, matrix, distortion, turns, shifts = _CV.fisheye.calibrate(
        objects, seen, size, np.eye(3), np.zeros((4, 1)), flags=flags, criteria=_CRITERIA
    )
    errors = [
        _rms(_CV.fisheye.projectPoints(part, turn, shift, matrix, distortion)[0] - found)
        for part, found, turn, shift in zip(objects, seen, turns, shifts, strict=True)
    ]
    rotations = np.array([cv2.Rodrigues(turn)[0] for turn in turns])
    return LensFit(matrix, distortion.ravel(), float(rms), np.array(errors), rotations)


def _fit_fisheye_pair(
    world: list[Floats],
    left: list[Floats],
    right: list[Floats],
    size: tuple[int, int],
    fits: tuple[LensFit, LensFit],
) -> PairFit:
    one, other = fits
    flags = cv2.CALIB_USE_INTRINSIC_GUESS | cv2.CALIB_FIX_SKEW
    flags |= 0 if one.distortion[2:].any() else _FEW_FISHEYE_TERMS
    objects = [part.reshape(1, -1, 3) for part in _as_many(world)]
    seen = [[part.reshape(1, -1, 2) for part in _as_many(side)] for side in (left, right)]
    found = _CV.fisheye.stereoCalibrate(
        objects,
        *seen,
        one.matrix.copy(),
        one.distortion.reshape(4, 1).copy(),
        other.matrix.copy(),
        other.distortion.reshape(4, 1).copy(),
        size,
        flags=flags,
        criteria=_CRITERIA,
    )
    rms, m1, d1, m2, d2, rotation, translation = found[:7]
    per_pair = np.hypot(one.view_rms_px, other.view_rms_px) / np.sqrt(2)
    return PairFit(
        (m1, d1.ravel()),
        (m2, d2.ravel()),
        rotation,
        np.asarray(translation).ravel(),
        float(rms),
        per_pair,
    )


def _as_many(views: list[Floats]) -> list[Floats]:
    """The points of each view, some of them twice, so that all views have as many.

    OpenCV's fisheye pairs take no views of different lengths, as parts of a ChArUco board are.
    """
    most = max(map(len, views))
    return [np.asarray(view, np.float64)[np.arange(most) % len(view)] for view in views]


def _rms(miss: Floats) -> float:
    return float(np.sqrt((miss.reshape(-1, 2) ** 2).sum(axis=1).mean()))


def _no_camera(error: cv2.error) -> CalibrationError:
    reason = " ".join(str(error.err or error).split())[:120]
    return CalibrationError(
        "calibration: no camera fits these views ({reason}); take some with the board turned and "
        "in other places, or try the other lens",
        reason=reason,
    )
