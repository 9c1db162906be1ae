"""People as seen from above: a ring each, and an arrow the way they walk."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF, QRadialGradient

from app.core.drawing.viewport import Viewport
from app.core.look.theme import Theme, faded
from app.core.scenes import FloorPerson

_ARROW_S = 0.8  # an arrow shows where somebody is after this time
_LONGEST_ARROW_PX = 70.0
_STANDING_M_S = 0.05
_GLOW_PX = 9.0
_CASING_PX = 3.0
"""By so much wider is the ground under a ring: particles have its very colour."""
_DASHES = (2.8, 2.2)  # in widths of the ring


def draw_floor_person(
    painter: QPainter, person: FloorPerson, viewport: Viewport, radius: float, theme: Theme
) -> None:
    """A ring, dashed where the person was not seen, and an arrow; radius in pixels."""
    at, colour = viewport.point(*person.position), theme.track(person.colour)
    if person.selected:
        _draw_glow(painter, at, radius, colour)
    width = 3.0 if person.selected else 1.8
    pen = QPen(colour, width)
    if person.predicted:
        pen.setDashPattern(_DASHES)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)  # square ones would close the gaps
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for one in (QPen(theme.sunken, width + _CASING_PX), pen):
        painter.setPen(one)
        painter.drawEllipse(at, radius, radius)
    _draw_arrow(painter, person, at, radius, viewport, colour)


def _draw_glow(painter: QPainter, at: QPointF, radius: float, colour: QColor) -> None:
    reach = radius + _GLOW_PX
    glow = QRadialGradient(at, reach)
    glow.setColorAt(max(radius - _GLOW_PX, 0) / reach, faded(colour, 0.0))
    glow.setColorAt(radius / reach, faded(colour, 0.55))
    glow.setColorAt(1.0, faded(colour, 0.0))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(glow)
    painter.drawEllipse(at, reach, reach)


def draw_floor_ghost(
    painter: QPainter, person: FloorPerson, viewport: Viewport, radius: float, theme: Theme
) -> None:
    """Where somebody stands before an edit that moves them or takes them out."""
    at, reach = viewport.point(*person.position), radius * 0.7
    pen = QPen(faded(theme.track(person.colour), 0.7), 1.6)
    pen.setDashPattern([3.0, 2.5])
    painter.setPen(pen)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawEllipse(at, radius, radius)
    for way in (QPointF(reach, reach), QPointF(reach, -reach)):
        painter.drawLine(at - way, at + way)


def _draw_arrow(
    painter: QPainter,
    person: FloorPerson,
    at: QPointF,
    radius: float,
    viewport: Viewport,
    colour: QColor,
) -> None:
    """From the ring outwards, the way the person walks; longer where faster."""
    if not walks(person):
        return
    speed = float(np.hypot(*person.velocity))
    along = QPointF(person.velocity[0] / speed, -person.velocity[1] / speed)
    length = max(10.0, min(speed * _ARROW_S * viewport.scale, _LONGEST_ARROW_PX))
    draw_arrow(
        painter,
        at + along * radius,
        at + along * (radius + length),
        colour,
        2.2 if person.selected else 1.8,
    )


def walks(person: FloorPerson) -> bool:
    """Whether somebody has an arrow."""
    return float(np.hypot(*person.velocity)) > _STANDING_M_S


def draw_arrow(
    painter: QPainter, start: QPointF, tip: QPointF, colour: QColor, width: float
) -> None:
    """A line with a filled head."""
    along = (tip - start) / float(np.hypot(*(tip - start).toTuple()))
    across, neck = QPointF(-along.y(), along.x()), tip - along * 7.0
    painter.setPen(QPen(colour, width))
    painter.drawLine(start, neck)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colour)
    painter.drawPolygon(QPolygonF([tip, neck + across * 4.0, neck - across * 4.0]))
