"""The line that divides a picture between two compared versions; it can be dragged."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.drawing.name_plates import PAD_PX, draw_note, note_size
from app.core.look.theme import Theme
from app.core.scenes.other_people import Divider

_REACH_PX, _EDGE_PX, _KNOB_PX = 7.0, 8.0, 5.0
_HALO = QColor(0, 0, 0, 150)


def halves(divider: Divider | None, content: QRectF, shown: QRectF) -> tuple[QRectF, QRectF]:
    """Where the solid and where the dashed version is drawn; both everywhere without a divider.

    Args:
        content: where all of the picture is in the view. shown: as much of it as is in sight.
    """
    if divider is None:
        return shown, shown
    x = divider_x(divider, content)
    left, right = QRectF(shown), QRectF(shown)
    left.setRight(min(max(x, shown.left()), shown.right()))
    right.setLeft(left.right())
    return left, right


def divider_x(divider: Divider, content: QRectF) -> float:
    """Where the line stands in the view."""
    return content.left() + divider.share * content.width()


def is_at_divider(divider: Divider | None, content: QRectF, at: QPointF) -> bool:
    """Whether the line is taken hold of there."""
    return divider is not None and abs(at.x() - divider_x(divider, content)) <= _REACH_PX


def share_at(content: QRectF, at: QPointF) -> float:
    """The share of the picture left of a place of the view."""
    return min(max((at.x() - content.left()) / max(content.width(), 1e-6), 0.0), 1.0)


def draw_divider(
    painter: QPainter, divider: Divider, content: QRectF, shown: QRectF, theme: Theme
) -> None:
    """The line with a knob, and at the top on either side what is drawn there."""
    x = divider_x(divider, content)
    if not shown.left() <= x <= shown.right():
        return
    line = QLineF(x, shown.top(), x, shown.bottom())
    for colour, width in ((_HALO, 4.0), (QColor(255, 255, 255), 1.6)):
        painter.setPen(QPen(colour, width))
        painter.drawLine(line)
    painter.setPen(QPen(_HALO, 1.4))
    painter.setBrush(QColor(255, 255, 255))
    painter.drawEllipse(QPointF(x, shown.center().y()), _KNOB_PX, _KNOB_PX)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    metrics = QFontMetricsF(painter.font())
    top = shown.top() + _EDGE_PX
    for name, room, is_left in (
        (divider.left, x - shown.left(), True),
        (divider.right, shown.right() - x, False),
    ):
        width = room - 2 * _EDGE_PX
        text = metrics.elidedText(name, Qt.TextElideMode.ElideRight, width - PAD_PX - 1)
        size = note_size(metrics, text, width)
        if size.isEmpty() or size.width() > room:
            continue
        start = x - _EDGE_PX - size.width() if is_left else x + _EDGE_PX
        draw_note(painter, QRectF(QPointF(start, top), size), text, theme)
