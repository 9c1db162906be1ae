"""Part rectangles on a picture: on its part, failed, hidden; told apart without colour, too."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.presenters.parts.parts_scene import PartBox, PicturedParts
from app.views.look.theme import faded
from app.views.pictures.name_plates import draw_plate, place_plates, plate_rect
from app.views.pictures.particles import draw_particles
from app.views.pictures.viewport import Viewport

_CASING = QColor(0, 0, 0, 150)
_FAILED = QColor(255, 77, 77)
_SIGN_PX = 7.0
_PARTICLE_PX = 1.5
_DASHES, _DOTS = (4.0, 2.5), (1.0, 2.2)


def draw_part_boxes(
    painter: QPainter,
    boxes: Sequence[PartBox],
    viewport: Viewport,
    area: QRectF,
    person: QRectF | None = None,
) -> None:
    """Solid where on the part, dashed with a cross where failed, dotted where hidden.

    What is said of the selected person's parts stands beside them, and beside the `person`'s box.
    """
    for box in boxes:
        rect = viewport.rect(QRectF(*box.box))
        if rect.intersects(area):
            _draw_box(painter, box, rect)
    chosen = [box for box in boxes if box.selected]
    rects = [viewport.rect(QRectF(*box.box)) for box in chosen]
    _draw_words(painter, chosen, rects, [*rects, person] if person is not None else rects, area)


def draw_part_particles(
    painter: QPainter, parts: PicturedParts, viewport: Viewport, size: tuple[int, int]
) -> None:
    """All particles of a part in one image; `size`: of the widget, in device-independent pixels."""
    if not len(parts.particles):
        return
    ratio = painter.device().devicePixelRatioF()
    colours = np.tile(np.array(parts.colour, np.uint8), (len(parts.particles), 1))
    width, height = (round(side * ratio) for side in size)
    points = viewport.to_widget(parts.particles) * ratio
    weights = parts.weights
    draw_particles(painter, points, colours, weights, (width, height), _PARTICLE_PX * ratio, ratio)


def part_box_at(boxes: Sequence[PartBox], at: QPointF, viewport: Viewport) -> PartBox | None:
    """The smallest rectangle under a place of the widget, of the selected person where any is."""
    hits = [one for one in boxes if viewport.rect(QRectF(*one.box)).contains(at)]
    hits = [one for one in hits if one.selected] or hits
    return min(hits, key=lambda one: one.box[2] * one.box[3], default=None)


def _draw_box(painter: QPainter, box: PartBox, rect: QRectF) -> None:
    width = 2.6 if box.chosen else 2.0 if box.selected else 1.4
    colour = _FAILED if box.failed else QColor(*box.colour)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(_CASING, width + 1.6))
    painter.drawRect(rect)
    pen = QPen(faded(colour, 0.8) if box.occluded else colour, width)
    if box.failed or box.occluded:
        pen.setDashPattern([*(_DASHES if box.failed else _DOTS)])
    painter.setPen(pen)
    painter.drawRect(rect)
    if box.chosen:
        painter.fillRect(rect, faded(colour, 0.16))
    if box.failed:
        _draw_sign(painter, rect.topRight())


def _draw_sign(painter: QPainter, at: QPointF) -> None:
    """A cross on a disc: it failed."""
    painter.setPen(QPen(_CASING, 1.2))
    painter.setBrush(_FAILED)
    painter.drawEllipse(at, _SIGN_PX, _SIGN_PX)
    arm = 0.45 * _SIGN_PX
    painter.setPen(QPen(QColor(255, 255, 255), 1.8))
    painter.drawLines(
        [
            QLineF(at - QPointF(arm, arm), at + QPointF(arm, arm)),
            QLineF(at - QPointF(arm, -arm), at + QPointF(arm, -arm)),
        ]
    )
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _draw_words(
    painter: QPainter,
    boxes: Sequence[PartBox],
    rects: Sequence[QRectF],
    around: Sequence[QRectF],
    area: QRectF,
) -> None:
    """Beside everything `around`, so that nothing of the person is hidden."""
    metrics = QFontMetricsF(painter.font())
    plates = [plate_rect(metrics, one.text, QPointF()) for one in boxes]
    right = max((rect.right() for rect in around), default=0.0) + _SIGN_PX + 5
    left = min((rect.left() for rect in around), default=0.0) - _SIGN_PX - 5
    fits = right + max((one.width() for one in plates), default=0.0) <= area.right()
    for rect, plate in zip(rects, plates, strict=True):
        plate.moveTopLeft(QPointF(right if fits else left - plate.width(), rect.top()))
    for box, rect in zip(boxes, place_plates(plates, area), strict=True):
        colour = _FAILED if box.failed else QColor(*box.colour)
        draw_plate(painter, rect, box.text, colour, box.chosen)
