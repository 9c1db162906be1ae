"""The people of another session, thin and dashed, so that one's own stay in front."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.drawing.name_places import place_plates
from app.core.drawing.name_plates import draw_note, plate_rect
from app.core.drawing.viewport import Viewport, polygon
from app.core.look.theme import Theme, faded
from app.core.scenes.other_people import OtherMark, OtherPlace

_DASHES = [4.0, 3.0]
_HALO = QColor(0, 0, 0, 120)


def draw_other_boxes(
    painter: QPainter,
    people: Sequence[OtherMark],
    viewport: Viewport,
    theme: Theme,
    area: QRectF,
) -> None:
    """Boxes with their ids below them, apart from each other."""
    ends = []
    for person in people:
        rect = viewport.rect(QRectF(*person.box)).adjusted(-3, -3, 3, 3)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(_HALO, 3.0))
        painter.drawRect(rect)
        painter.setPen(_dashed(QColor(*person.colour)))
        painter.drawRect(rect)
        ends.append(QPointF(rect.right() - 12, rect.bottom() + 14))
    _draw_ids(painter, [person.label for person in people], ends, theme, area)


def draw_other_places(
    painter: QPainter,
    people: Sequence[OtherPlace],
    viewport: Viewport,
    theme: Theme,
    area: QRectF,
) -> None:
    """Trails that end in a ring with the id beside it."""
    ends = []
    for person in people:
        points = viewport.to_widget(person.trail)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(_dashed(theme.track(person.colour)))
        painter.drawPolyline(polygon(points))
        end = QPointF(*points[-1])
        painter.drawEllipse(end, 15, 15)
        ends.append(end + QPointF(-30, 28))
    _draw_ids(painter, [person.label for person in people], ends, theme, area)


def _draw_ids(
    painter: QPainter, labels: Sequence[str], corners: Sequence[QPointF], theme: Theme, area: QRectF
) -> None:
    """The ids of those in sight, lower left corners given, none on another."""
    metrics = QFontMetricsF(painter.font())
    given = zip(labels, corners, strict=True)
    seen = [(label, corner) for label, corner in given if area.contains(corner)]
    wanted = [plate_rect(metrics, label, corner) for label, corner in seen]
    for (label, _), plate in zip(seen, place_plates(wanted, area), strict=True):
        draw_note(painter, plate, label, theme)


def _dashed(colour: QColor) -> QPen:
    pen = QPen(faded(colour, 0.95), 1.4)
    pen.setDashPattern(_DASHES)
    return pen
