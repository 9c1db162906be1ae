"""The whole recording in one strip: how busy it is, what is tracked, what the lanes show."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QWidget

from app.presenters.scenes import TimelineScene
from app.views.theme import Theme, current_theme, faded
from app.views.timeline.axis import TimeAxis


def busiest(activity: NDArray[np.uint16], columns: int) -> NDArray[np.float64]:
    """The most people at once in each of `columns` equal parts of the recording."""
    if not len(activity) or columns < 1:
        return np.zeros(max(columns, 0))
    starts = np.minimum(np.arange(columns) * len(activity) // columns, len(activity) - 1)
    return np.asarray(np.maximum.reduceat(activity, starts), np.float64)


class OverviewStrip(QWidget):
    """Signals: frame_sought(int), on a click or drag."""

    frame_sought = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: TimelineScene | None = None
        self._shown: TimeAxis | None = None
        self._drawn: QPixmap | None = None
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(self.tr("Overview of the whole recording"))
        self.setToolTip(
            self.tr("The whole recording: people at once; below, what is tracked; above, at hand")
        )

    def show_scene(self, scene: TimelineScene) -> None:
        """Draw another instant; activity only where it is another one."""
        before, self._scene = self._scene, scene
        if before is None or (
            before.activity is not scene.activity
            or (before.tracked, before.frame_count) != (scene.tracked, scene.frame_count)
        ):
            self._drawn = None
        self.update()

    def show_window(self, axis: TimeAxis) -> None:
        """Mark the frames the lanes show; the strip lies below their bars."""
        if self._shown is None or (self._shown.left, self._shown.width) != (axis.left, axis.width):
            self._drawn = None
        self._shown = axis
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Two lines of text high."""
        return QSize(800, round(1.9 * self.fontMetrics().height()) + 8)

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """The height is fixed."""
        return QSize(200, self.sizeHint().height())

    def _axis(self) -> TimeAxis:
        left, width = 0.0, float(self.width())
        if self._shown is not None:
            left, width = self._shown.left, self._shown.width
        count = self._scene.frame_count if self._scene is not None else 1
        return TimeAxis(left, max(width, 1.0), 0.0, float(max(count, 1)), count)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Activity from its picture, then window and playhead."""
        theme, painter = current_theme(), QPainter(self)
        ratio = self.devicePixelRatioF()
        if self._drawn is None or self._drawn.size() != self.size() * ratio:
            self._drawn = self._draw_still(theme, ratio)
        painter.drawPixmap(0, 0, self._drawn)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._scene is not None:
            self._draw_loaded(painter, self._scene, theme)
            self._draw_window(painter, theme)
            x = self._axis().x_of(self._scene.frame + 0.5)
            painter.setPen(QPen(theme.accent, 1.6))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
        painter.end()

    def _draw_still(self, theme: Theme, ratio: float) -> QPixmap:
        picture = QPixmap(self.size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(theme.window)
        painter = QPainter(picture)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        axis = self._axis()
        painter.setPen(theme.text_faint)
        name = QRectF(12, 0, axis.left - 16, self.height())
        painter.drawText(name, Qt.AlignmentFlag.AlignVCenter, self.tr("Overview"))
        ground = QRectF(axis.left, 4, axis.width, self.height() - 8)
        painter.fillRect(ground, theme.sunken)
        if self._scene is not None:
            foot = QRectF(ground.left(), ground.bottom() - 3, ground.width(), 3)
            self._draw_activity(painter, self._scene, ground, theme)
            self._draw_band(painter, self._scene.tracked, foot, theme.accent)
        painter.end()
        return picture

    def _draw_activity(
        self, painter: QPainter, scene: TimelineScene, ground: QRectF, theme: Theme
    ) -> None:
        columns, rows = int(ground.width()), int(ground.height()) - 5
        most = busiest(scene.activity, columns)
        if columns < 1 or rows < 1 or not most.any():
            return
        tops = rows - np.ceil(rows * most / most.max())
        filled = np.arange(rows)[:, None] >= tops
        ink = faded(theme.text_faint, 0.55)
        pixels = np.where(filled, np.uint32(ink.rgba()), np.uint32(0))
        image = QImage(pixels.data, columns, rows, 4 * columns, QImage.Format.Format_ARGB32)
        painter.drawImage(QPointF(ground.left(), ground.top() + 2), image)

    def _draw_loaded(self, painter: QPainter, scene: TimelineScene, theme: Theme) -> None:
        """What is at hand, changing all the time, on top of the picture of what stays."""
        axis = self._axis()
        ground = QRectF(axis.left, 4, axis.width, 2)
        for frames in scene.loaded:
            self._draw_band(painter, frames, ground, faded(theme.text_muted, 0.7))

    def _draw_band(
        self, painter: QPainter, frames: tuple[int, int], band: QRectF, colour: QColor
    ) -> None:
        axis = self._axis()
        left, right = axis.x_of(frames[0]), axis.x_of(frames[1])
        if right > left:
            painter.fillRect(QRectF(left, band.top(), right - left, band.height()), colour)

    def _draw_window(self, painter: QPainter, theme: Theme) -> None:
        shown = self._shown
        if shown is None or shown.frames >= shown.frame_count:
            return
        axis = self._axis()
        left, right = axis.x_of(shown.start), axis.x_of(shown.start + shown.frames)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(faded(theme.window, 0.55))
        painter.drawRect(QRectF(axis.left, 4, left - axis.left, self.height() - 8))
        painter.drawRect(QRectF(right, 4, axis.left + axis.width - right, self.height() - 8))
        painter.setPen(QPen(theme.text_muted, 1.2))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(QRectF(left, 2.5, right - left, self.height() - 5), 3, 3)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Draw anew."""
        super().resizeEvent(event)
        self._drawn = None

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow theme and font."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self._drawn = None
            self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go there."""
        if event.button() is Qt.MouseButton.LeftButton:
            self.frame_sought.emit(self._axis().frame_at(event.position().x()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go on while dragging."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.frame_sought.emit(self._axis().frame_at(event.position().x()))
