"""Part rectangles on a picture: on its part, failed, hidden; told apart without colour, too."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.core.drawing.part_signs import FAILED, draw_off, sign_radius
from app.core.drawing.particles import draw_particles
from app.core.drawing.viewport import Viewport
from app.core.look.theme import faded
from app.core.scenes import Colour
from app.core.scenes.pictured_parts import PartBox, PicturedParts

_CASING = QColor(0, 0, 0, 150)
_PARTICLE_PX, _LEAST_PX, _LARGEST_PX, _RIM_PX = 0.6, 1.6, 3.2, 1.0
"""Of a particle: its radius, in pixels as recorded, then at least, at most, and its dark rim."""
_HALO, _FAINTEST, _LIGHT = 0.6, 0.45, 0.72
_LUMA = np.array([0.299, 0.587, 0.114])
_DASHES, _DOTS = (4.0, 2.5), (1.0, 2.2)


def draw_part_boxes(
    painter: QPainter, boxes: Sequence[PartBox], viewport: Viewport, area: QRectF
) -> None:
    """Solid where on the part, dashed with a cross where failed, dotted where hidden."""
    for box in boxes:
        rect = viewport.rect(QRectF(*box.box))
        if rect.intersects(area):
            _draw_box(painter, box, rect)


def draw_part_particles(
    painter: QPainter, parts: PicturedParts, viewport: Viewport, size: tuple[int, int]
) -> None:
    """All particles of a part in one image; `size`: of the widget, in device-independent pixels."""
    if not len(parts.particles):
        return
    ratio = painter.device().devicePixelRatioF()
    width, height = (round(side * ratio) for side in size)
    points = viewport.to_widget(parts.particles) * ratio
    radius = ratio * min(max(_PARTICLE_PX * viewport.scale, _LEAST_PX), _LARGEST_PX)
    count = len(parts.particles)
    ink = np.tile(_bright(parts.colour), (count, 1))
    dark, halo = np.zeros_like(ink), np.full(count, _HALO, np.float32)
    shades = ((dark, halo, radius + ratio * _RIM_PX), (ink, _seen(parts.weights), radius))
    for colours, weights, reach in shades:
        draw_particles(painter, points, colours, weights, (width, height), reach, ratio)


def _bright(colour: Colour) -> NDArray[np.uint8]:
    """The colour, lightened so far that its dots stand out from dark clothes and their own rim."""
    rgb = np.array(colour, np.float64)
    lightness = float(rgb @ _LUMA) / 255
    share = max(0.0, (_LIGHT - lightness) / (1.0 - lightness)) if lightness < 1 else 0.0
    return np.asarray(rgb + share * (255 - rgb), np.uint8)


def _seen(weights: NDArray[np.float32]) -> NDArray[np.float32]:
    """Weights as shades: even the lightest particle is seen."""
    return np.asarray(_FAINTEST + (1 - _FAINTEST) * weights, np.float32)


def part_box_at(boxes: Sequence[PartBox], at: QPointF, viewport: Viewport) -> PartBox | None:
    """The smallest rectangle under a place of the widget, of the selected person where any is."""
    hits = [one for one in boxes if viewport.rect(QRectF(*one.box)).contains(at)]
    hits = [one for one in hits if one.selected] or hits
    return min(hits, key=lambda one: one.box[2] * one.box[3], default=None)


def said_at(parts: PicturedParts, at: QPointF, viewport: Viewport, track: int) -> str:
    """What is said of the part of a track at a place of the widget; "" where none is there."""
    lines = [line for card in parts.cards if card.track == track for line in card.lines]
    lines = [line for line in lines if viewport.rect(QRectF(*line.box)).contains(at)]
    best = min(lines, key=lambda one: one.box[2] * one.box[3], default=None)
    if best is not None:
        return best.text
    box = part_box_at(parts.boxes, at, viewport)
    return box.text if box is not None and box.track == track else ""


def _draw_box(painter: QPainter, box: PartBox, rect: QRectF) -> None:
    width = 2.6 if box.chosen else 2.0 if box.selected else 1.4
    colour = FAILED if box.failed else QColor(*box.colour)
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
        draw_off(painter, rect.topRight(), sign_radius(rect))
