"""Points of a board found in an image."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.calibration.boards.board import COMMON_DICTIONARIES, Board

GrayImage = NDArray[np.uint8]
_WINDOW_SHARE = 0.25
"""Half the side of the window in which a corner is refined, in distances to its neighbour: a larger
one holds the next corner where the board is seen aslant, a smaller one gives edges away."""
_LEAST_WINDOW_PX = 2
_CRITERIA = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 100, 1e-4)
_LEAST_CHARUCO = 6
"""Corners of a part of a ChArUco board: fewer give no pose worth counting."""


@dataclass(frozen=True, slots=True, eq=False)
class BoardView:
    """A board in one image.

    Attributes:
        point: (n,) which points of `Board.places`. pixel: (n, 2) where they are in the image.
    """

    point: NDArray[np.intp]
    pixel: Floats

    def __len__(self) -> int:
        """The number of points found."""
        return len(self.point)

    def only(self, points: NDArray[np.intp]) -> BoardView:
        """Those of these points that were found."""
        kept = np.isin(self.point, points)
        return BoardView(self.point[kept], self.pixel[kept])


def find_board(image: GrayImage, board: Board, *, thorough: bool = True) -> BoardView | None:
    """The board in an image (height, width); None where it is not found whole.

    Of a ChArUco board a part suffices. A chessboard that is not found at once is sought for long if
    `thorough`.
    """
    if board.kind == "charuco":
        return _find_charuco(image, board)
    found = (
        _find_corners(image, board, thorough)
        if board.kind == "chessboard"
        else _circles(image, board)
    )
    if found is None or not np.isfinite(found).all():
        return None
    return BoardView(np.arange(len(found)), found)


def find_dictionary(images: list[GrayImage], board: Board) -> str:
    """The dictionary whose markers most of the images show; "" where none is seen."""
    seen = dict.fromkeys(COMMON_DICTIONARIES, 0)
    for image in images:
        for name in seen:
            view = _charuco_view(image, board, name)
            seen[name] += 0 if view is None else len(view)
    best = max(seen, key=lambda name: seen[name])
    return best if seen[best] else ""


def _find_corners(image: GrayImage, board: Board, thorough: bool) -> Floats | None:
    size = board.columns, board.rows
    quick = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_FAST_CHECK
    found, corners = cv2.findChessboardCorners(image, size, flags=quick)
    if not found and thorough:
        everything = cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_EXHAUSTIVE
        found, corners = cv2.findChessboardCornersSB(image, size, flags=everything)
    if not found or len(corners) != board.columns * board.rows:
        return None
    return _refined(image, np.asarray(corners, np.float32).reshape(-1, 2), board)


def _refined(image: GrayImage, corners: NDArray[np.float32], board: Board) -> Floats:
    grid = corners.reshape(board.rows, board.columns, 2)
    steps = (np.diff(grid, axis=axis).reshape(-1, 2) for axis in (0, 1))
    spacing_px = min(float(np.hypot(*step.T).min()) for step in steps)
    half = max(_LEAST_WINDOW_PX, int(_WINDOW_SHARE * spacing_px))
    points = np.ascontiguousarray(corners.reshape(-1, 1, 2))
    refined = cv2.cornerSubPix(image, points, (half, half), (-1, -1), _CRITERIA)
    return np.asarray(refined, np.float64).reshape(-1, 2)


def _circles(image: GrayImage, board: Board) -> Floats | None:
    asymmetric = board.kind == "asymmetric-circles"
    grid = cv2.CALIB_CB_ASYMMETRIC_GRID if asymmetric else cv2.CALIB_CB_SYMMETRIC_GRID
    for flags in (grid, grid | cv2.CALIB_CB_CLUSTERING):
        found, centres = cv2.findCirclesGrid(image, (board.columns, board.rows), flags=flags)
        if found and len(centres) == board.columns * board.rows:
            return np.asarray(centres, np.float64).reshape(-1, 2)
    return None


def _find_charuco(image: GrayImage, board: Board) -> BoardView | None:
    return _charuco_view(image, board, board.dictionary) if board.dictionary else None


def _charuco_view(image: GrayImage, board: Board, dictionary: str) -> BoardView | None:
    detector = cv2.aruco.CharucoDetector(board.charuco(dictionary))
    corners, ids, _, _ = detector.detectBoard(image)
    if ids is None or len(ids) < _LEAST_CHARUCO:
        return None
    pixel = np.asarray(corners, np.float64).reshape(-1, 2)
    return BoardView(np.asarray(ids, np.intp).ravel(), pixel)


def same_way_round(left: BoardView, right: BoardView) -> BoardView:
    """The right camera's view, its points counted from the left one's first corner.

    A board without a mark looks the same upside down, and each image's corners begin where they
    were found first. Two cameras side by side see it the same way up.
    """
    one, other = (view.pixel[-1] - view.pixel[0] for view in (left, right))
    if len(left) != len(right) or float(one @ other) >= 0.0:
        return right
    return BoardView(right.point, right.pixel[::-1].copy())
