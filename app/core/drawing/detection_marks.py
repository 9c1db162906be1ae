"""Boxes of another program's detector: thin and dashed, below the people that are tracked."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.core.drawing.viewport import Viewport
from app.core.scenes.detections import DETECTION, PicturedDetections

_DASHES = [3.0, 3.0]
_GROUND = QColor(0, 0, 0, 130)


def draw_detections(painter: QPainter, shown: PicturedDetections, viewport: Viewport) -> None:
    """Each box in one colour on a dark line, so that it shows on any ground."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    dashed = QPen(QColor(*DETECTION), 1.2)
    dashed.setDashPattern(_DASHES)
    for box in shown.boxes:
        rect = viewport.rect(QRectF(*box))
        for pen in (QPen(_GROUND, 2.2), dashed):
            painter.setPen(pen)
            painter.drawRect(rect)
