"""Where in the image the points of boards fell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tracking.calibration.boards.detection import BoardView

CELLS = (8, 6)
"""Columns and rows that the image is parted into."""


def coverage_map(views: Sequence[BoardView], size: tuple[int, int]) -> NDArray[np.intp]:
    """(rows, columns) points in each cell of images of this size (width, height)."""
    pixel = np.concatenate([view.pixel for view in views]) + 0.5
    counts, _, _ = np.histogram2d(
        pixel[:, 1],
        pixel[:, 0],
        bins=(CELLS[1], CELLS[0]),
        range=((0, size[1]), (0, size[0])),
    )
    return counts.astype(np.intp)


def covered_share(views: Sequence[BoardView], size: tuple[int, int]) -> float:
    """Share of the cells in which points fell."""
    return float((coverage_map(views, size) > 0).mean())
