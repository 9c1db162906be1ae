"""The whole recording in one strip: how busy it is, what is tracked, what the lanes show."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QHelpEvent,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QToolTip, QWidget

from app.core.i18n import time_text, tr
from app.core.look.theme import Theme, current_theme, faded
from app.core.plots.axis import TimeAxis
from app.core.scenes import TimelineScene
from app.core.widgets.spoken_description import SpokenDescription
from app.core.widgets.still_picture import StillPicture
from app.features.timeline.overview_picture import draw_band, draw_overview
from app.features.timeline.spoken_timeline import told_overview
from app.features.timeline.thumbnail import ThumbnailPopup

_NOTCH, _ZOOM_PER_NOTCH = 120.0, 1.25


class OverviewStrip(QWidget):
    """The left button seeks; the middle one, or the left one with Ctrl, moves what the lanes show.

    Signals:
        frame_sought(int): a click or drag. window_sought(int): the lanes shall show that frame.
        zoomed(float): the wheel; closer by a factor.
        hovered(int): the mouse rests on a frame; -1: on none any more.
    """

    frame_sought = Signal(int)
    window_sought = Signal(int)
    zoomed = Signal(float)
    hovered = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: TimelineScene | None = None
        self._shown: TimeAxis | None = None
        self._still = StillPicture(self)
        self._review_items: NDArray[np.int64] = np.zeros(0, np.int64)
        self._over = -1
        self.thumbnail = ThumbnailPopup(self)
        self.setMouseTracking(True)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(tr("Overview of the whole recording"))
        self._spoken = SpokenDescription(self, lambda: told_overview(self._scene))

    def show_scene(self, scene: TimelineScene) -> None:
        """Draw another frame; what stays only where it is another one."""
        before, self._scene = self._scene, scene
        if before is None or before.review_items is not scene.review_items:
            self._review_items = np.array([mark.frame for mark in scene.review_items], np.int64)
        if before is None or (
            before.activity is not scene.activity
            or before.review_items is not scene.review_items
            or before.reviewed is not scene.reviewed
            or (before.tracked, before.frame_count) != (scene.tracked, scene.frame_count)
        ):
            self._still.forget()
        self._spoken.changed()
        self.update()

    def show_window(self, axis: TimeAxis) -> None:
        """Mark the frames the lanes show; the strip lies below their bars."""
        if self._shown is None or (self._shown.left, self._shown.width) != (axis.left, axis.width):
            self._still.forget()
        self._shown = axis
        self.update()

    def show_thumbnail(self, image: QImage) -> None:
        """Show the picture of the frame under the mouse, which was asked for."""
        if self._scene is None or self._over < 0:
            return
        time_s = self._over / max(self._scene.fps, 1e-6)
        words = tr("frame {0}, {1}").format(self._over, time_text(time_s))
        self.thumbnail.show_at(self._axis().x_of(self._over + 0.5), words, image)

    def hide_thumbnail(self) -> None:
        """Nothing is under the mouse."""
        self._over = -1
        self.thumbnail.hide()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Two lines of text high."""
        return QSize(800, round(1.9 * self.fontMetrics().height()) + 8)

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """The height is fixed."""
        return QSize(200, self.sizeHint().height())

    def words_at(self, x: float) -> str:
        """What is told of a place: the frame, its time, how many people."""
        scene, axis = self._scene, self._axis()
        if scene is None or x < axis.left:
            return tr("The whole recording: number of people; below, the tracked frames")
        frame = axis.frame_at(x)
        lines = [
            tr("frame {0}, {1}").format(frame, time_text(frame / max(scene.fps, 1e-6))),
            tr("people: {0}").format(int(scene.activity[frame])),
        ]
        if any(start <= frame < end for start, end in scene.reviewed):
            lines.append(tr("reviewed"))
        return "\n".join(lines)

    def _axis(self) -> TimeAxis:
        left, width = 0.0, float(self.width())
        if self._shown is not None:
            left, width = self._shown.left, self._shown.width
        count = self._scene.frame_count if self._scene is not None else 1
        return TimeAxis(left, max(width, 1.0), 0.0, float(max(count, 1)), count)

    # drawing

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """What stays from its picture, then window and playhead."""
        theme, painter = current_theme(), QPainter(self)
        self._still.paint(painter, theme.window, lambda still: self._draw_still(still, theme))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._scene is not None:
            self._draw_loaded(painter, self._scene, theme)
            self._draw_window(painter, theme)
            x = self._axis().x_of(self._scene.frame + 0.5)
            painter.setPen(QPen(theme.accent, 1.6))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
        painter.end()

    def _draw_still(self, painter: QPainter, theme: Theme) -> None:
        axis = self._axis()
        painter.setPen(theme.text_faint)
        name = QRectF(12, 0, axis.left - 16, self.height())
        painter.drawText(name, Qt.AlignmentFlag.AlignVCenter, tr("Overview"))
        ground = QRectF(axis.left, 4, axis.width, self.height() - 8)
        painter.fillRect(ground, theme.sunken)
        if self._scene is not None:
            draw_overview(painter, self._scene, self._review_items, axis, ground, theme)

    def _draw_loaded(self, painter: QPainter, scene: TimelineScene, theme: Theme) -> None:
        """What is at hand, changing all the time, on top of the picture of what stays."""
        axis = self._axis()
        ground = QRectF(axis.left, 4, axis.width, 2)
        for frames in scene.loaded:
            draw_band(painter, frames, axis, ground, faded(theme.text_muted, 0.7))

    def _draw_window(self, painter: QPainter, theme: Theme) -> None:
        shown = self._shown
        if shown is None or shown.frames >= shown.frame_count:
            return
        axis = self._axis()
        left, right = axis.x_of(shown.start), axis.x_of(shown.start + shown.frames)
        ground = QRectF(axis.left, 4, axis.width, self.height() - 8)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(faded(theme.window, 0.55))
        painter.drawRect(QRectF(ground.left(), ground.top(), left - axis.left, ground.height()))
        painter.drawRect(QRectF(right, ground.top(), ground.right() - right, ground.height()))
        painter.setPen(QPen(theme.text_muted, 1.2))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        frame = QRectF(left, 2.5, max(right - left, 3.0), self.height() - 5)
        painter.drawRoundedRect(frame, 3, 3)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Draw anew."""
        super().resizeEvent(event)
        self._still.forget()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow theme and font."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self._still.forget()
            self.update()

    # gestures

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go there, or let the lanes show it."""
        self._seek(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go on while dragging."""
        self._seek(event)
        self._hover(event)

    def leaveEvent(self, event: QEvent) -> None:  # noqa: N802
        """The mouse is elsewhere."""
        super().leaveEvent(event)
        self.hide_thumbnail()
        self.hovered.emit(-1)

    def _hover(self, event: QMouseEvent) -> None:
        """Ask for the picture there; while a button is held the views show that very frame."""
        inside = event.position().x() >= self._axis().left and not event.buttons()
        over = self._axis().frame_at(event.position().x()) if inside else -1
        if over < 0:
            self.hide_thumbnail()
        elif over != self._over:
            self._over = over
            self.hovered.emit(over)

    def _seek(self, event: QMouseEvent) -> None:
        held, button = event.buttons(), Qt.MouseButton
        with_ctrl = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        frame = self._axis().frame_at(event.position().x())
        if held & button.MiddleButton or (held & button.LeftButton and with_ctrl):
            self.window_sought.emit(frame)
        elif held & button.LeftButton:
            self.frame_sought.emit(frame)

    def wheelEvent(self, event: QWheelEvent) -> None:  # noqa: N802
        """Show fewer frames in the lanes, or more."""
        self.zoomed.emit(_ZOOM_PER_NOTCH ** (event.angleDelta().y() / _NOTCH))
        event.accept()

    def event(self, event: QEvent) -> bool:
        """Tell what is under the mouse."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.words_at(event.pos().x()), self)
            return True
        return super().event(event)
