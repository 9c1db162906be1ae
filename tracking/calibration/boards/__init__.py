"""Cameras calibrated from images of a board."""

from tracking.calibration.boards.board import BOARD_KINDS, Board, BoardKind
from tracking.calibration.boards.calibration import (
    BoardCalibration,
    BoardRequest,
    calibrate_boards,
)
from tracking.calibration.boards.lens_fit import LensKind

__all__ = [
    "BOARD_KINDS",
    "Board",
    "BoardCalibration",
    "BoardKind",
    "BoardRequest",
    "LensKind",
    "calibrate_boards",
]
