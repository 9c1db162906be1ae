"""The people of another session, thin and dashed, so that one's own stay in front."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.presenters.comparing.agreement_scene import OtherMark, OtherPlace
from app.views.look.theme import Theme, faded
from app.views.pictures.name_plates import draw_note, plate_rect
from app.views.pictures.viewport import Viewport, polygon

_DASHES = [4.0, 3.0]
_HALO = QColor(0, 0, 0, 120)


def draw_other_boxes(
    painter: QPainter, people: Sequence[OtherMark], viewport: Viewport, theme: Theme
) -> None:
    """Boxes with their ids below them."""
    metrics = QFontMetricsF(painter.font())
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for person in people:
        rect = viewport.rect(QRectF(*person.box)).adjusted(-3, -3, 3, 3)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(_HALO, 3.0))
        painter.drawRect(rect)
        painter.setPen(_dashed(QColor(*person.colour)))
        painter.drawRect(rect)
        plate = plate_rect(metrics, person.label, QPointF(rect.right() - 12, rect.bottom() + 14))
        draw_note(painter, plate, person.label, theme)


def draw_other_places(
    painter: QPainter, people: Sequence[OtherPlace], viewport: Viewport, theme: Theme
) -> None:
    """Trails that end in a ring with the id beside it."""
    metrics = QFontMetricsF(painter.font())
    for person in people:
        points = viewport.to_widget(person.trail)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(_dashed(theme.track(person.colour)))
        painter.drawPolyline(polygon(points))
        end = QPointF(*points[-1])
        painter.drawEllipse(end, 15, 15)
        plate = plate_rect(metrics, person.label, end + QPointF(-30, 28))
        draw_note(painter, plate, person.label, theme)


def _dashed(colour: QColor) -> QPen:
    pen = QPen(faded(colour, 0.95), 1.4)
    pen.setDashPattern(_DASHES)
    return pen
