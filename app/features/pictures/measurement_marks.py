"""Black dots where people were measured on the floor."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QPointF, QSize
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from app.core.drawing.viewport import Points
from app.core.look.theme import Theme

_SIDE_PX = 10


def draw_measured(painter: QPainter, points: Points, theme: Theme) -> None:
    """A dot at each of some places (n, 2) of the widget."""
    device = painter.device()
    ratio = device.devicePixelRatioF() if device is not None else 1.0
    dot = _drawn(theme.measured.rgba(), theme.measured_rim.rgba(), ratio)
    half = QPointF(_SIDE_PX / 2, _SIDE_PX / 2)
    for x, y in points.tolist():
        painter.drawImage(QPointF(x, y) - half, dot)


@lru_cache(maxsize=8)
def _drawn(fill: int, rim: int, ratio: float) -> QImage:
    """A dot drawn once: a picture takes a twentieth of an ellipse's time."""
    dot = QImage(QSize(_SIDE_PX, _SIDE_PX) * ratio, QImage.Format.Format_ARGB32_Premultiplied)
    dot.setDevicePixelRatio(ratio)
    dot.fill(0)
    painter = QPainter(dot)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor.fromRgba(rim), 1.2))
    painter.setBrush(QColor.fromRgba(fill))
    painter.drawEllipse(QPointF(_SIDE_PX / 2, _SIDE_PX / 2), 3.2, 3.2)
    painter.end()
    return dot
