"""What the overview shows of a whole recording and stays while the playhead moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QImage, QPainter

from app.core.look.theme import Theme, faded
from app.core.plots.axis import TimeAxis
from app.core.plots.strips import draw_strip
from app.core.scenes import TimelineScene
from app.features.timeline.lanes import draw_reviewed

_TRACKED_PX, _REVIEW_ITEM_PX = 3, 6


def draw_overview(
    painter: QPainter,
    scene: TimelineScene,
    review_items: NDArray[np.int64],
    axis: TimeAxis,
    ground: QRectF,
    theme: Theme,
) -> None:
    """How busy it is, what was reviewed, where to look, and below what was tracked."""
    if scene.reviewed:
        draw_reviewed(painter, scene.reviewed, axis, ground, theme, _TRACKED_PX + 1)
    _draw_activity(painter, scene, ground, theme)
    foot = QRectF(ground.left(), ground.bottom() - _TRACKED_PX, ground.width(), _TRACKED_PX)
    draw_band(painter, scene.tracked, axis, foot, theme.accent)
    top = QRectF(ground.left(), ground.top() + 3, ground.width(), _REVIEW_ITEM_PX)
    _draw_review_items(painter, review_items, axis, top, theme)


def draw_band(
    painter: QPainter, frames: tuple[int, int], axis: TimeAxis, band: QRectF, colour: QColor
) -> None:
    """A stretch of frames as a bar in a band."""
    left, right = axis.x_of(frames[0]), axis.x_of(frames[1])
    if right > left:
        painter.fillRect(QRectF(left, band.top(), right - left, band.height()), colour)


def busiest(activity: NDArray[np.uint16], columns: int) -> NDArray[np.float64]:
    """The most people at once in each of `columns` equal parts of the recording."""
    if not len(activity) or columns < 1:
        return np.zeros(max(columns, 0))
    starts = np.minimum(np.arange(columns) * len(activity) // columns, len(activity) - 1)
    return np.asarray(np.maximum.reduceat(activity, starts), np.float64)


def _draw_activity(painter: QPainter, scene: TimelineScene, ground: QRectF, theme: Theme) -> None:
    columns, rows = int(ground.width()), int(ground.height()) - 5
    most = busiest(scene.activity, columns)
    if columns < 1 or rows < 1 or not most.any():
        return
    tops = rows - np.ceil(rows * most / most.max())
    filled = np.arange(rows)[:, None] >= tops
    ink = faded(theme.text_faint, 0.55)
    pixels = np.where(filled, np.uint32(ink.rgba()), np.uint32(0))
    image = QImage(pixels.data, columns, rows, 4 * columns, QImage.Format.Format_ARGB32)
    painter.drawImage(QPointF(ground.left(), ground.top() + 2), image)


def _draw_review_items(
    painter: QPainter, frames: NDArray[np.int64], axis: TimeAxis, band: QRectF, theme: Theme
) -> None:
    """A tick each, of two columns so that a single one is seen."""
    columns = max(2, int(axis.width))
    at = (frames + 0.5) * columns / max(axis.frame_count, 1)
    inside = at[(at >= 0) & (at < columns - 1)].astype(np.int64)
    inked = np.zeros(columns)
    inked[inside] = inked[inside + 1] = 1.0
    draw_strip(painter, inked, theme.warning, band)
