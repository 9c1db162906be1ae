"""Suggested boxes: dashed, with whose they would be above them."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.drawing.name_places import place_plates
from app.core.drawing.name_plates import draw_note, plate_rect
from app.core.drawing.viewport import Viewport
from app.core.look.theme import Theme, faded
from app.core.scenes.suggested_marks import SuggestedMark

_DASHES, _DOTS = [6.0, 4.0], [2.0, 3.0]
_CASING = QColor(0, 0, 0, 150)


def draw_suggested(
    painter: QPainter,
    marks: Sequence[SuggestedMark],
    viewport: Viewport,
    theme: Theme,
    area: QRectF,
) -> None:
    """Found boxes dashed, ghosts dotted; names apart from each other."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    corners, names = [], []
    for mark in marks:
        rect = viewport.rect(QRectF(*mark.box))
        ink = QPen(faded(QColor(*mark.colour), 0.95), 1.8)
        ink.setDashPattern(_DOTS if mark.ghost else _DASHES)
        for pen in (QPen(_CASING, 3.2), ink):
            painter.setPen(pen)
            painter.drawRect(rect)
        if mark.label and area.intersects(rect):
            corners.append(QPointF(rect.left(), rect.top() - 2))
            names.append(mark.label)
    metrics = QFontMetricsF(painter.font())
    wanted = [plate_rect(metrics, *each) for each in zip(names, corners, strict=True)]
    for name, plate in zip(names, place_plates(wanted, area), strict=True):
        draw_note(painter, plate, name, theme)
