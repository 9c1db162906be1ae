"""The truth over pictures and floor: corners of boxes and crosses, so that tracks stay in front."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.presenters.scoring.score_scene import FlooredTruth, PicturedTruth, TruthMark, TruthPlace
from app.views.look.theme import Theme, faded
from app.views.pictures.name_plates import draw_note, place_plates, plate_rect
from app.views.pictures.viewport import Viewport, polygon
from app.views.scoring.error_signs import draw_signs, error_colour
from tracking.scoring import ErrorKind

_HALO = QColor(0, 0, 0, 130)
_ON_PICTURE = QColor(255, 255, 255)
_CORNER, _SIGN_PX, _CROSS_PX = 0.24, 6.0, 7.0


def draw_truth_boxes(
    painter: QPainter, truth: PicturedTruth, viewport: Viewport, theme: Theme, area: QRectF
) -> None:
    """Corners around everybody of the truth, their ids below; signs on misses and false alarms."""
    ends = []
    for person in truth.people:
        rect = viewport.rect(QRectF(*person.box)).adjusted(-2, -2, 2, 2)
        _draw_corners(painter, rect, _colour(person.wrong, _ON_PICTURE, theme))
        ends.append(QPointF(rect.left(), rect.bottom() + 16))
    for mark in (*truth.people, *truth.alarms):
        if mark.wrong is not None:
            rect = viewport.rect(QRectF(*mark.box))
            draw_signs(painter, mark.wrong, [_on_top(rect, mark)], _SIGN_PX, theme)
    _draw_ids(painter, [one.label for one in truth.people], ends, theme, area)


def draw_truth_places(
    painter: QPainter, truth: FlooredTruth, viewport: Viewport, theme: Theme, area: QRectF
) -> None:
    """A thin dotted trail that ends in a cross for everybody of the truth."""
    ends = []
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
            draw_signs(painter, person.wrong, [end], 1.9 * _CROSS_PX, theme)
        ends.append(end + QPointF(10, 24))
    for alarm in truth.alarms:
        at = viewport.point(float(alarm.trail[-1, 0]), float(alarm.trail[-1, 1]))
        draw_signs(painter, ErrorKind.FALSE_ALARM, [at], 1.6 * _CROSS_PX, theme)
    _draw_ids(painter, [one.label for one in truth.people], ends, theme, area)


def _colour(wrong: ErrorKind | None, usual: QColor, theme: Theme) -> QColor:
    return usual if wrong is None else error_colour(wrong, theme)


def _on_top(rect: QRectF, mark: TruthMark | TruthPlace) -> QPointF:
    """Where a sign stands: misses at the left of the upper edge, false alarms at the right."""
    x = rect.left() + 9 if mark.wrong is ErrorKind.MISS else rect.right() - 9
    return QPointF(x, rect.top() + 10)


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
    across, down = QPointF(_CROSS_PX, 0), QPointF(0, _CROSS_PX)
    lines = [QLineF(at - across, at + across), QLineF(at - down, at + down)]
    for shade, width in ((theme.sunken, 4.0), (colour, 1.8)):
        painter.setPen(QPen(shade, width))
        painter.drawLines(lines)


def _draw_ids(
    painter: QPainter, labels: Sequence[str], corners: Sequence[QPointF], theme: Theme, area: QRectF
) -> None:
    """The ids of those in sight, lower left corners given, none on another."""
    metrics = QFontMetricsF(painter.font())
    seen = [each for each in zip(labels, corners, strict=True) if area.contains(each[1])]
    wanted = [plate_rect(metrics, label, corner) for label, corner in seen]
    for (label, _), plate in zip(seen, place_plates(wanted, area), strict=True):
        draw_note(painter, plate, label, theme)
