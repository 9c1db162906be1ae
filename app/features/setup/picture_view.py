"""The picture of a step: zoomed and panned, with grid, points and outlines that can be dragged."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPen,
    QPixmap,
)
from PySide6.QtWidgets import QWidget

from app.core.drawing.canvas import Canvas
from app.core.drawing.label_marks import draw_arrow
from app.core.drawing.name_plates import draw_message
from app.core.drawing.viewport import path_through, polygon
from app.core.look.theme import Theme, faded
from app.core.scenes.labels import LINE_COLOUR, OCCLUDER_COLOUR
from app.features.setup.scene import SetupPicture, ShownOutline
from tracking.arrays import Floats
from tracking.recording.frame import Image

_REACH_PX = 12.0
_HANDLE_PX = 4.5
_ARROWS = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, -1.0),
    Qt.Key.Key_Down: (0.0, 1.0),
}
_FAST = 10.0
_SEEN = QColor(90, 220, 120)
_GRID, _GRID_BEHIND = 0.75, 0.45
"""How strong the grid is, and behind outlines, which may have its colour."""
_HORIZON, _FIGURE = QColor(80, 190, 255), QColor(255, 200, 60)
_COLOURS = {
    "look": _SEEN,
    "mask": QColor(255, 110, 90),
    "occluder": QColor(*OCCLUDER_COLOUR),
    "line": QColor(*LINE_COLOUR),
}


class PictureView(Canvas):
    """Draws a :class:`SetupPicture`.

    Arrow keys move the chosen handle by a pixel, with Shift by ten; Tab goes to the next one.

    Signals:
        clicked(x, y): on the image, in px of it. hovered(x, y): the mouse is there.
        handle_moved(number, x, y): a handle was dragged, or moved by keys.
        handle_chosen(number): a handle was clicked, or reached by keys.
        ended(): Enter. given_up(): Escape. deleted(): Delete or Backspace.
    """

    clicked = Signal(float, float)
    hovered = Signal(float, float)
    handle_moved = Signal(int, float, float)
    handle_chosen = Signal(int)
    ended = Signal()
    given_up = Signal()
    deleted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(False, parent)
        self._picture = SetupPicture()
        self._drawn: QPixmap | None = None
        self._held = -1
        self._moved: tuple[float, float] | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def show_picture(self, picture: SetupPicture) -> None:
        """Show another picture, or the same with other marks."""
        before, self._picture = self._picture.image, picture
        if picture.image is not before:
            self._drawn = None
            same = before is not None and picture.image is not None
            if not (same and before is not None and before.shape == picture.image.shape):  # type: ignore[union-attr]
                self.fit()
        self.setAccessibleName(picture.said)
        self.update()

    @property
    def picture(self) -> SetupPicture:
        """What is shown."""
        return self._picture

    def place_of(self, x: float, y: float) -> QPointF:
        """Where a pixel of the image is on the widget."""
        return self.viewport.point(x, y)

    # a canvas

    def content(self) -> QRectF:
        """The whole image, in px."""
        image = self._picture.image
        if image is None:
            return QRectF()
        return QRectF(-0.5, -0.5, image.shape[1], image.shape[0])

    def clicked_at(self, at: QPointF, extend: bool) -> None:  # noqa: ARG002
        """A handle is chosen, else the place is told."""
        near = self._handle_at(at)
        if near >= 0:
            self.handle_chosen.emit(near)
        elif self._picture.image is not None:
            place = self.viewport.to_content(at)
            if self.content().contains(place):
                self.clicked.emit(place.x(), place.y())

    def track_at(self, at: QPointF) -> int:  # noqa: ARG002
        """No tracks here."""
        return 0

    def grabs(self, at: QPointF) -> bool:
        """A handle near the mouse."""
        self._held, self._moved = self._handle_at(at), None
        return self._held >= 0

    def drag_to(self, at: QPointF) -> None:
        """Draw the handle where it is by now."""
        place = self.viewport.to_content(at)
        self._moved = self._inside(place.x(), place.y())
        self.update()

    def drop(self) -> None:
        """Tell where the handle is let go."""
        held, moved = self._held, self._moved
        self._held, self._moved = -1, None
        if moved is not None:
            self.handle_moved.emit(held, *moved)

    def cursor_at(self, at: QPointF) -> Qt.CursorShape:
        """A cross on the image, arrows over handles."""
        if self._handle_at(at) >= 0:
            return Qt.CursorShape.SizeAllCursor
        return Qt.CursorShape.CrossCursor

    def name_at(self, at: QPointF) -> str:  # noqa: ARG002
        """No tips."""
        return ""

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Tell where the mouse is."""
        super().mouseMoveEvent(event)
        if self._picture.image is not None:
            place = self.viewport.to_content(event.position())
            self.hovered.emit(place.x(), place.y())

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Move, choose, end, delete."""
        key = Qt.Key(event.key())
        if key in _ARROWS and self._picture.handle >= 0:
            fast = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            across, down = (side * (_FAST if fast else 1.0) for side in _ARROWS[key])
            x, y = self._picture.handles[self._picture.handle].tolist()
            self.handle_moved.emit(self._picture.handle, *self._inside(x + across, y + down))
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.ended.emit()
        elif key in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.deleted.emit()
        elif key == Qt.Key.Key_Escape and self._draws():
            self.given_up.emit()
        elif key in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown) and len(self._picture.handles):
            step = 1 if key == Qt.Key.Key_PageDown else -1
            self.handle_chosen.emit((self._picture.handle + step) % len(self._picture.handles))
        else:
            super().keyPressEvent(event)

    def _draws(self) -> bool:
        return any(not outline.closed for outline in self._picture.outlines)

    def _inside(self, x: float, y: float) -> tuple[float, float]:
        area = self.content()
        return min(max(x, 0.0), area.right()), min(max(y, 0.0), area.bottom())

    def _handle_at(self, at: QPointF) -> int:
        handles = self._picture.handles
        if not len(handles):
            return -1
        apart = np.hypot(*(self.viewport.to_widget(handles) - (at.x(), at.y())).T)
        nearest = int(apart.argmin())
        return nearest if apart[nearest] <= _REACH_PX else -1

    # drawing

    def paint(self, painter: QPainter, theme: Theme) -> None:
        """The image, then lines, figure, outlines and points."""
        picture = self._picture
        if picture.image is None:
            draw_message(painter, QRectF(self.rect()), picture.said, theme)
            return
        if self._drawn is None:
            self._drawn = QPixmap.fromImage(_qimage(picture.image))
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawPixmap(
            self.viewport.rect(self.content()), self._drawn, QRectF(self._drawn.rect())
        )
        painter.save()
        painter.setClipRect(self.viewport.rect(self.content()))
        painter.save()
        painter.setClipRect(
            self.viewport.rect(QRectF(-0.5, -0.5, *picture.floor_size)),
            Qt.ClipOperation.IntersectClip,
        )
        self._draw_floor(painter, picture)
        painter.restore()
        handles = self._handles_now()
        first = len(picture.points)
        for outline in picture.outlines:
            corners = handles[first : first + len(outline.corners)]
            self._draw_outline(painter, outline, corners)
            first += len(outline.corners)
        painter.restore()
        self._draw_handles(painter, handles, theme)
        self._draw_titles(painter, picture)

    def _handles_now(self) -> Floats:
        """(n, 2) px, the one that is dragged where it is by now."""
        handles = self._picture.handles.copy()
        if self._moved is not None and 0 <= self._held < len(handles):
            handles[self._held] = self._moved
        return handles

    def _draw_floor(self, painter: QPainter, picture: SetupPicture) -> None:
        strength = _GRID_BEHIND if picture.outlines else _GRID
        painter.setPen(QPen(faded(_SEEN, strength), 1.2))
        for line in picture.grid:
            painter.drawPath(path_through(self.viewport.to_widget(line), False))
        if picture.horizon is not None:
            painter.setPen(QPen(_HORIZON, 2.0))
            painter.drawPath(path_through(self.viewport.to_widget(picture.horizon), False))
        if picture.figure is not None:
            painter.setPen(QPen(_FIGURE, 2.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(self.viewport.rect(QRectF(*picture.figure)), 6, 6)

    def _draw_outline(self, painter: QPainter, outline: ShownOutline, corners: Floats) -> None:
        colour = _COLOURS[outline.kind]
        painter.setPen(QPen(colour, 3.0 if outline.chosen else 1.8))
        painter.setBrush(faded(colour, 0.18) if outline.closed else Qt.BrushStyle.NoBrush)
        shape = polygon(self.viewport.to_widget(corners))
        if outline.closed and outline.kind != "line":
            painter.drawPolygon(shape)
        else:
            painter.drawPolyline(shape)
        if len(outline.arrow):
            draw_arrow(painter, self.viewport.to_widget(outline.arrow), colour)

    def _draw_handles(self, painter: QPainter, handles: Floats, theme: Theme) -> None:
        numbered = len(self._picture.points)
        for number, (x, y) in enumerate(self.viewport.to_widget(handles).tolist()):
            chosen = number == self._picture.handle
            painter.setPen(QPen(QColor(0, 0, 0), 1.0))
            painter.setBrush(theme.accent if chosen else QColor(255, 255, 255))
            side = _HANDLE_PX + (2.0 if chosen else 0.0)
            painter.drawEllipse(QPointF(x, y), side, side)
            if number < numbered:
                _outlined_text(painter, QPointF(x + 8, y - 6), str(number + 1))

    def _draw_titles(self, painter: QPainter, picture: SetupPicture) -> None:
        top = self.viewport.point(0, 0).y() + self.fontMetrics().ascent() + 6
        for x, text in picture.titles:
            _outlined_text(painter, QPointF(self.viewport.point(x, 0).x() + 8, top), text)


def _qimage(image: Image) -> QImage:
    packed = np.ascontiguousarray(image)
    height, width = packed.shape[:2]
    kind = QImage.Format.Format_BGR888
    return QImage(packed.data, width, height, 3 * width, kind).copy()


def _outlined_text(painter: QPainter, at: QPointF, text: str) -> None:
    """White letters with a dark rim: readable on any image."""
    painter.setPen(QColor(0, 0, 0))
    for across, down in ((-1, 0), (1, 0), (0, -1), (0, 1)):
        painter.drawText(at + QPointF(across, down), text)
    painter.setPen(QColor(255, 255, 255))
    painter.drawText(at, text)
