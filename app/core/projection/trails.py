"""The last seconds of everybody's way."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import Columns

TRAIL_S = 3.0


def trails_by_track(rows: Columns, points: NDArray[np.float64]) -> dict[int, NDArray[np.float64]]:
    """Points (n, 2), one a row of the table, as one trail per track, oldest first.

    Rows that have no point (NaN) are left out.
    """
    known = np.isfinite(points).all(axis=1)
    tracks, points = rows["track"][known], points[known]
    order = np.argsort(tracks, kind="stable")  # the rows of a track stand by frame
    ids, starts = np.unique(tracks[order], return_index=True)
    parts = np.split(points[order], starts[1:]) if len(ids) else []
    return {int(one): part for one, part in zip(ids, parts, strict=True)}


def floor_points(rows: Columns) -> NDArray[np.float64]:
    """(n, 2) metres of the rows."""
    return np.column_stack((rows["x"], rows["y"])).astype(np.float64)


def foot_points(rows: Columns) -> NDArray[np.float64]:
    """(n, 2) pixels of the left camera: the middle of the boxes' lower edges."""
    return np.column_stack((rows["left"] + rows["width"] / 2, rows["top"] + rows["height"]))
