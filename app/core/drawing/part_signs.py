"""Small signs of what is said of a part, told apart by their form."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

_LARGEST_PX, _SMALLEST_PX, _SHARE = 7.0, 3.6, 0.3
FAILED = QColor(226, 35, 35)
_CASING, _WHITE = QColor(0, 0, 0, 150), QColor(255, 255, 255)


def sign_radius(rect: QRectF) -> float:
    """Of a sign at a corner of a rectangle: of somebody far away little would be seen below it."""
    return max(_SMALLEST_PX, min(_LARGEST_PX, _SHARE * min(rect.width(), rect.height())))


def draw_off(painter: QPainter, at: QPointF, radius_px: float) -> None:
    """A cross on a disc: it is off its part."""
    painter.setPen(QPen(_CASING, 1.2))
    painter.setBrush(FAILED)
    painter.drawEllipse(at, radius_px, radius_px)
    arm = 0.45 * radius_px
    painter.setPen(QPen(_WHITE, max(1.2, 0.26 * radius_px)))
    rising = QLineF(at - QPointF(arm, -arm), at + QPointF(arm, -arm))
    painter.drawLines([QLineF(at - QPointF(arm, arm), at + QPointF(arm, arm)), rising])
    painter.setBrush(Qt.BrushStyle.NoBrush)


def draw_on(painter: QPainter, at: QPointF, radius_px: float, colour: QColor) -> None:
    """A tick: it lies on its part."""
    painter.setPen(QPen(colour, max(1.4, 0.3 * radius_px)))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    corners = ((-0.7, 0.05), (-0.2, 0.55), (0.75, -0.55))
    painter.drawPolyline(QPolygonF([at + QPointF(x, y) * radius_px for x, y in corners]))


def draw_said(painter: QPainter, at: QPointF, radius_px: float) -> None:
    """A tick on a light disc: a person said that it lies on its part."""
    painter.setPen(QPen(_CASING, 1.2))
    painter.setBrush(_WHITE)
    painter.drawEllipse(at, radius_px, radius_px)
    draw_on(painter, at, 0.8 * radius_px, QColor(20, 90, 40))


def draw_unsure(painter: QPainter, at: QPointF, radius_px: float) -> None:
    """A question mark on a light disc: a person could not tell."""
    painter.save()
    painter.setPen(QPen(_CASING, 1.2))
    painter.setBrush(_WHITE)
    painter.drawEllipse(at, radius_px, radius_px)
    font = painter.font()
    font.setPixelSize(max(1, round(1.7 * radius_px)))
    font.setBold(True)
    painter.setFont(font)
    painter.setPen(QColor(20, 20, 20))
    disc = QRectF(at.x() - radius_px, at.y() - radius_px, 2 * radius_px, 2 * radius_px)
    painter.drawText(disc, Qt.AlignmentFlag.AlignCenter, "?")
    painter.restore()
