"""Rectangles of body parts moved, resized and drawn with the mouse."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPen

from app.core.drawing.canvas import Canvas
from app.core.drawing.label_marks import part_colour
from app.core.look.theme import Theme
from app.core.scenes.labels import PartMark
from app.features.labelling.layer import Key, Layer

_REACH_PX = 7.0
_HANDLE_PX = 7.0
_LEAST_PX = 2.0  # of the picture; less is a click
Sides = tuple[int, int]
"""Which sides are held: -1 left or top, 1 right or bottom, 0 neither of both."""


class PartsLayer(Layer):
    """Head, torso and hip-leg of one person in the left camera.

    Signals:
        part_chosen(int): a rectangle was clicked.
        part_drawn(int, object): a part's new box, left, top, width, height in pixels as recorded.
        picked(float, float): a click beside all rectangles, on the widget: maybe on a person.
    """

    part_chosen = Signal(int)
    part_drawn = Signal(int, object)
    picked = Signal(QPointF)

    def __init__(self, canvas: Canvas) -> None:
        super().__init__(canvas)
        self._marks: tuple[PartMark, ...] = ()
        self._chosen = 0
        self._held: tuple[int, Sides, QRectF] | None = None  # part, sides, box before
        self._pressed, self._viewport = QPointF(), canvas.viewport  # since when the view is still
        self._from = QRectF()  # where the box was then
        self._box = QRectF()

    def show_parts(self, marks: Sequence[PartMark], chosen: int) -> None:
        """The rectangles in the left image; a click beside them draws the chosen one."""
        self._marks, self._chosen = tuple(marks), chosen
        if self._held is not None and not self._still_there():
            self._held = None
        self.update()

    def _still_there(self) -> bool:
        """Whether what is held is as it was: another frame or person has its parts elsewhere.

        Dropped there, it would be put far from the part.
        """
        assert self._held is not None
        part, _, before = self._held
        now = (QRectF(*mark.box) for mark in self._marks if mark.part == part)
        return before.isEmpty() or before in now

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        """Take hold of a rectangle or one of its sides, else begin a new one."""
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        hit = self._hit(event.position())
        if hit is None:
            corner = QPointF(*self.place(event.position()))
            self._held = (self._chosen, (1, 1), QRectF(corner, corner))
        else:
            mark, sides = hit
            self._held = (mark.part, sides, QRectF(*mark.box))
        self._box = QRectF(self._held[2])
        self._regrip(event.position())
        self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Move or resize what is held."""
        if event.buttons() & Qt.MouseButton.MiddleButton:
            event.ignore()
            return
        if self._held is None:
            hit = self._hit(event.position())
            self.setCursor(_cursor(None if hit is None else hit[1]))
            return
        _, sides, _ = self._held
        if self.canvas.viewport != self._viewport:
            self._regrip(event.position())
        moved = event.position() - self._pressed
        self._box = _stretched(self._from, sides, moved / self._viewport.scale)
        self.update()

    def _regrip(self, at: QPointF) -> None:
        """Go on from where the box is, also where the view shifted under the pointer."""
        self._viewport, self._pressed, self._from = self.canvas.viewport, at, QRectF(self._box)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Take what was drawn; what did not move was a click."""
        if event.button() is not Qt.MouseButton.LeftButton or self._held is None:
            event.ignore()
            return
        (part, _, before), self._held = self._held, None
        box = self._box.normalized()
        if box != before and box.width() >= _LEAST_PX and box.height() >= _LEAST_PX:
            self.part_drawn.emit(part, (box.x(), box.y(), box.width(), box.height()))
        elif before.isEmpty():
            self.picked.emit(event.position())
        else:
            self.part_chosen.emit(part)
        self.update()

    def key(self, key: Qt.Key) -> None:
        """Esc: leave what is held, else the labelling."""
        if key == Key.Key_Escape and self._held is not None:
            self._held = None
        else:
            self.leave_asked.emit()

    def paint(self, painter: QPainter, theme: Theme) -> None:  # noqa: ARG002 - one for all layers
        """What is held, where it is by now; handles on the corners of the chosen part."""
        for mark in self._marks:
            if mark.chosen and self._held is None:
                _draw_handles(painter, self.canvas.viewport.rect(QRectF(*mark.box)), mark.part)
        if self._held is not None:
            rect = self.canvas.viewport.rect(self._box.normalized())
            painter.setBrush(Qt.BrushStyle.NoBrush)
            colour = QColor(*part_colour(self._held[0]))
            for pen in (QPen(QColor(0, 0, 0, 150), 4.0), QPen(colour, 2.0)):
                painter.setPen(pen)
                painter.drawRect(rect)
            _draw_handles(painter, rect, self._held[0])

    def _hit(self, at: QPointF) -> tuple[PartMark, Sides] | None:
        """The rectangle under the mouse, the chosen one first, and which of its sides."""
        for mark in sorted(self._marks, key=lambda one: not one.chosen):
            rect = self.canvas.viewport.rect(QRectF(*mark.box))
            if rect.adjusted(-_REACH_PX, -_REACH_PX, _REACH_PX, _REACH_PX).contains(at):
                across = _side(at.x(), rect.left(), rect.right())
                down = _side(at.y(), rect.top(), rect.bottom())
                return mark, (across, down)
        return None


def _side(at: float, low: float, high: float) -> int:
    """Which end of a stretch a place is near to; the middle third is always neither."""
    reach = min(_REACH_PX, (high - low) / 3)
    if at <= low + reach:
        return -1
    return 1 if at >= high - reach else 0


def _stretched(before: QRectF, sides: Sides, by: QPointF) -> QRectF:
    """The box moved as a whole, or with the sides that are held put elsewhere."""
    if sides == (0, 0):
        return before.translated(by)
    left, top, right, bottom = before.left(), before.top(), before.right(), before.bottom()
    left += by.x() if sides[0] < 0 else 0.0
    right += by.x() if sides[0] > 0 else 0.0
    top += by.y() if sides[1] < 0 else 0.0
    bottom += by.y() if sides[1] > 0 else 0.0
    return QRectF(QPointF(left, top), QPointF(right, bottom))


def _cursor(sides: Sides | None) -> Qt.CursorShape:
    shapes = Qt.CursorShape
    if sides is None:
        return shapes.CrossCursor
    if sides == (0, 0):
        return shapes.SizeAllCursor
    if sides[0] and sides[1]:
        return shapes.SizeFDiagCursor if sides[0] == sides[1] else shapes.SizeBDiagCursor
    return shapes.SizeHorCursor if sides[0] else shapes.SizeVerCursor


def _draw_handles(painter: QPainter, rect: QRectF, part: int) -> None:
    painter.setPen(QPen(QColor(20, 20, 20, 220), 1.0))
    painter.setBrush(QColor(*part_colour(part)))
    # Of somebody far away little would be seen between handles of the full size.
    side = max(2.0, min(_HANDLE_PX, rect.width() / 4, rect.height() / 4))
    for corner in (rect.topLeft(), rect.topRight(), rect.bottomLeft(), rect.bottomRight()):
        painter.drawRect(QRectF(corner.x() - side / 2, corner.y() - side / 2, side, side))
