"""Cameras calibrated from images of a board."""

from tracking.calibration.boards.board import BOARD_KINDS, Board, BoardKind
from tracking.calibration.boards.calibration import (
    BoardCalibration,
    BoardRequest,
    FoundBoards,
    calibrate_boards,
    find_boards,
    fit_boards,
)
from tracking.calibration.boards.lens_fit import LensKind

__all__ = [
    "BOARD_KINDS",
    "Board",
    "BoardCalibration",
    "BoardKind",
    "BoardRequest",
    "FoundBoards",
    "LensKind",
    "calibrate_boards",
    "find_boards",
    "fit_boards",
]
