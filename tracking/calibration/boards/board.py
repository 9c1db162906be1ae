"""Calibration boards: what is printed on them, and where in metres."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import cv2
import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError

BoardKind = Literal["chessboard", "charuco", "circles", "asymmetric-circles"]
BOARD_KINDS: tuple[BoardKind, ...] = ("chessboard", "charuco", "circles", "asymmetric-circles")
_FEWEST, _MOST = 3, 60
"""Corners along a side."""
_WIDEST_M = 5.0
"""A square, or the distance of two circles; larger ones are in millimetres by mistake."""
MARKER_SHARE = 0.75
"""Side of a ChArUco marker in squares where nobody says it: what most generators print."""
_CHARUCO_MARGIN = 1
"""Squares of a ChArUco board beside its inner corners."""


@dataclass(frozen=True, slots=True)
class Board:
    """A flat board.

    Attributes:
        kind: what is printed on it.
        columns, rows: inner corners of a chessboard, squares of a ChArUco board, circles of a grid.
        square_m: side of a square, or distance of two neighbouring circles in a row (asymmetric:
            half of it, the distance of two rows), in metres; None: not known, lengths are in
            squares.
        marker_m: side of a ChArUco marker in metres; None: three quarters of a square.
        dictionary: name of the ChArUco markers' dictionary, such as "5X5_100"; "": found.

    Raises:
        CalibrationError: there is no such board.
    """

    kind: BoardKind
    columns: int
    rows: int
    square_m: float | None = None
    marker_m: float | None = None
    dictionary: str = ""

    def __post_init__(self) -> None:
        if not (min(self.columns, self.rows) >= _FEWEST and max(self.columns, self.rows) <= _MOST):
            raise CalibrationError(
                "board: {columns} x {rows} is none that can be looked for; give {fewest} to {most} "
                "along each side, as 9x6",
                columns=self.columns,
                rows=self.rows,
                fewest=_FEWEST,
                most=_MOST,
            )
        for length in (self.square_m, self.marker_m):
            if length is not None and not 0.0 < length <= _WIDEST_M:
                raise CalibrationError(
                    "board: a square of {length:g} m; give its side in metres, as 0.025",
                    length=length,
                )

    @property
    def unit_m(self) -> float:
        """Metres of what lengths are counted in: a square where its side is not known."""
        return 1.0 if self.square_m is None else self.square_m

    def places(self) -> Floats:
        """(n, 3) metres (squares where their side is not known) of all points on the board."""
        columns, rows = self.columns, self.rows
        if self.kind == "charuco":
            columns, rows = columns - _CHARUCO_MARGIN, rows - _CHARUCO_MARGIN
        row, column = np.divmod(np.arange(columns * rows), columns)
        if self.kind == "asymmetric-circles":
            column = 2 * column + row % 2
        return np.column_stack((column, row, 0 * row)) * self.unit_m

    def turned(self) -> Board:
        """The same board lying on its other side."""
        return Board(
            self.kind, self.rows, self.columns, self.square_m, self.marker_m, self.dictionary
        )

    def charuco(self, dictionary: str) -> cv2.aruco.CharucoBoard:
        """OpenCV's own board with the markers of a dictionary."""
        named = getattr(cv2.aruco, f"DICT_{dictionary}", None)
        if named is None:
            raise CalibrationError(
                "board: no dictionary {name} of markers; give one such as 5X5_100", name=dictionary
            )
        marker_m = self.marker_m or MARKER_SHARE * self.unit_m
        if marker_m >= self.unit_m:
            raise CalibrationError(
                "board: a marker of {marker:g} m in a square of {square:g} m; give a smaller one",
                marker=marker_m,
                square=self.unit_m,
            )
        markers = cv2.aruco.getPredefinedDictionary(named)
        return cv2.aruco.CharucoBoard((self.columns, self.rows), self.unit_m, marker_m, markers)


COMMON_DICTIONARIES = ("4X4_50", "5X5_100", "6X6_250", "APRILTAG_36h11", "4X4_250", "5X5_250")
"""Those looked for where none is named."""
