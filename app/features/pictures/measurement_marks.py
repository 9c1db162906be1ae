"""Black dots where people were measured on the floor."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QPainter, QPen, QPixmap, QPixmapCache

from app.core.drawing.viewport import Points
from app.core.look.theme import Theme

_SIDE_PX = 10


def draw_measured(painter: QPainter, points: Points, theme: Theme) -> None:
    """A dot at each of some places (n, 2) of the widget."""
    device = painter.device()
    dot = _drawn(theme, device.devicePixelRatioF() if device is not None else 1.0)
    half = QPointF(_SIDE_PX / 2, _SIDE_PX / 2)
    for x, y in points.tolist():
        painter.drawPixmap(QPointF(x, y) - half, dot)


def _drawn(theme: Theme, ratio: float) -> QPixmap:
    """A dot drawn once: a pixmap takes a twentieth of an ellipse's time."""
    key, kept = f"measured {theme.name} {ratio}", QPixmap()
    if QPixmapCache.find(key, kept):
        return kept
    dot = QPixmap(QSize(_SIDE_PX, _SIDE_PX) * ratio)
    dot.setDevicePixelRatio(ratio)
    dot.fill(Qt.GlobalColor.transparent)
    painter = QPainter(dot)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(theme.measured_rim, 1.2))
    painter.setBrush(theme.measured)
    painter.drawEllipse(QPointF(_SIDE_PX / 2, _SIDE_PX / 2), 3.2, 3.2)
    painter.end()
    QPixmapCache.insert(key, dot)
    return dot
