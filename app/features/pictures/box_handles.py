"""The handles of a box that can be moved and resized: where they are, what dragging them does."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen

from tracking.tracks import Box

Handle = tuple[int, int]
"""Which side across and along: -1 left or top, 1 right or bottom, 0 neither; (0, 0): the inside."""

INSIDE: Handle = (0, 0)
_SIDE_PX = 8.0
_REACH_PX = 9.0
_BORDER_PX = 2.0
_CORNERS: tuple[Handle, ...] = ((-1, -1), (1, -1), (1, 1), (-1, 1))
_EDGES: tuple[Handle, ...] = ((0, -1), (1, 0), (0, 1), (-1, 0))
_ROOM_FOR_EDGES_PX = 44.0


@dataclass(frozen=True, slots=True)
class Grip:
    """A box held at one of its handles.

    Attributes:
        handle: which. box: as it was, in the picture's pixels. at: where it was taken hold of.
    """

    handle: Handle
    box: Box
    at: QPointF

    def moved_to(self, to: QPointF) -> Box:
        """The box with the handle dragged there; dragged over the other side it turns round."""
        across, along = to.x() - self.at.x(), to.y() - self.at.y()
        left, top, width, height = self.box
        if self.handle == INSIDE:
            return left + across, top + along, width, height
        right, bottom = left + width, top + height
        left, right = _dragged(left, right, self.handle[0], across)
        top, bottom = _dragged(top, bottom, self.handle[1], along)
        return left, top, right - left, bottom - top


def handle_at(rect: QRectF, at: QPointF) -> Handle | None:
    """The handle of a box, given in the widget, at a place of it; None beside the box.

    All of a small box but its border moves it: its handles stand outside.
    """
    if not _is_roomy(rect) and _within(rect).contains(at):
        return INSIDE
    near = [(QLineF(_place(rect, handle), at).length(), handle) for handle in handles_of(rect)]
    distance, nearest = min(near)
    reach = min(_REACH_PX, max(rect.width(), rect.height()) / 3)
    if distance <= reach:
        return nearest
    return INSIDE if rect.contains(at) else None


def handles_of(rect: QRectF) -> tuple[Handle, ...]:
    """The corners, and the middles of the sides where there is room for them."""
    return (*_CORNERS, *_EDGES) if _is_roomy(rect) else _CORNERS


def cursor_of(handle: Handle) -> Qt.CursorShape:
    """The arrows that say which way a handle goes."""
    shape = Qt.CursorShape
    if handle == INSIDE:
        return shape.SizeAllCursor
    if 0 in handle:
        return shape.SizeHorCursor if handle[0] else shape.SizeVerCursor
    return shape.SizeFDiagCursor if handle[0] == handle[1] else shape.SizeBDiagCursor


def draw_handles(painter: QPainter, rect: QRectF, colour: QColor) -> None:
    """Small squares that can be seen on any picture."""
    painter.setPen(QPen(colour.darker(320), 1.4))
    painter.setBrush(QColor(255, 255, 255))
    for handle in handles_of(rect):
        square = QRectF(0, 0, _SIDE_PX, _SIDE_PX)
        square.moveCenter(_place(rect, handle))
        painter.drawRect(square)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def draw_outline_beyond(painter: QPainter, rect: QRectF, colour: QColor, shown: QRectF) -> None:
    """The part of a box's outline that lies beside the picture, so that its handles hold on to it.

    shown: where the picture is; the box is drawn there.
    """
    painter.save()
    beside = QPainterPath()
    beside.addRect(rect.united(shown).adjusted(-_SIDE_PX, -_SIDE_PX, _SIDE_PX, _SIDE_PX))
    inside = QPainterPath()
    inside.addRect(shown)
    painter.setClipPath(beside - inside, Qt.ClipOperation.IntersectClip)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(colour, 1.4, Qt.PenStyle.DashLine))
    painter.drawRect(rect)
    painter.restore()


def _is_roomy(rect: QRectF) -> bool:
    return min(rect.width(), rect.height()) >= _ROOM_FOR_EDGES_PX


def _within(rect: QRectF) -> QRectF:
    """A box without its border."""
    across, along = (min(_BORDER_PX, side / 6) for side in (rect.width(), rect.height()))
    return rect.adjusted(across, along, -across, -along)


def _place(rect: QRectF, handle: Handle) -> QPointF:
    """The middle of a handle: on the border, at a small box outside of it."""
    out = 0.0 if _is_roomy(rect) else _SIDE_PX / 2
    across, along = rect.width() / 2 + out, rect.height() / 2 + out
    return rect.center() + QPointF(handle[0] * across, handle[1] * along)


def _dragged(low: float, high: float, side: int, by: float) -> tuple[float, float]:
    """Two ends of which one is dragged, the lower first."""
    if side < 0:
        low += by
    elif side > 0:
        high += by
    return min(low, high), max(low, high)
