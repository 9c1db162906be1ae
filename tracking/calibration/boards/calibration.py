"""Cameras calibrated from images of a board: one camera, or two refined together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.calibration.boards.board import Board
from tracking.calibration.boards.coverage import coverage_map, covered_share
from tracking.calibration.boards.detection import find_dictionary
from tracking.calibration.boards.lens_fit import LensFit, LensKind, PairFit, fit_lens, fit_pair
from tracking.calibration.boards.views import (
    PairedView,
    Views,
    blurred_views,
    find_views,
    first_images,
)
from tracking.errors import CalibrationError
from tracking.geometry import Camera, StereoCalibration
from tracking.progress import Progress, no_progress
from tracking.translation import Message, joined, msg

_FEWEST_VIEWS = 4
"""One view of a flat board leaves focal length and pose open, three are enough in theory."""
_OUTLIER, _LEAST_FACTOR = 3.0, 2.0
"""A view whose error is more than so many robust deviations above the usual one, and more than so
many times it, is left out: deviations of a handful of good views are tiny."""
_ROUNDS = 3
_LEAST_TILT_DEG = 8.0
"""Views whose boards are turned less than this to each other do not tell the focal length."""
_LONGEST_LIST = 5
_ENOUGH_SHARP = 10
"""Views that make a good calibration without the blurred ones."""


@dataclass(frozen=True, slots=True)
class BoardRequest:
    """What is to be calibrated.

    Attributes:
        left, right: a video, a folder or a pattern of pictures; right None: one camera.
        board: what is on them. lens: the model that is fitted.
    """

    left: str
    right: str | None
    board: Board
    lens: LensKind = "standard"


@dataclass(frozen=True, slots=True, eq=False)
class BoardCalibration:
    """Cameras as their views of a board say.

    Attributes:
        calibration: of one camera or two, in metres.
        rms_px: of the refined pair, or of the only camera. left_rms_px, right_rms_px: of each
            camera by itself; right None: one camera.
        per_picture: error in px of each view that was fitted, also of those left out, by name.
        used: names of the views it is made of. rejected: of those left out for their error or blur.
        missed: names of pictures in which no board was found.
        coverage: (rows, columns) points in each cell of the image; covered: share of the cells
            with any.
        row_error_px: mean distance of rows of the same point after rectification; None: one camera.
        notes: oddities, in words.
    """

    calibration: StereoCalibration
    rms_px: float
    left_rms_px: float
    right_rms_px: float | None
    per_picture: dict[str, float]
    used: tuple[str, ...]
    rejected: tuple[str, ...]
    missed: tuple[str, ...]
    coverage: NDArray[np.intp]
    covered: float
    row_error_px: float | None
    notes: tuple[Message, ...]


def calibrate_boards(request: BoardRequest, progress: Progress = no_progress) -> BoardCalibration:
    """Calibrate from images of a board.

    Raises:
        RecordingError: images cannot be read.
        CalibrationError: the board is not found, or the views make no camera.
    """
    return fit_boards(find_boards(request, progress))


@dataclass(frozen=True, slots=True, eq=False)
class FoundBoards:
    """Boards as they were found in all images, to be fitted with some left out or taken in again.

    Attributes:
        board: as it lies. views: of it, also blurred ones. lens: the model that is to be fitted.
        notes: oddities, in words.
        blurred: names of views that do not count unless they are taken in again.
    """

    board: Board
    views: Views
    lens: LensKind
    notes: tuple[Message, ...]
    blurred: tuple[str, ...] = ()


def find_boards(request: BoardRequest, progress: Progress = no_progress) -> FoundBoards:
    """Look for the board in all images; slow.

    Raises:
        RecordingError: images cannot be read.
        CalibrationError: the board is not found, or in too few images.
    """
    if request.right is not None and request.board.square_m is None:
        raise CalibrationError(
            "calibration: two cameras need the board's square in metres, or their distance is not "
            "known; measure it on the print. Without a board there is --rough",
            option="--square",
        )
    request = _with_dictionary(request)
    board, views = _found(request, progress)
    blurred, told = _blurred(views)
    notes = (*views.notes, *_notes(request, board, views), *told)
    return FoundBoards(board, views, request.lens, notes, blurred)


def fit_boards(found: FoundBoards, left_out: frozenset[str] | None = None) -> BoardCalibration:
    """Fit the cameras to boards that were found.

    Args:
        left_out: names of views that do not count; None: the blurred ones are left out, and those
            whose error is far above the others'.

    Raises:
        CalibrationError: the views make no camera, or too few are left.
    """
    views = found.views
    if left_out is None:
        sharp = tuple(view for view in views.views if view.name not in found.blurred)
        fit = _fitted(sharp, found.board, views.size, found.lens)
    else:
        kept = tuple(view for view in views.views if view.name not in left_out)
        if len(kept) < _FEWEST_VIEWS:
            raise CalibrationError(
                "calibration: {count} pictures are left, and {fewest} are needed; take some in "
                "again",
                count=len(kept),
                fewest=_FEWEST_VIEWS,
            )
        fit = _fit(kept, found.board, views.size, found.lens)
        errors = zip(kept, fit.view_rms_px, strict=True)
        fit = replace(fit, errors={view.name: float(px) for view, px in errors})
    _check_tilts(fit.left.rotations)
    return _result(fit, views, found.notes)


@dataclass(frozen=True, slots=True, eq=False)
class _Fit:
    views: tuple[PairedView, ...]
    left: LensFit
    right: LensFit | None
    pair: PairFit | None
    errors: dict[str, float]
    lens: LensKind

    @property
    def view_rms_px(self) -> Floats:
        return self.left.view_rms_px if self.pair is None else self.pair.view_rms_px


def _with_dictionary(request: BoardRequest) -> BoardRequest:
    board = request.board
    if board.kind != "charuco" or board.dictionary:
        return request
    name = find_dictionary(first_images(request.left), board)
    if not name:
        raise CalibrationError(
            "{left}: no ChArUco markers of a common dictionary are seen; name the dictionary",
            option="--dictionary",
            left=request.left,
        )
    return replace(request, board=replace(board, dictionary=name))


def _found(request: BoardRequest, progress: Progress) -> tuple[Board, Views]:
    """The board as it lies, and its views."""
    board = request.board
    views = find_views(request.left, request.right, board, progress)
    # Corners of a chessboard are found whichever way round its size is given.
    if not views.views and board.kind != "chessboard" and board.columns != board.rows:
        board = board.turned()
        views = find_views(request.left, request.right, board, progress)
    if len(views.views) < _FEWEST_VIEWS:
        raise CalibrationError(
            "{left}: the board of {columns} x {rows} is found in {count} of {all} images, and "
            "{fewest} are needed; check its size (inner corners of a chessboard), light and focus",
            left=request.left,
            columns=request.board.columns,
            rows=request.board.rows,
            count=len(views.views),
            all=len(views.views) + len(views.missed),
            fewest=_FEWEST_VIEWS,
        )
    return board, views


def _notes(request: BoardRequest, board: Board, views: Views) -> list[Message]:
    notes = []
    if board is not request.board:
        notes.append(msg("the board is {columns} x {rows}", columns=board.columns, rows=board.rows))
    if request.board.dictionary and request.board.kind == "charuco":
        notes.append(msg("markers of dictionary {name}", name=board.dictionary))
    if views.missed:
        notes.append(
            msg(
                "no board in {count} images, which are left out: {names}",
                count=len(views.missed),
                names=_some(views.missed),
            )
        )
    if views.unpaired:
        notes.append(msg("pictures without a partner: {names}", names=_some(views.unpaired)))
    return notes


def _blurred(views: Views) -> tuple[tuple[str, ...], list[Message]]:
    """Names of blurred views that are left out, as enough are left, and what is said of them."""
    blurred = blurred_views(views.views)
    if not blurred:
        return (), []
    told = {"count": len(blurred), "all": len(views.views), "names": _some(blurred)}
    if len(views.views) - len(blurred) < _ENOUGH_SHARP:
        note = msg(
            "{count} of {all} pictures of the board are blurred, and cost accuracy: {names}", **told
        )
        return (), [note]
    note = msg("{count} of {all} pictures of the board are blurred, and left out: {names}", **told)
    return blurred, [note]


def _some(names: Sequence[str]) -> Message:
    more = ["..."] if len(names) > _LONGEST_LIST else []
    return joined(", ", [*names[:_LONGEST_LIST], *more])


def _fitted(
    views: tuple[PairedView, ...], board: Board, size: tuple[int, int], lens: LensKind
) -> _Fit:
    """The fit to the views but outliers, with the errors of all."""
    errors: dict[str, float] = {}
    for last in (*(False,) * _ROUNDS, True):
        fit = _fit(views, board, size, lens)
        errors |= {view.name: float(px) for view, px in zip(views, fit.view_rms_px, strict=True)}
        good = _inliers(fit.view_rms_px)
        if last or good.all() or good.sum() < max(_FEWEST_VIEWS, len(errors) // 2):
            break
        views = tuple(view for view, kept in zip(views, good, strict=True) if kept)
    return replace(fit, errors=errors)


def _inliers(error_px: Floats) -> NDArray[np.bool_]:
    usual = float(np.median(error_px))
    deviation = 1.4826 * float(np.median(np.abs(error_px - usual)))
    return np.asarray(error_px <= max(usual + _OUTLIER * deviation, _LEAST_FACTOR * usual))


def _fit(
    views: tuple[PairedView, ...], board: Board, size: tuple[int, int], lens: LensKind
) -> _Fit:
    places = board.places()
    lefts = [view.left for view in views]
    rights = [view.right for view in views if view.right is not None]
    left = fit_lens(lefts, places, size, lens, covered_share(lefts, size))
    if not rights:
        return _Fit(views, left, None, None, {}, lens)
    right = fit_lens(rights, places, size, lens, covered_share(rights, size))
    pair = fit_pair(lefts, rights, places, size, (left, right), lens)
    return _Fit(views, left, right, pair, {}, lens)


def _check_tilts(rotations: Floats) -> None:
    """Raise CalibrationError where the boards all face the same way."""
    normal = rotations[:, :, 2]
    cosine = np.clip(np.abs(normal @ normal.T), 0.0, 1.0)
    if np.rad2deg(np.arccos(cosine)).max() < _LEAST_TILT_DEG:
        raise CalibrationError(
            "calibration: the board faces the same way in all images, so that the focal length is "
            "not told; tilt it to the sides and forward by 30 degrees or so"
        )


def _result(fit: _Fit, views: Views, notes: tuple[Message, ...]) -> BoardCalibration:
    used = tuple(view.name for view in fit.views)
    rejected = tuple(view.name for view in views.views if view.name not in used)
    known = [name for name in rejected if name in fit.errors]
    if known:
        told = joined(", ", (f"{name} ({fit.errors[name]:.2f} px)" for name in known))
        notes += (msg("left out, as their error is far above the others': {names}", names=told),)
    lefts = [view.left for view in fit.views]
    calibration = _calibration(fit, views.size)
    return BoardCalibration(
        calibration=calibration,
        rms_px=fit.left.rms_px if fit.pair is None else fit.pair.rms_px,
        left_rms_px=fit.left.rms_px,
        right_rms_px=None if fit.right is None else fit.right.rms_px,
        per_picture=fit.errors,
        used=used,
        rejected=rejected,
        missed=views.missed,
        coverage=coverage_map(lefts, views.size),
        covered=covered_share(lefts, views.size),
        row_error_px=None if fit.pair is None else _row_error(calibration, fit.views),
        notes=notes,
    )


def _calibration(fit: _Fit, size: tuple[int, int]) -> StereoCalibration:
    if fit.pair is None:
        return StereoCalibration.of_one(_camera((fit.left.matrix, fit.left.distortion), size, fit))
    pair = fit.pair
    try:
        return StereoCalibration(
            _camera(pair.left, size, fit),
            _camera(pair.right, size, fit),
            pair.rotation,
            pair.translation,
        )
    except CalibrationError as error:
        raise error.advising("swap left and right where the pictures were mixed up") from error


def _camera(model: tuple[Floats, Floats], size: tuple[int, int], fit: _Fit) -> Camera:
    return Camera(*model, *size, fisheye=fit.lens == "fisheye")


def _row_error(calibration: StereoCalibration, views: Sequence[PairedView]) -> float:
    """Mean distance in px of the rows of the same points after rectification."""
    assert calibration.right is not None, "rows are compared between two cameras"
    left, right = calibration.left, calibration.right
    identity = np.zeros(5)
    turns = cv2.stereoRectify(
        left.matrix,
        identity,
        right.matrix,
        identity,
        left.size,
        calibration.rotation,
        calibration.translation[:, None],
    )
    focal_px = float(turns[2][0, 0])
    rows = []
    for view in views:
        assert view.right is not None, "all views are of both cameras"
        sides = ((left, view.left.pixel, turns[0]), (right, view.right.pixel, turns[1]))
        rays = [
            _turned(camera.undistort(pixel), np.asarray(turn, float))
            for camera, pixel, turn in sides
        ]
        rows.append(focal_px * np.abs(rays[0][:, 1] - rays[1][:, 1]))
    return float(np.nanmean(np.concatenate(rows)))


def _turned(rays: Floats, rotation: Floats) -> Floats:
    turned = np.column_stack((rays, np.ones(len(rays)))) @ rotation.T
    return np.asarray(turned[:, :2] / turned[:, 2:])
