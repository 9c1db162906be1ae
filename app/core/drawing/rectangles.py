"""Rectangles as arrays (..., 4) of left, top, right, bottom: which lie on which, what is free."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


def coords(rects: Sequence[QRectF]) -> Floats:
    """(n, 4)."""
    return np.array([rect.getCoords() for rect in rects], np.float64).reshape(-1, 4)


def as_rect(one: Floats) -> QRectF:
    """Qt's, of one (4,)."""
    left, top, right, bottom = one.tolist()
    return QRectF(left, top, right - left, bottom - top)


def within(rect: QRectF, area: QRectF) -> QRectF:
    """The same, moved into the area; one that is too large begins where that begins."""
    left = max(area.left(), min(rect.left(), area.right() - rect.width()))
    top = max(area.top(), min(rect.top(), area.bottom() - rect.height()))
    return QRectF(left, top, rect.width(), rect.height())


def above(rect: QRectF, others: Sequence[QRectF], gap: float = 0.0) -> QRectF:
    """The same, lifted as little as keeps it off the others, and so far from them."""
    lifted = QRectF(rect)
    for other in sorted(others, key=QRectF.top, reverse=True):
        if lifted.adjusted(-gap, -gap, gap, gap).intersects(other):
            lifted.moveBottom(other.top() - gap)
    return lifted


def beyond(rects: Floats, area: QRectF) -> Flags:
    """(...) whether rectangles (..., 4) reach out of the area."""
    low, high = (area.left(), area.top()), (area.right(), area.bottom())
    out = (rects[..., :2] < np.array(low)) | (rects[..., 2:] > np.array(high))
    return np.asarray(out.any(axis=-1))


def lie_on(rects: Floats, others: Floats) -> Flags:
    """(..., m) on which of the others (m, 4) each rectangle (..., 4) lies."""
    left, top, right, bottom = rects.reshape(-1, 4).T[:, :, None]  # a third of the time of pairs
    lies = (left < others[:, 2]) & (right > others[:, 0])
    lies &= (top < others[:, 3]) & (bottom > others[:, 1])
    return np.asarray(lies).reshape(*rects.shape[:-1], len(others))


def covers(rects: Floats, others: Floats) -> Flags:
    """(...) whether each rectangle (..., 4) lies over any of the others (m, 4)."""
    return np.asarray(lie_on(rects, others).any(axis=-1))
