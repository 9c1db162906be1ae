"""The part of the pictures that follows one person through a clip."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import uniform_filter1d

from tracking.tracks import Columns
from tracking.tracks.columns import boxes_of

Floats = NDArray[np.float64]

_AROUND = 1.9
"""Of the person's height the part is high."""
_ASPECT = 0.8
"""It is so much wider than high: a person with what they walk past."""
_LEAST_PX = 48.0
_SMOOTHED_S = 0.6
_HIGH = 90
"""Percentile of a person's heights that is taken for it: few boxes are too high."""


def follow(
    rows: Columns, frames: tuple[int, int], size: tuple[int, int], fps: float
) -> Floats | None:
    """The part shown in each frame of a range: (n, 4) left, top, width, height in pixels.

    All are of one size and lie in the picture. They glide with the person, and where nobody is
    known they pass from the last place to the next.

    Args:
        rows: of the person, sorted by frame. size: of the picture, px.

    Returns:
        None where the person is never in the range.
    """
    start, stop = frames
    inside = (rows["frame"] >= start) & (rows["frame"] < stop)
    boxes = boxes_of(rows, inside).astype(np.float64)
    known = np.isfinite(boxes).all(axis=1)
    if not known.any():
        return None
    boxes, at = boxes[known], rows["frame"][inside][known]
    high = float(np.clip(_AROUND * np.percentile(boxes[:, 3], _HIGH), _LEAST_PX, size[1]))
    wide = min(_ASPECT * high, float(size[0]))
    every = np.arange(start, stop)
    parts = np.empty((len(every), 4))
    for axis, (extent, room) in enumerate(((wide, size[0]), (high, size[1]))):
        middle = np.interp(every, at, boxes[:, axis] + boxes[:, axis + 2] / 2)
        window = max(1, min(len(every), round(_SMOOTHED_S * fps)))
        glided = uniform_filter1d(middle, window, mode="nearest")
        parts[:, axis] = np.clip(glided - extent / 2, 0.0, room - extent)
        parts[:, axis + 2] = extent
    return parts
