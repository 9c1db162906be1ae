"""A place for words beside somebody where they hide neither people nor other words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF, QSizeF

from tracking.tracks.boxes import common_px2

Floats = NDArray[np.float64]
_GAP_PX = 14.0
_HIDING = 12.0
"""A pixel of somebody hidden is as bad as so many further away."""
_ASKEW = 0.25
"""Of the way: how much worse it is to stand above or below than straight beside."""
_NEAREST = 10


def free_place(
    size: QSizeF, beside: QRectF, taken: Sequence[QRectF], area: QRectF
) -> tuple[QRectF, float]:
    """Where a rectangle stands best: near, inside the area, hiding as little as can be.

    Args:
        beside: whom it speaks of; it is not to be hidden either. taken: what else is not.

    Returns:
        The place, and how many square pixels of others it hides there.
    """
    others = sorted(taken, key=lambda one: _apart(one, beside))[:_NEAREST]
    places = _candidates(size, beside, others, area)
    hidden = _hidden(places, _sides([beside, *taken]))
    middle = places[:, :2] + places[:, 2:] / 2
    own = beside.center()
    across = np.maximum(np.abs(middle[:, 0] - own.x()) - (beside.width() + size.width()) / 2, 0)
    down = np.maximum(np.abs(middle[:, 1] - own.y()) - (beside.height() + size.height()) / 2, 0)
    askew = _ASKEW * np.abs(middle[:, 1] - own.y())
    best = int(np.argmin(np.round(_HIDING * hidden + across + down + askew, 3)))
    return QRectF(*places[best].tolist()), float(hidden[best])


def _apart(one: QRectF, other: QRectF) -> float:
    between = one.center() - other.center()
    return float(np.hypot(between.x(), between.y()))


def _candidates(size: QSizeF, beside: QRectF, others: Sequence[QRectF], area: QRectF) -> Floats:
    """(n, 4) left, top, width, height: right of whom it speaks of first."""
    width, height = size.width(), size.height()
    lefts = [beside.right() + _GAP_PX, beside.left() - _GAP_PX - width]
    lefts += [beside.center().x() - width / 2, area.left(), area.right() - width]
    tops = [beside.top(), beside.bottom() - height, beside.center().y() - height / 2]
    tops += [beside.top() - _GAP_PX - height, beside.bottom() + _GAP_PX]
    tops += [area.top(), area.bottom() - height]
    for one in others:
        lefts += [one.right() + 2, one.left() - 2 - width]
        tops += [one.bottom() + 2, one.top() - 2 - height]
    x = np.clip(lefts, area.left(), max(area.left(), area.right() - width))
    y = np.clip(tops, area.top(), max(area.top(), area.bottom() - height))
    across, down = np.meshgrid(x, y)
    corners = np.column_stack((across.ravel(), down.ravel()))
    return np.column_stack((corners, np.full((len(corners), 2), (width, height))))


def _sides(rects: Sequence[QRectF]) -> Floats:
    return np.array([(r.left(), r.top(), r.width(), r.height()) for r in rects], np.float64)


def _hidden(places: Floats, others: Floats) -> Floats:
    """(n,) square pixels of the others, (m, 4), that each place, (n, 4), covers."""
    return np.asarray(common_px2(places[:, None], others[None]).sum(axis=1))
