"""People drawn on a picture: boxes, trails, name plates."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.presenters.scenes import PersonMark
from app.views.labels import draw_plate, place_plates, plate_rect
from app.views.theme import faded
from app.views.viewport import Points, Viewport, polygon

_CORNER = 4.0
_AGES = 8  # steps in which a trail fades


def draw_people(
    painter: QPainter, people: Sequence[PersonMark], viewport: Viewport, area: QRectF
) -> None:
    """Draw trails below boxes below plates; the selected person's plate keeps its place."""
    for person in people:
        points = viewport.to_widget(person.trail)
        draw_fading_trail(painter, points, QColor(*person.colour), 3.0 if person.selected else 2.0)
    for person in people:
        _draw_box(painter, person, viewport.rect(QRectF(*person.box)))
    ordered = sorted(people, key=lambda person: not person.selected)
    metrics = QFontMetricsF(painter.font())
    wanted = [
        plate_rect(metrics, one.label, viewport.point(one.box[0], one.box[1]) + QPointF(-1, -4))
        for one in ordered
    ]
    placed = list(zip(ordered, place_plates(wanted, area), strict=True))
    for person, rect in reversed(placed):
        draw_plate(painter, rect, person.label, QColor(*person.colour), person.selected)


def draw_fading_trail(painter: QPainter, points: Points, colour: QColor, width: float) -> None:
    """A line through widget points (n, 2), oldest first and faintest."""
    finite = points[np.isfinite(points).all(axis=1)]
    if len(finite) < 2:
        return
    painter.setBrush(Qt.BrushStyle.NoBrush)
    cuts = np.unique(np.linspace(0, len(finite) - 1, _AGES + 1).astype(int))
    for start, stop in pairwise(cuts.tolist()):
        age = stop / (len(finite) - 1)
        pen = QPen(faded(colour, 0.08 + 0.82 * age), width)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        painter.setPen(pen)
        painter.drawPolyline(polygon(finite[start : stop + 1]))


def _draw_box(painter: QPainter, person: PersonMark, rect: QRectF) -> None:
    colour = QColor(*person.colour)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if person.selected:
        for width, opacity in ((13.0, 0.12), (9.0, 0.18), (6.0, 0.28)):
            painter.setPen(QPen(faded(colour, opacity), width))
            painter.drawRoundedRect(rect, _CORNER, _CORNER)
    width = 2.6 if person.selected else 1.6
    painter.setPen(QPen(QColor(0, 0, 0, 110), width + 1.6))
    painter.drawRoundedRect(rect, _CORNER, _CORNER)
    pen = QPen(colour, width)
    if person.predicted:
        pen.setDashPattern([4.0, 3.0])
    painter.setPen(pen)
    painter.drawRoundedRect(rect, _CORNER, _CORNER)
