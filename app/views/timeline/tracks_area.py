"""The upper part of the timeline: ruler, lanes, playhead."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRect, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QFontMetricsF,
    QHelpEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QScrollBar, QToolTip, QWidget

from app.presenters.scenes import Lane, TimelineScene
from app.views.labels import draw_message
from app.views.theme import Theme, current_theme, scaled_font
from app.views.timeline.axis import TimeAxis
from app.views.timeline.lanes import draw_lane
from app.views.timeline.ruler import (
    PLAYHEAD_HEIGHT,
    SMALL,
    draw_cut,
    draw_playhead,
    draw_ruler,
    draw_tick_lines,
)

_NOTCH = 120.0
_PLAYHEAD_PX = 8.0  # to either side of its line
_ZOOM_PER_NOTCH = 1.25


class TracksArea(QWidget):
    """Lanes are drawn once into a picture and kept while only the playhead moves.

    Signals:
        frame_sought(int): a click or drag on ruler or lanes.
        track_picked(int): a click on a lane, 0 below the last.
        cut_moved(int): the cut of a preview was dragged to a frame.
        axis_changed(object): zoomed or panned; the new :class:`TimeAxis`.
    """

    frame_sought = Signal(int)
    track_picked = Signal(int)
    cut_moved = Signal(int)
    axis_changed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: TimelineScene | None = None
        self._axis = TimeAxis(0.0, 1.0, 0.0, 1.0, 0)
        self._lives = np.zeros((0, 2), np.int64)  # first and end frame of each lane
        self._drawn: QPixmap | None = None
        self._dragging = ""
        self._drag_x = 0.0
        self.lanes_drawn = 0
        self.scroll_bar = QScrollBar(Qt.Orientation.Vertical, self)
        self.scroll_bar.valueChanged.connect(self._redraw)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(self.tr("Timeline"))

    # sizes

    @property
    def axis(self) -> TimeAxis:
        """The stretch of frames shown."""
        return self._axis

    @property
    def lane_height(self) -> float:
        """Of a row, by the font."""
        return self.fontMetrics().height() + 7.0

    @property
    def ruler_height(self) -> float:
        """Of the lines with times and frames, by the font, and of the playhead's handle."""
        return 2 * QFontMetricsF(scaled_font(self.font(), SMALL)).height() + PLAYHEAD_HEIGHT + 2

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Ruler and six lanes."""
        return QSize(800, round(self.ruler_height + 6 * self.lane_height))

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """Ruler and two lanes."""
        return QSize(320, round(self.ruler_height + 2 * self.lane_height))

    def _name_width(self) -> float:
        widest = 18 * QFontMetricsF(self.font()).averageCharWidth() + 24
        return min(widest, 0.3 * self.width())

    # scenes

    def show_scene(self, scene: TimelineScene) -> None:
        """Draw another instant; lanes only where they are other ones."""
        before, self._scene = self._scene, scene
        if before is None or before.frame_count != scene.frame_count:
            self._set_axis(self._axis.whole(scene.frame_count))
        elif before.frame != scene.frame and not self._dragging:
            self._set_axis(self._axis.showing(scene.frame))
        if before is None or before.lanes is not scene.lanes:
            self._lives = np.array([_life(lane) for lane in scene.lanes]).reshape(-1, 2)
            self._fit_scroll_bar()
        if before is not None and before.frame != scene.frame and not self._dragging:
            self._follow(scene.frame)
        self._update_moved(before, scene)

    def reveal(self, track: int) -> None:
        """Scroll to a track's lane."""
        lanes = self._scene.lanes if self._scene is not None else ()
        row = next((index for index, lane in enumerate(lanes) if lane.track == track), None)
        if row is not None:
            self._reveal_row(row)

    def _follow(self, frame: int) -> None:
        """Scroll to somebody who is there at a frame where nobody in sight is."""
        there = np.flatnonzero((self._lives[:, 0] <= frame) & (frame < self._lives[:, 1]))
        first, stop = self._rows_in_sight()
        if len(there) and not ((there >= first) & (there < stop)).any():
            self._reveal_row(int(there[-1]))
            self._reveal_row(int(there[0]))

    def _reveal_row(self, row: int) -> None:
        top, bar = round(row * self.lane_height), self.scroll_bar
        lowest = top - self._lanes_rect().height() + self.lane_height
        bar.setValue(min(max(bar.value(), round(lowest)), top))

    def _rows_in_sight(self) -> tuple[int, int]:
        """The lanes of which anything is seen, half-open; may go past the last."""
        offset, height = self.scroll_bar.value(), self.lane_height
        return int(offset // height), int((offset + self._lanes_rect().height()) // height) + 1

    def _set_axis(self, axis: TimeAxis) -> None:
        fitted = axis.resized(self._name_width(), self.width() - self._name_width() - 14)
        if fitted != self._axis:
            self._axis = fitted
            self._redraw()
            self.axis_changed.emit(fitted)

    def _redraw(self) -> None:
        self._drawn = None
        self.update()

    def _update_moved(self, before: TimelineScene | None, scene: TimelineScene) -> None:
        """Paint where the playhead was and is; all where something else changed, too."""
        if (
            before is None
            or before.lanes is not scene.lanes
            or before.message != scene.message
            or (before.tracked, before.cut, before.message)
            != (scene.tracked, scene.cut, scene.message)
        ):
            self._redraw()
            return
        for frame in (before.frame, scene.frame):
            left = self._axis.x_of(frame + 0.5) - _PLAYHEAD_PX
            self.update(QRectF(left, 0, 2 * _PLAYHEAD_PX, self.height()).toAlignedRect())

    def _lanes_rect(self) -> QRectF:
        return QRectF(self.rect()).adjusted(0, self.ruler_height, 0, 0)

    def _fit_scroll_bar(self) -> None:
        lanes = len(self._scene.lanes) if self._scene is not None else 0
        height = self._lanes_rect().height()
        bar = self.scroll_bar
        bar.setGeometry(QRect(self.width() - 12, round(self.ruler_height), 12, max(0, int(height))))
        bar.setRange(0, max(0, round(lanes * self.lane_height - height) + (1 if lanes else 0)))
        bar.setPageStep(max(1, round(height)))
        bar.setSingleStep(round(self.lane_height))
        bar.setVisible(lanes * self.lane_height > height)

    # drawing

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Lanes from their picture, then what moves."""
        theme, painter = current_theme(), QPainter(self)
        ratio = self.devicePixelRatioF()
        if self._drawn is None or self._drawn.size() != self.size() * ratio:
            self._drawn = self._draw_still(theme, ratio)
        painter.drawPixmap(0, 0, self._drawn)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._scene is not None:
            area = self._lanes_rect()
            painter.setClipRect(
                QRectF(self._axis.left - 6, 0, self._axis.width + 12, area.bottom())
            )
            if self._scene.cut is not None:
                draw_cut(painter, self._axis.x_of(self._scene.cut), area, theme)
            draw_playhead(painter, self._axis.x_of(self._scene.frame + 0.5), area, theme)
        painter.end()

    def _draw_still(self, theme: Theme, ratio: float) -> QPixmap:
        picture = QPixmap(self.size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(theme.surface)
        painter = QPainter(picture)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(self.font())
        if self._scene is not None:
            size = QSizeF(self.width(), self.ruler_height)
            draw_ruler(painter, self._scene, self._axis, size, theme)
            draw_tick_lines(painter, self._scene, self._axis, self._lanes_rect(), theme)
            painter.setFont(self.font())
            self._draw_lanes(painter, self._scene, theme)
        painter.end()
        return picture

    def _draw_lanes(self, painter: QPainter, scene: TimelineScene, theme: Theme) -> None:
        area = self._lanes_rect()
        self.lanes_drawn = 0
        if not scene.lanes:
            draw_message(painter, area, scene.message, theme)
            return
        painter.setClipRect(area)
        offset, height = self.scroll_bar.value(), self.lane_height
        first, stop = self._rows_in_sight()
        for index in range(first, min(stop, len(scene.lanes))):
            row = QRectF(0, area.top() + index * height - offset, self.width(), height)
            draw_lane(painter, scene.lanes[index], row, self._axis, theme)
            self.lanes_drawn += 1
        painter.setPen(QPen(theme.line, 1.0))
        edge = round(self._axis.left) - 0.5
        painter.drawLine(QPointF(edge, area.top()), QPointF(edge, area.bottom()))

    # gestures

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """The same frames over the new width."""
        super().resizeEvent(event)
        self._fit_scroll_bar()
        self._set_axis(self._axis)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow theme and font."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self._redraw()

    def wheelEvent(self, event: QWheelEvent) -> None:  # noqa: N802
        """Zoom in time; over the names or with Shift scroll the lanes; sideways pan."""
        steps = event.angleDelta()
        over_names = event.position().x() < self._axis.left
        if over_names or event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            moved = (steps.y() or steps.x()) / _NOTCH * 3 * self.lane_height
            self.scroll_bar.setValue(round(self.scroll_bar.value() - moved))
        elif abs(steps.x()) > abs(steps.y()):
            self._set_axis(self._axis.moved(-steps.x() / _NOTCH * 0.1 * self._axis.frames))
        else:
            factor = _ZOOM_PER_NOTCH ** (steps.y() / _NOTCH)
            self._set_axis(self._axis.zoomed(event.position().x(), factor))
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Start to seek, to move the cut or to pan; a lane is picked at once."""
        at = event.position()
        if event.button() is Qt.MouseButton.MiddleButton:
            self._dragging, self._drag_x = "pan", at.x()
        elif event.button() is Qt.MouseButton.LeftButton:
            if self._on_cut(at):
                self._dragging = "cut"
                return
            if at.y() > self.ruler_height:
                lane = self.lane_at(at)
                self.track_picked.emit(lane.track if lane is not None else 0)
            if at.x() >= self._axis.left:
                self._dragging = "seek"
                self.frame_sought.emit(self._axis.frame_at(at.x()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go on with what the press began."""
        x = event.position().x()
        if self._dragging == "seek":
            self.frame_sought.emit(self._axis.frame_at(x))
        elif self._dragging == "cut":
            self.cut_moved.emit(self._axis.frame_at(x + self._axis.px_per_frame / 2))
        elif self._dragging == "pan":
            self._set_axis(self._axis.moved((self._drag_x - x) / self._axis.px_per_frame))
            self._drag_x = x
        else:
            shape = Qt.CursorShape
            on_cut = self._on_cut(event.position())
            self.setCursor(shape.SplitHCursor if on_cut else shape.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: ARG002, N802
        """Done."""
        self._dragging = ""

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """On the ruler: the whole recording."""
        if event.position().y() <= self.ruler_height and self._scene is not None:
            self._set_axis(self._axis.whole(self._scene.frame_count))

    def _on_cut(self, at: QPointF) -> bool:
        cut = self._scene.cut if self._scene is not None else None
        below = at.y() > self.ruler_height
        return cut is not None and below and abs(at.x() - self._axis.x_of(cut)) <= 5

    def lane_at(self, at: QPointF) -> Lane | None:
        """The lane under a point."""
        if self._scene is None or at.y() <= self.ruler_height:
            return None
        row = int((at.y() - self.ruler_height + self.scroll_bar.value()) // self.lane_height)
        return self._scene.lanes[row] if row < len(self._scene.lanes) else None

    def event(self, event: QEvent) -> bool:
        """Tell the lane and the frame under the cursor."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            lane, x = self.lane_at(QPointF(event.pos())), event.pos().x()
            frame = self.tr("frame {0}").format(self._axis.frame_at(x))
            words = [lane.label] if lane is not None else []
            words += [frame] if x >= self._axis.left else []
            QToolTip.showText(event.globalPos(), ", ".join(words), self)
            return True
        return super().event(event)


def _life(lane: Lane) -> tuple[int, int]:
    return (int(lane.spans[0, 0]), int(lane.spans[-1, 1])) if len(lane.spans) else (0, 0)
