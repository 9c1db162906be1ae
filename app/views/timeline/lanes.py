"""Drawing the lanes: a track a row, solid where measured, hatched where predicted."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QFontMetricsF, QPainter, QPen, QPolygonF

from app.presenters.scenes import Lane
from app.views.theme import Theme, faded
from app.views.timeline.axis import TimeAxis

_BAR = 0.46  # of a lane's height
_THINNEST_PX = 1.5
_NARROWEST_HATCH_PX = 4.0


def draw_lane(painter: QPainter, lane: Lane, row: QRectF, axis: TimeAxis, theme: Theme) -> None:
    """One track in its row; `row` spans the whole width, name and bar."""
    if lane.selected:
        painter.fillRect(row, theme.selection)
    _draw_name(painter, lane, row, axis, theme)
    painter.save()
    painter.setClipRect(QRectF(axis.left, row.top(), axis.width, row.height()))
    colour = theme.track(lane.colour)
    height = row.height() * _BAR
    top = row.center().y() - height / 2
    painter.setPen(Qt.PenStyle.NoPen)
    for start, stop, predicted in visible_spans(lane.spans, axis):
        bar = QRectF(start, top, max(stop - start, _THINNEST_PX), height)
        if predicted:
            _draw_predicted(painter, bar, colour)
        else:
            painter.setBrush(colour)
            painter.drawRoundedRect(bar, min(2.5, bar.width() / 2), 2.5)
    _draw_marks(painter, lane, row, axis, theme)
    painter.restore()


def visible_spans(spans: NDArray[np.int64], axis: TimeAxis) -> list[tuple[float, float, bool]]:
    """Left, right and predicted of the spans inside the axis.

    Where several begin within one pixel only the first is kept: drawing is bounded by the width.
    """
    if not len(spans):
        return []
    left, right = axis.xs_of(spans[:, 0]), axis.xs_of(spans[:, 1])
    inside = (right > axis.left) & (left < axis.left + axis.width)
    left, right, predicted = left[inside], right[inside], spans[inside, 2] != 0
    if len(left) > axis.width:
        _, kept = np.unique(left.astype(np.int64), return_index=True)
        left, right, predicted = left[kept], right[kept], predicted[kept]
    left = np.maximum(left, axis.left - 8)
    right = np.minimum(right, axis.left + axis.width + 8)
    return list(zip(left.tolist(), right.tolist(), predicted.tolist(), strict=True))


def _draw_predicted(painter: QPainter, bar: QRectF, colour: QColor) -> None:
    painter.setBrush(faded(colour, 0.22))
    painter.drawRect(bar)
    if bar.width() < _NARROWEST_HATCH_PX:
        return
    painter.setBrush(QBrush(faded(colour, 0.9), Qt.BrushStyle.BDiagPattern))
    painter.drawRect(bar)


def _draw_name(painter: QPainter, lane: Lane, row: QRectF, axis: TimeAxis, theme: Theme) -> None:
    metrics = QFontMetricsF(painter.font())
    radius = metrics.ascent() * 0.32
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme.track(lane.colour))
    painter.drawEllipse(QPointF(row.left() + 12 + radius, row.center().y()), radius, radius)
    left = row.left() + 20 + 2 * radius
    place = QRectF(left, row.top(), axis.left - left - 8, row.height())
    painter.setPen(theme.text if lane.selected else theme.text_muted)
    text = metrics.elidedText(lane.label, Qt.TextElideMode.ElideRight, place.width())
    flags = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
    painter.drawText(place, flags, text)


def _draw_marks(painter: QPainter, lane: Lane, row: QRectF, axis: TimeAxis, theme: Theme) -> None:
    """A small diamond at every edit."""
    painter.setPen(QPen(theme.sunken, 1.2))
    painter.setBrush(theme.text)
    reach = row.height() * 0.26
    for mark in lane.marks:
        at = QPointF(axis.x_of(mark.frame), row.center().y())
        if axis.left - reach <= at.x() <= axis.left + axis.width + reach:
            corners = [QPointF(0, -reach), QPointF(reach, 0), QPointF(0, reach), QPointF(-reach, 0)]
            painter.drawPolygon(QPolygonF([at + corner for corner in corners]))
