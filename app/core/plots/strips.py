"""Stretches of frames reduced to columns of pixels: ten thousand cost no more than ten to draw."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QImage, QPainter

from app.core.plots.axis import TimeAxis
from app.core.scenes import SpanKind

_LEAST_SEEN = 0.3
_GAP_SEEN = 0.85
_ALL = 0.999
_DOT_PX, _BETWEEN_DOTS = 3.0, 0.25

Shares = NDArray[np.float64]
"""(columns,) how much of each column of pixels something covers, 0 to 1."""


def spans_in_view(spans: NDArray[np.int64], axis: TimeAxis) -> NDArray[np.int64]:
    """The stretches, ascending, of which a part is shown."""
    low = int(np.searchsorted(spans[:, 1], axis.start, side="right"))
    high = int(np.searchsorted(spans[:, 0], axis.start + axis.frames, side="left"))
    return spans[low:high]


def covered(ranges: NDArray[np.int64], edges: NDArray[np.float64]) -> Shares:
    """The share of each column that the half-open ranges, ascending and apart, cover."""
    if not len(ranges):
        return np.zeros(len(edges) - 1)
    bounds = ranges[:, :2].reshape(-1).astype(np.float64)
    steps = np.diff(bounds, prepend=bounds[0])
    steps[::2] = 0.0  # between two ranges nothing is covered
    return np.diff(np.interp(edges, bounds, np.cumsum(steps))) / np.diff(edges)


def covered_by_kind(
    spans: NDArray[np.int64], axis: TimeAxis, columns: int
) -> dict[SpanKind, Shares]:
    """The shares of each kind of stretch in view."""
    seen, edges = spans_in_view(spans, axis), axis.edges(columns)
    kinds = np.unique(seen[:, 2]).tolist()
    return {SpanKind(kind): covered(seen[seen[:, 2] == kind], edges) for kind in kinds}


def opacity(shares: Shares) -> Shares:
    """How strongly a column is inked: whatever is there is seen, and so is any gap."""
    inked = _LEAST_SEEN + (_GAP_SEEN - _LEAST_SEEN) * shares
    inked[shares >= _ALL] = 1.0
    inked[shares <= 0] = 0.0
    return inked


def dotted(inked: Shares, ratio: float) -> Shares:
    """The same with every other few pixels faint; `ratio` device pixels make one of the screen."""
    phase = np.arange(len(inked)) / (ratio * _DOT_PX)
    return np.where(phase % 2 < 1, inked, inked * _BETWEEN_DOTS)


def draw_strip(painter: QPainter, inked: Shares, colour: QColor, place: QRectF) -> None:
    """Paint columns of one colour, each as strongly as it is inked."""
    if not inked.any():
        return
    shade = np.array([colour.blue(), colour.green(), colour.red(), 255]) * colour.alphaF()
    pixels = np.ascontiguousarray(np.round(inked[:, None] * shade), np.uint8)
    columns = len(inked)
    kind = QImage.Format.Format_ARGB32_Premultiplied
    painter.drawImage(place, QImage(pixels.data, columns, 1, 4 * columns, kind))
