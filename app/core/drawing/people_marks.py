"""People drawn on a picture: boxes and trails."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF

from app.core.drawing.viewport import Points, Viewport, polygon
from app.core.look.theme import faded
from app.core.scenes import Colour, PersonMark, PreviewTrail

_CORNER = 4.0
_DIAMOND_PX = 5.0
_AGES = 6  # steps in which a trail fades
_MOST_POINTS = 31  # of a trail


def draw_people(painter: QPainter, people: Sequence[PersonMark], viewport: Viewport) -> None:
    """Draw trails below boxes."""
    for person in people:
        points = viewport.to_widget(person.trail)
        width = 3.0 if person.selected else 2.2
        draw_fading_trail(painter, points, QColor(*person.colour), width, casing=True)
    for person in people:
        _draw_box(painter, person, viewport.rect(QRectF(*person.box)))


def draw_fading_trail(
    painter: QPainter, points: Points, colour: QColor, width: float, casing: bool = False
) -> None:
    """A line through widget points (n, 2), oldest first and faintest.

    Args:
        casing: a soft dark edge, for trails on a picture.
    """
    lines = _lines(points[np.isfinite(points).all(axis=1)])
    edges = [age * len(lines) // _AGES for age in range(_AGES + 1)]
    casings = _fading_pens((0, 0, 0), 70, width + 2.0) if casing else ()
    inks = _fading_pens((colour.red(), colour.green(), colour.blue()), 255, width)
    for pens in (casings, inks):
        for pen, (start, stop) in zip(pens, pairwise(edges), strict=False):
            painter.setPen(pen)
            painter.drawLines(lines[start:stop])


@lru_cache(maxsize=256)
def _fading_pens(colour: Colour, alpha: int, width: float) -> tuple[QPen, ...]:
    """A pen for each age of a trail, the faintest first."""
    pens = [
        QPen(faded(QColor(*colour, alpha), 0.08 + 0.82 * (age + 1) / _AGES), width)
        for age in range(_AGES)
    ]
    for pen in pens:
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    return tuple(pens)


def _lines(points: Points) -> list[QLineF]:
    """Lines through at most so many of the points, the newest among them.

    Qt paints a translucent line after the other eight times as fast as the same as a polyline.
    """
    step = -(-len(points) // _MOST_POINTS) or 1
    kept = points[::-step][::-1]
    return [QLineF(*ends) for ends in np.hstack((kept[:-1], kept[1:])).tolist()]


def draw_preview(
    painter: QPainter,
    trails: Sequence[PreviewTrail],
    viewport: Viewport,
    shade: Callable[[Colour], QColor] = lambda colour: QColor(*colour),
) -> None:
    """Trails before an edit, wide and dashed, below those after it, thin and solid.

    Both often run over the same points, as in a swap, so the lower ones are wider. `shade` gives
    how a person's colour is shown on what is drawn upon.
    """
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for trail in sorted(trails, key=lambda one: one.after):
        painter.setPen(preview_pen(shade(trail.colour), trail.after))
        painter.drawPolyline(polygon(viewport.to_widget(trail.points)))


def draw_ghosts(painter: QPainter, people: Sequence[PersonMark], viewport: Viewport) -> None:
    """Where people are before an edit that moves them or takes them out: faint, with a cross."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for person in people:
        rect = viewport.rect(QRectF(*person.box))
        for colour, width in (((0, 0, 0), 3.2), (person.colour, 1.6)):
            pen = QPen(faded(QColor(*colour), 0.55), width)
            pen.setDashPattern([5.0 / width, 4.0 / width])
            painter.setPen(pen)
            painter.drawRoundedRect(rect, _CORNER, _CORNER)
            painter.drawLine(rect.topLeft(), rect.bottomRight())
            painter.drawLine(rect.topRight(), rect.bottomLeft())


def draw_cross(painter: QPainter, at: QPointF, area: QRectF) -> None:
    """Thin lines through the cursor over the whole picture, to see a box's sides before it."""
    for colour, width in ((QColor(0, 0, 0, 120), 3.0), (QColor(255, 255, 255, 210), 1.0)):
        painter.setPen(QPen(colour, width))
        painter.drawLine(QPointF(area.left(), at.y()), QPointF(area.right(), at.y()))
        painter.drawLine(QPointF(at.x(), area.top()), QPointF(at.x(), area.bottom()))


def preview_pen(colour: QColor, after: bool) -> QPen:
    """The pen of a trail as it would be after an edit, or as it is before."""
    if after:
        return QPen(colour, 2.6)
    pen = QPen(faded(colour, 0.6), 8.0)
    pen.setDashPattern([0.9, 0.6])
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    return pen


def _draw_box(painter: QPainter, person: PersonMark, rect: QRectF) -> None:
    colour = QColor(*person.colour)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if person.selected:
        for width, opacity in ((13.0, 0.12), (9.0, 0.18), (6.0, 0.28)):
            painter.setPen(QPen(faded(colour, opacity), width))
            painter.drawRoundedRect(rect, _CORNER, _CORNER)
    width = 2.6 if person.selected else 1.6
    painter.setPen(QPen(colour.darker(320), width + 1.4))  # opaque: translucent takes five times
    painter.drawRoundedRect(rect, _CORNER, _CORNER)
    pen = QPen(colour, width)
    if person.occluded:
        pen.setDashPattern([1.0, 2.0])
    elif person.predicted:
        pen.setDashPattern([4.0, 3.0])
    painter.setPen(pen)
    painter.drawRoundedRect(rect, _CORNER, _CORNER)
    if person.keyframe:
        _draw_diamond(painter, QPointF(rect.center().x(), rect.bottom()), colour)


def _draw_diamond(painter: QPainter, at: QPointF, colour: QColor) -> None:
    """The mark of a keyframe, as on the timeline."""
    reach = _DIAMOND_PX
    corners = [QPointF(0, -reach), QPointF(reach, 0), QPointF(0, reach), QPointF(-reach, 0)]
    painter.setPen(QPen(colour.darker(320), 1.4))
    painter.setBrush(QColor(255, 255, 255))
    painter.drawPolygon(QPolygonF([at + corner for corner in corners]))
    painter.setBrush(Qt.BrushStyle.NoBrush)
