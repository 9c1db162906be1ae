"""What people drew and said, painted: part rectangles, outlines, arrows, corners."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.drawing.name_places import place_plates
from app.core.drawing.name_plates import draw_name, plate_rect, plate_text
from app.core.drawing.part_signs import draw_said, draw_unsure, sign_radius
from app.core.drawing.viewport import Points, Viewport, path_through
from app.core.look.theme import Theme, faded
from app.core.scenes import Colour
from app.core.scenes.labels import PART_COLOURS, Outline, PartMark

_CASING = QColor(0, 0, 0, 130)
_FILL = 0.16
_GUESSED = 0.5
"""How much is seen of the line round a guess."""
CORNER_PX = 4.5
_TIP_PX = 8.0


@dataclass(frozen=True, slots=True)
class OutlineName:
    """What something that was drawn is called, and where that stands on the widget."""

    rect: QRectF
    text: str
    colour: Colour
    picked: bool


def draw_outlines(
    painter: QPainter, outlines: Sequence[Outline], viewport: Viewport, theme: Theme
) -> None:
    """Polygons and lines with their arrows; the one that is picked with corners."""
    for outline in outlines:
        colour = theme.track(outline.colour) if viewport.upward else QColor(*outline.colour)
        draw_outline(painter, outline, viewport, colour)


def place_outline_names(
    metrics: QFontMetricsF,
    outlines: Sequence[Outline],
    viewport: Viewport,
    area: QRectF,
    taken: Sequence[QRectF] = (),
) -> list[OutlineName]:
    """Where the names of outlines stand: at what they name, on no other and off what is taken."""
    named = [(one, _name_at(viewport.to_widget(one.points), area)) for one in outlines]
    seen = [(one, at) for one, at in named if at is not None and one.name]
    names = [_with_counts(plate_text(metrics, one.name), one.said) for one, _ in seen]
    wanted = [plate_rect(metrics, n, at) for n, (_, at) in zip(names, seen, strict=True)]
    placed = place_plates(wanted, area, taken)
    return [
        OutlineName(rect, name, one.colour, one.picked)
        for (one, _), name, rect in zip(seen, names, placed, strict=True)
    ]


def draw_outline_names(painter: QPainter, names: Sequence[OutlineName], theme: Theme) -> None:
    """The names, which belong above people: counts are read while people walk over a line."""
    for one in names:
        draw_name(painter, one.rect, one.text, QColor(*one.colour), theme, one.picked)


def draw_outline(painter: QPainter, outline: Outline, viewport: Viewport, colour: QColor) -> None:
    """One polygon or line, without its name."""
    points = viewport.to_widget(outline.points)
    path = path_through(points, outline.closed)
    if outline.closed and np.isfinite(points).all():
        painter.fillPath(path, faded(colour, _FILL))
    width = 2.8 if outline.picked else 1.8
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen in (QPen(_CASING, width + 2.0), QPen(colour, width)):
        painter.setPen(pen)
        painter.drawPath(path)
    if len(outline.arrow):
        draw_arrow(painter, viewport.to_widget(outline.arrow), colour)


def draw_corners(painter: QPainter, points: Points, colour: QColor, held: int = -1) -> None:
    """Corners (n, 2) of the widget that can be dragged; the one that is held is larger."""
    painter.setPen(QPen(QColor(20, 20, 20, 220), 1.2))
    painter.setBrush(colour)
    for number, (x, y) in enumerate(points.tolist()):
        radius = CORNER_PX + (2.0 if number == held else 0.0)
        painter.drawEllipse(QPointF(x, y), radius, radius)


def draw_parts(painter: QPainter, parts: Sequence[PartMark], viewport: Viewport) -> None:
    """Rectangles: ticked where said to be on, crossed out where off, with a ? where unsure.

    A first guess is faint. No line is dashed or dotted: that is what the tracker says of a part,
    and both may be drawn over one picture.
    """
    for mark in sorted(parts, key=lambda one: one.chosen):
        _draw_part(painter, mark, viewport.rect(QRectF(*mark.box)))


def part_colour(part: int) -> Colour:
    """Of head, torso and hip-leg."""
    return PART_COLOURS[part % len(PART_COLOURS)]


def _draw_part(painter: QPainter, mark: PartMark, rect: QRectF) -> None:
    colour = QColor(*mark.colour)
    width = 2.8 if mark.chosen else 1.8
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(_CASING if mark.given else faded(_CASING, _GUESSED), width + 2.0))
    painter.drawRect(rect)
    painter.setPen(QPen(colour if mark.given else faded(colour, _GUESSED), width))
    painter.drawRect(rect)
    if mark.given and mark.on_part is False:
        painter.drawLine(rect.topLeft(), rect.bottomRight())
        painter.drawLine(rect.bottomLeft(), rect.topRight())
    if mark.chosen:
        painter.fillRect(rect, faded(colour, 0.14))
    if mark.given and mark.on_part is None:
        draw_unsure(painter, rect.bottomLeft(), sign_radius(rect))
    elif mark.given and mark.on_part and not mark.chosen:
        draw_said(painter, rect.bottomLeft(), sign_radius(rect))


def _with_counts(name: str, said: str) -> str:
    """The name, and behind it what is counted there."""
    return f"{name}: {said}" if said else name


def draw_arrow(painter: QPainter, ends: Points, colour: QColor) -> None:
    """An arrow from the first of two places on the widget, (2, 2), to the second."""
    shaft = QLineF(QPointF(*ends[0]), QPointF(*ends[1]))
    if shaft.length() < 2 * _TIP_PX:
        shaft.setLength(2 * _TIP_PX)
    wings = []
    for turn in (150, -150):
        wing = QLineF(shaft.p2(), shaft.p1())
        wing.setAngle(shaft.angle() + turn)
        wing.setLength(_TIP_PX)
        wings.append(wing)
    for pen in (QPen(_CASING, 4.6), QPen(colour, 2.6)):
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        painter.drawLines([shaft, *wings])


def _name_at(points: Points, area: QRectF) -> QPointF | None:
    """Where a name stands: at the highest point in sight."""
    inside = [QPointF(x, y) for x, y in points.tolist() if x == x and y == y]
    inside = [point for point in inside if area.contains(point)]
    return min(inside, key=lambda point: point.y()) + QPointF(6, -4) if inside else None
