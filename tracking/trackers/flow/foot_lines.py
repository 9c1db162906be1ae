"""Where the foreground below points ends: on the feet of whoever stands there in front."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor

Floats = NDArray[np.float64]
Mask = NDArray[np.uint8]

_HALF_WIDTH_M = 0.12
"""A strip so wide to either side of a point holds a foot of its body."""
_CHEST_DROP_M = 1.0
"""Points are thought to be so far below the camera, where their strips are measured out."""
_FAR = 20.0
"""Slope of rays that are not known: their strips are as narrow as strips can be."""
_GAP_ROWS, _EDGE_ROWS = 3, 2
"""Lines of the mask without foreground over which a body goes on; lines at its lower edge, where
feet may be cut off."""


def foot_lines(points: Floats, slope: Floats, mask: Mask, floor: Floor) -> NDArray[np.float32]:
    """(n,) px: the line of the picture as recorded on which the foreground below points ends.

    NaN where it goes on to the picture's lower edge, and of points whose ray is not known.

    Args:
        points: (n, 2) px. slope: (n, 2) where their rays go, see `Floor`.
        mask: (rows, columns) of the foreground at half resolution, see `halving`.
    """
    rows = len(mask)
    row = np.clip(points[:, 1] / 2, 0, rows - 1).astype(np.intp)
    strips = _strips(points, slope, mask, floor)
    goes_on = strips.copy()
    for back in range(1, _GAP_ROWS + 1):
        goes_on[:, back:] |= strips[:, :-back]
    goes_on |= np.arange(rows) <= row[:, None]
    first = goes_on.argmin(axis=1)
    last = np.where(goes_on[np.arange(len(row)), first], rows, first - 1 - _GAP_ROWS)
    last = np.maximum(last, row)
    known = (last < rows - _EDGE_ROWS) & np.isfinite(slope).all(axis=1)
    return np.where(known, 2 * last + 1.5, np.nan).astype(np.float32)


def _strips(points: Floats, slope: Floats, mask: Mask, floor: Floor) -> NDArray[np.bool_]:
    """(n, rows) whether anything is foreground in each line of the strips round points."""
    columns = mask.shape[1]
    column = np.clip(points[:, 0] / 2, 0, columns - 1).astype(np.intp)
    away = np.hypot(np.hypot(*np.nan_to_num(slope, nan=_FAR).T), 1.0) * _CHEST_DROP_M
    half_px = _HALF_WIDTH_M * floor.view.camera.matrix[0, 0] / away
    half = np.maximum(np.rint(half_px / 2), 1).astype(np.intp)
    sums = np.zeros((columns + 1, len(mask)), np.int16)
    np.cumsum(np.ascontiguousarray(mask.T) > 0, axis=0, dtype=np.int16, out=sums[1:])
    right, left = np.minimum(column + half + 1, columns), np.maximum(column - half, 0)
    return np.asarray(sums[right] > sums[left])
