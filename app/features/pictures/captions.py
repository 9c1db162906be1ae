"""What stands low down in a camera's picture: its name, a message, what the colours mean."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QFontMetricsF, QPainter

from app.core.drawing.legend import draw_legend, legend_size
from app.core.drawing.name_plates import draw_note, note_size
from app.core.drawing.rectangles import above
from app.core.look.theme import Theme
from app.core.scenes import LegendEntry

_EDGE_PX, _GAP_PX = 8.0, 4.0


@dataclass(frozen=True, slots=True)
class Captions:
    """Where the three stand; a rectangle is empty where there is nothing to say or no room.

    Attributes:
        name: of the camera, at the right. message: in the middle, above the others where they meet.
        legend: at the left, or at the top where it hides nobody there; a picture too low or too
            narrow for all three has none.
    """

    name: QRectF
    message: QRectF
    legend: QRectF

    @property
    def taken(self) -> list[QRectF]:
        """Where they stand, for what must not lie on them."""
        return [one for one in (self.name, self.message, self.legend) if not one.isEmpty()]


def lay_out(
    metrics: QFontMetricsF,
    area: QRectF,
    name: str,
    message: str,
    legend: Sequence[LegendEntry],
    people: Sequence[QRectF] = (),
    reserved: Sequence[QRectF] = (),
) -> Captions:
    """Low down, where heads are seldom, and none on another.

    people: their boxes, of which the legend hides as little as can be. reserved: where other words
        stand, which it never hides.
    """
    room = area.adjusted(_EDGE_PX, _EDGE_PX, -_EDGE_PX, -_EDGE_PX)
    side = QRectF(QPointF(), note_size(metrics, name, room.width()))
    side.moveBottomRight(room.bottomRight())
    told = QRectF(QPointF(), legend_size(metrics, legend))
    told.moveBottomLeft(room.bottomLeft())
    told = above(told, [side], _GAP_PX)
    said = QRectF(QPointF(), note_size(metrics, message, room.width()))
    said.moveCenter(QPointF(room.center().x(), 0))
    said.moveBottom(room.bottom())
    with_legend = above(said, [side, told], _GAP_PX)
    crowded = any(map(told.intersects, reserved))
    if crowded or min(told.top(), with_legend.top()) < room.top() or told.right() > room.right():
        return Captions(side, above(said, [side], _GAP_PX), QRectF())
    return Captions(side, with_legend, _clear(told, room, [side, with_legend, *reserved], people))


def _clear(
    plate: QRectF, room: QRectF, words: Sequence[QRectF], people: Sequence[QRectF]
) -> QRectF:
    """The place of a plate, where it is or at the top, that hides the least of people."""
    left, right = QRectF(plate), QRectF(plate)
    left.moveTopLeft(room.topLeft())
    right.moveTopRight(room.topRight())
    places = [plate, *(one for one in (left, right) if not any(map(one.intersects, words)))]
    return min(places, key=lambda place: sum(_area(place.intersected(one)) for one in people))


def _area(rect: QRectF) -> float:
    return rect.width() * rect.height()


def draw_captions(
    painter: QPainter,
    captions: Captions,
    name: str,
    message: str,
    legend: Sequence[LegendEntry],
    theme: Theme,
) -> None:
    """Draw what was laid out for the same words in the same font."""
    draw_note(painter, captions.name, name, theme)
    if not captions.legend.isEmpty():
        draw_legend(painter, legend, captions.legend.bottomLeft(), theme)
    if not captions.message.isEmpty():
        draw_note(painter, captions.message, message, theme)
