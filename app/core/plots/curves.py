"""Curves over frames as paths: a hundred thousand points cost no more than the pixels they fill."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainterPath

from app.core.drawing.viewport import path_through
from app.core.plots.axis import TimeAxis

Floats = NDArray[np.float64]
_LEAST_SCORES, _LOWEST_SCORE = (-1.0, 1.0), -2.0
PART_LINES = (Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine, Qt.PenStyle.DotLine)
"""Of head, torso and hip-leg: their curves differ in more than colour."""


def curve_path(
    frames: NDArray[np.int64],
    values: Floats,
    axis: TimeAxis,
    place: QRectF,
    span: tuple[float, float],
) -> QPainterPath:
    """A curve through values at frames; broken where frames are missing or a value is NaN.

    Args:
        frames: (n,) ascending. values: (n,). place: where `span` (lowest, highest) fits in height.
    """
    x, y = thinned(frames, values, axis)
    low, high = span
    share = np.clip((y - low) / max(high - low, 1e-12), 0.0, 1.0)
    points = np.column_stack((x, place.bottom() - share * place.height()))
    return path_through(points, closed=False)


def thinned(frames: NDArray[np.int64], values: Floats, axis: TimeAxis) -> tuple[Floats, Floats]:
    """Places on the screen and values; of many in one column of pixels the lowest and highest."""
    first = max(int(np.searchsorted(frames, axis.start)) - 1, 0)
    stop = int(np.searchsorted(frames, axis.start + axis.frames)) + 1
    frames, values = frames[first:stop], values[first:stop]
    gaps = np.flatnonzero(np.diff(frames) > 1) + 1
    x = np.insert(axis.xs_of(frames) + axis.px_per_frame / 2, gaps, np.nan)
    y = np.insert(values, gaps, np.nan)
    if len(x) <= 2 * axis.width:
        return x, y
    column = np.floor(np.where(np.isnan(x), np.roll(x, 1), x))
    begins = np.flatnonzero(np.append(True, column[1:] != column[:-1]))
    ends = np.stack((np.fmin.reduceat(y, begins), np.fmax.reduceat(y, begins)), axis=1)
    return np.repeat(column[begins], 2), ends.reshape(-1)


def score_span(scores: list[Floats]) -> tuple[float, float]:
    """What of a failure score a low lane draws: around the threshold; far below is its floor."""
    low, high = span_of(scores, _LEAST_SCORES)
    return max(low, _LOWEST_SCORE), high


def whole_span(curves: list[Floats], least: tuple[float, float]) -> tuple[float, float]:
    """Lowest and highest value, at least so wide: nothing is left out."""
    known = np.concatenate([one[np.isfinite(one)] for one in curves] or [np.zeros(0)])
    if not len(known):
        return least
    return min(float(known.min()), least[0]), max(float(known.max()), least[1])


def span_of(curves: list[Floats], least: tuple[float, float]) -> tuple[float, float]:
    """Lowest and highest value worth showing, at least so wide; single wild ones do not count."""
    known = np.concatenate([one[np.isfinite(one)] for one in curves] or [np.zeros(0)])
    if not len(known):
        return least
    low, high = np.quantile(known, (0.005, 0.995)).tolist()
    return min(low, least[0]), max(high, least[1])


def stretches(frames: NDArray[np.int64]) -> NDArray[np.int64]:
    """(k, 2) half-open ranges of ascending frames that follow each other."""
    if not len(frames):
        return np.zeros((0, 2), np.int64)
    breaks = np.flatnonzero(np.diff(frames) > 1)
    first = frames[np.append(0, breaks + 1)]
    last = frames[np.append(breaks, len(frames) - 1)]
    return np.column_stack((first, last + 1))
