"""The truth over pictures and floor: corners of boxes and crosses, so that tracks stay in front."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.drawing.error_signs import draw_signs, error_colour
from app.core.drawing.name_places import Name, column, place_names
from app.core.drawing.name_plates import draw_note, plate_rect
from app.core.drawing.rectangles import coords, covers
from app.core.drawing.viewport import Viewport, polygon
from app.core.look.theme import Theme, faded
from app.core.scenes.ground_truth import FlooredTruth, PicturedTruth, TruthMark
from tracking.scoring import ErrorKind

_HALO = QColor(0, 0, 0, 130)
_ON_PICTURE = QColor(255, 255, 255)
_CORNER, _SIGN_PX = 0.24, 6.0
CROSS_PX = 7.0
MISS_PX = 1.9 * CROSS_PX
"""How far the cross of somebody on the floor reaches, and the sign around who is missed."""
_LOW_PX = 64.0
"""Of boxes lower than this the signs stand outside, and are smaller: people are to be seen."""
_LEAST_SIGN_PX = 3.5


def draw_truth_corners(
    painter: QPainter, truth: PicturedTruth, viewport: Viewport, theme: Theme
) -> None:
    """Corners around everybody of the truth."""
    for person in truth.people:
        colour = _colour(person.wrong, _ON_PICTURE, theme)
        _draw_corners(painter, _around(person, viewport), colour)


def draw_truth_signs(
    painter: QPainter, truth: PicturedTruth, viewport: Viewport, theme: Theme, area: QRectF
) -> None:
    """The ids of the truth below its boxes; signs on misses and false alarms."""
    rects = [_around(person, viewport) for person in truth.people]
    ends = [QPointF(rect.left(), rect.bottom() + 16) for rect in rects]
    for mark in (*truth.people, *truth.alarms):
        if mark.wrong is not None:
            rect = viewport.rect(QRectF(*mark.box))
            reach = min(_SIGN_PX, max(_LEAST_SIGN_PX, _SIGN_PX * rect.height() / _LOW_PX))
            draw_signs(painter, mark.wrong, [_on_top(rect, mark)], reach, theme)
    _draw_ids(painter, truth.people, ends, rects, theme, area)


def _around(person: TruthMark, viewport: Viewport) -> QRectF:
    return viewport.rect(QRectF(*person.box)).adjusted(-2, -2, 2, 2)


def draw_truth_places(
    painter: QPainter, truth: FlooredTruth, viewport: Viewport, theme: Theme
) -> None:
    """A thin dotted trail that ends in a cross for everybody of the truth; unnamed."""
    for person in truth.people:
        points = viewport.to_widget(person.trail)
        colour = _colour(person.wrong, theme.text, theme)
        pen = QPen(faded(colour, 0.75), 1.3)
        pen.setDashPattern([1.5, 2.5])
        painter.setPen(pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPolyline(polygon(points))
        end = QPointF(*points[-1])
        _draw_cross(painter, end, colour, theme)
        if person.wrong is not None:
            draw_signs(painter, person.wrong, [end], MISS_PX, theme)
    for alarm in truth.alarms:
        at = viewport.point(float(alarm.trail[-1, 0]), float(alarm.trail[-1, 1]))
        draw_signs(painter, ErrorKind.FALSE_ALARM, [at], 1.6 * CROSS_PX, theme)


def _colour(wrong: ErrorKind | None, usual: QColor, theme: Theme) -> QColor:
    return usual if wrong is None else error_colour(wrong, theme)


def _on_top(rect: QRectF, mark: TruthMark) -> QPointF:
    """Where a sign stands: misses at the left of the upper edge, false alarms at the right."""
    low = rect.height() < _LOW_PX
    aside = -2.0 if low else 9.0
    x = rect.left() + aside if mark.wrong is ErrorKind.MISS else rect.right() - aside
    return QPointF(x, rect.top() - 2 if low else rect.top() + 10)


def _draw_corners(painter: QPainter, rect: QRectF, colour: QColor) -> None:
    """The four corners of a box, on a dark halo."""
    arm = max(4.0, _CORNER * min(rect.width(), rect.height()))
    lines = []
    for x, way in ((rect.left(), 1), (rect.right(), -1)):
        for y, down in ((rect.top(), 1), (rect.bottom(), -1)):
            lines += [QLineF(x, y, x + way * arm, y), QLineF(x, y, x, y + down * arm)]
    for shade, width in ((_HALO, 4.4), (colour, 2.0)):
        painter.setPen(QPen(shade, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.SquareCap))
        painter.drawLines(lines)


def _draw_cross(painter: QPainter, at: QPointF, colour: QColor, theme: Theme) -> None:
    across, down = QPointF(CROSS_PX, 0), QPointF(0, CROSS_PX)
    lines = [QLineF(at - across, at + across), QLineF(at - down, at + down)]
    for shade, width in ((theme.sunken, 4.0), (colour, 1.8)):
        painter.setPen(QPen(shade, width))
        painter.drawLines(lines)


def _draw_ids(
    painter: QPainter,
    people: Sequence[TruthMark],
    corners: Sequence[QPointF],
    bodies: Sequence[QRectF],
    theme: Theme,
    area: QRectF,
) -> None:
    """The ids of those in sight, lower left corners given, none on another."""
    metrics = QFontMetricsF(painter.font())
    plates = [
        IdPlate(person.label, plate_rect(metrics, person.label, corner), body, person.wrong)
        for person, corner, body in zip(people, corners, bodies, strict=True)
        if area.contains(corner)
    ]
    for label, rect in shown_ids(plates, area):
        draw_note(painter, rect, label, theme)


@dataclass(frozen=True, slots=True)
class IdPlate:
    """Where somebody's id would stand, whose body it must not be taken for, what is wrong."""

    label: str
    rect: QRectF
    body: QRectF
    wrong: ErrorKind | None


def shown_ids(plates: Sequence[IdPlate], area: QRectF) -> list[tuple[str, QRectF]]:
    """Which ids are shown, and where.

    Who is missed is always named. The others are where their id hides neither a body nor an id:
    far away people stand close together.
    """
    ordered = sorted(plates, key=lambda one: one.wrong is None)
    names = []
    for one in ordered:
        if one.wrong is not None:
            names.append(column(one.rect, area))
        else:
            side = coords([one.rect])[None]
            bodies = coords([other.body for other in plates if other is not one])
            names.append(Name(side, covers(side, bodies)))
    placed = zip(ordered, place_names(names, area), strict=True)
    return [(one.label, stands.rect) for one, stands in placed if stands is not None]
