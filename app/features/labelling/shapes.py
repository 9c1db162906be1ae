"""Polygons and lines drawn by their corners: occluders in the picture, lines and regions below."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from PySide6.QtCore import QPointF, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPen

from app.core.drawing.canvas import Canvas
from app.core.drawing.label_marks import draw_corners
from app.core.drawing.viewport import Points, path_through
from app.core.look.theme import Theme
from app.core.scenes import Colour
from app.features.labelling.layer import Key, Layer, is_enter

_REACH_PX = 9.0
Corner = tuple[float, float]


class ShapesLayer(Layer):
    """Draws further shapes and corrects the corners of those there are.

    Signals:
        drawn(object): corners of a new shape, a tuple of (x, y) in the canvas's content.
        reshaped(int, object): another one's number and its new corners.
        picked(int): a shape was clicked. removal_asked(): Del.
    """

    drawn = Signal(object)
    reshaped = Signal(int, object)
    picked = Signal(int)
    removal_asked = Signal()
    keys = (
        Key.Key_Escape,
        Key.Key_Return,
        Key.Key_Enter,
        Key.Key_Backspace,
        Key.Key_Delete,
    )

    def __init__(self, canvas: Canvas) -> None:
        super().__init__(canvas)
        self._shapes: tuple[tuple[Corner, ...], ...] = ()
        self._numbers: tuple[int, ...] = ()
        self._closed = True
        self._colour: Colour = (255, 255, 255)
        self._draft: list[Corner] = []
        self._held: tuple[int, int] | None = None  # shape, corner
        self._dragged: list[Corner] = []
        self._mouse = QPointF()

    def show_shapes(
        self, shapes: Mapping[int, tuple[Corner, ...]], *, closed: bool, colour: Colour
    ) -> None:
        """Which shapes there are, by their numbers; their corners can be dragged.

        A corner that is held is let go where its shape is gone or another one by now.
        """
        if self._held is not None:
            shape, corner = self._held
            number, before = self._numbers[shape], self._shapes[shape]
            same = shapes.get(number) == before
            self._held = (list(shapes).index(number), corner) if same else None
        self._numbers, self._shapes = tuple(shapes), tuple(shapes.values())
        self._closed, self._colour = closed, colour
        self.update()

    def begin(self) -> None:
        """Nothing is half drawn."""
        self._draft, self._held = [], None
        super().begin()

    # the mouse

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        """Take hold of a corner, pick a shape by its edge, or put the next corner."""
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        self._mouse = event.position()
        if self._draft:
            self._put_corner(event.position())
        elif (corner := self._corner_at(event.position())) is not None:
            self._held, self._dragged = corner, list(self._shapes[corner[0]])
            self.picked.emit(self._numbers[corner[0]])
        elif (shape := self._edge_at(event.position())) is not None:
            self.picked.emit(self._numbers[shape])
        else:
            self._put_corner(event.position())
        self.update()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Drag the corner that is held."""
        if event.buttons() & Qt.MouseButton.MiddleButton:
            event.ignore()
            return
        self._mouse = event.position()
        if self._held is not None:
            self._dragged[self._held[1]] = self.place(event.position())
        over = self._held is not None or self._corner_at(event.position()) is not None
        shape = Qt.CursorShape.SizeAllCursor if over else Qt.CursorShape.CrossCursor
        self.setCursor(shape)
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Let the corner go where it is."""
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        held, self._held = self._held, None
        if held is not None and tuple(self._dragged) != self._shapes[held[0]]:
            self.reshaped.emit(self._numbers[held[0]], tuple(self._dragged))
        self.update()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Close: the first of both clicks has put the last corner."""
        if event.button() is Qt.MouseButton.LeftButton:
            self._close()
            self.update()

    # the keys

    def key(self, key: Qt.Key) -> None:
        """Close, take the last corner back, take a shape away, or leave."""
        if is_enter(key):
            self._close()
        elif key == Key.Key_Backspace and self._draft:
            self._draft.pop()
        elif key == Key.Key_Delete:
            self.removal_asked.emit()
        elif key == Key.Key_Escape and (self._draft or self._held is not None):
            self._draft, self._held = [], None
        elif key == Key.Key_Escape:
            self.leave_asked.emit()

    def _put_corner(self, at: QPointF) -> None:
        first = self._on_widget(self._draft[:1])
        if self._closed and len(self._draft) >= 3 and _near(first[0], at):
            self._close()
            return
        self._draft.append(self.place(at))
        if not self._closed and len(self._draft) == 2:
            self._close()

    def _close(self) -> None:
        """Give away what was drawn, where it has enough corners."""
        if len(self._draft) >= (3 if self._closed else 2):
            draft, self._draft = tuple(self._draft), []
            self.drawn.emit(draft)

    # where things are

    def _on_widget(self, corners: Sequence[Corner]) -> Points:
        return self.canvas.viewport.to_widget(np.array(corners, np.float64).reshape(-1, 2))

    def _corner_at(self, at: QPointF) -> tuple[int, int] | None:
        for number, shape in enumerate(self._shapes):
            for corner, place in enumerate(self._on_widget(shape)):
                if _near(place, at):
                    return number, corner
        return None

    def _edge_at(self, at: QPointF) -> int | None:
        point = np.array([at.x(), at.y()])
        for number, shape in enumerate(self._shapes):
            start = self._on_widget(shape)
            end = np.roll(start, -1, axis=0)
            if not self._closed:
                start, end = start[:-1], end[:-1]
            along = end - start
            length = np.maximum((along**2).sum(axis=1), 1e-9)
            share = np.clip(((point - start) * along).sum(axis=1) / length, 0, 1)
            if (np.hypot(*(start + share[:, None] * along - point).T) <= _REACH_PX / 2).any():
                return number
        return None

    def paint(self, painter: QPainter, theme: Theme) -> None:  # noqa: ARG002 - one for all layers
        """Corners of all shapes, the shape that is dragged, what is half drawn."""
        colour = QColor(*self._colour)
        for number, shape in enumerate(self._shapes):
            held = self._held is not None and self._held[0] == number
            corners = self._on_widget(self._dragged if held else shape)
            if held:
                self._draw_path(painter, corners, colour, self._closed)
            draw_corners(painter, corners, colour, self._held[1] if held and self._held else -1)
        if self._draft:
            corners = self._on_widget(self._draft)
            mouse = np.array([[self._mouse.x(), self._mouse.y()]])
            self._draw_path(painter, np.concatenate((corners, mouse)), colour, False)
            draw_corners(painter, corners, colour)

    def _draw_path(self, painter: QPainter, points: Points, colour: QColor, closed: bool) -> None:
        path = path_through(points, closed)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for pen in (QPen(QColor(0, 0, 0, 150), 4.0), QPen(colour, 2.0, Qt.PenStyle.DashLine)):
            painter.setPen(pen)
            painter.drawPath(path)


def _near(place: Points, at: QPointF) -> bool:
    return bool(np.hypot(place[0] - at.x(), place[1] - at.y()) <= _REACH_PX)
