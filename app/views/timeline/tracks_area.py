"""The upper part of the timeline: ruler, lanes, playhead."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QFontMetricsF,
    QHelpEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QToolTip, QWidget

from app.presenters.scenes import Lane, TimelineScene
from app.views.look.theme import Theme, current_theme, scaled_font
from app.views.pictures.name_plates import draw_message
from app.views.timeline.area_drawing import draw_edit, draw_rows
from app.views.timeline.axis import TimeAxis
from app.views.timeline.controls import TimelineControls
from app.views.timeline.gestures import Gestures
from app.views.timeline.hover import words_at
from app.views.timeline.lane_marks import mark_at
from app.views.timeline.rows import Arrangement, LaneRows
from app.views.timeline.ruler import (
    PLAYHEAD_HEIGHT,
    SMALL,
    draw_playhead,
    draw_ruler,
    draw_tick_lines,
)
from app.views.timeline.scroll_bars import BAR_PX, LanesBar, TimeBar
from app.views.widgets.still_picture import StillPicture

_PLAYHEAD_PX = 8.0  # to either side of its line
_RIGHT_PX = BAR_PX + 2
_LEAST_LOWERED = 0.7
"""Lanes lower than this share of their height would be hard to read."""


class TracksArea(QWidget):
    """Lanes are drawn once into a picture and kept while only the playhead moves.

    Signals:
        frame_sought(int): a click or drag on ruler or lanes.
        track_picked(int): a click on a lane, 0 below the last. track_added(int): with Shift.
        menu_asked(int, QPoint): a right click on a lane (0: below the last), or the menu key (-1:
            on who is selected); where on the screen.
        cut_moved(int): the cut of a preview was dragged to a frame.
        axis_changed(object): zoomed or panned; the new :class:`TimeAxis`.
    """

    frame_sought = Signal(int)
    track_picked = Signal(int)
    track_added = Signal(int)
    menu_asked = Signal(int, QPoint)
    cut_moved = Signal(int)
    axis_changed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: TimelineScene | None = None
        self._axis = TimeAxis(0.0, 1.0, 0.0, 1.0, 0)
        self._rows = LaneRows()
        self._lowered = 1.0
        self._still = StillPicture(self)
        self._gestures = Gestures(self)
        self.lanes_drawn = 0
        self.scroll_bar = LanesBar(self)
        self.scroll_bar.valueChanged.connect(self._redraw)
        self.time_bar = TimeBar(self)
        self.time_bar.valueChanged.connect(self._scroll_time)
        self.controls = TimelineControls(self)
        self._connect_controls()
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(self.tr("Timeline"))
        self.scroll_bar.setAccessibleName(self.tr("Scroll the lanes"))
        self.time_bar.setAccessibleName(self.tr("Scroll in time"))

    def _connect_controls(self) -> None:
        self.controls.zoomed.connect(self.zoom)
        self.controls.fit_all.connect(self.show_all)
        self.controls.fit_selected.connect(self.show_selected)
        self.controls.fit_second.connect(self.show_second)
        self.controls.arranged.connect(self._arrange)

    # sizes

    @property
    def axis(self) -> TimeAxis:
        """The stretch of frames shown."""
        return self._axis

    @property
    def cut(self) -> int | None:
        """The frame of a previewed edit's cut."""
        return self._scene.cut if self._scene is not None else None

    @property
    def lane_height(self) -> float:
        """Of a row, by the font and the user's choice; lower where all selected must be seen."""
        chosen = self.fontMetrics().height() * self.controls.arrangement.height.value
        return float(round(chosen * self._lowered))

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
        return float(round(min(widest, 0.3 * self.width())))

    # scenes

    def show_scene(self, scene: TimelineScene) -> None:
        """Draw another instant; lanes only where they are other ones."""
        before, self._scene = self._scene, scene
        if before is None or before.frame_count != scene.frame_count:
            self.set_axis(self._axis.whole(scene.frame_count))
        elif before.frame != scene.frame and not self._gestures.dragging:
            self.set_axis(self._axis.showing(scene.frame))
        if before is None or before.lanes is not scene.lanes:
            self._rows.take(scene.lanes)
            self._arrange(self.controls.arrangement)
        if before is not None and before.frame != scene.frame and not self._gestures.dragging:
            self._follow(scene.frame)
        self._update_moved(before, scene)

    def reveal(self, tracks: tuple[int, ...]) -> None:
        """Scroll to the lanes of these; a little lower ones where only so all of them are seen."""
        rows = [row for row in map(self._rows.row_of, tracks) if row is not None]
        self._lower_for(1 + max(rows) - min(rows) if rows else 1)
        for row in sorted(rows, reverse=True):
            self._reveal_row(row)

    def _lower_for(self, lanes: int) -> None:
        """Make lanes so low that so many are seen at once, where they stay readable."""
        before, self._lowered = self._lowered, 1.0
        share = self._lanes_rect().height() / (lanes * self.lane_height)
        if _LEAST_LOWERED <= share < 1.0:
            self._lowered = int(share * self.lane_height) / self.lane_height
        if self._lowered != before:
            self._fit_scroll_bars()
            self._redraw()

    def _follow(self, frame: int) -> None:
        """Scroll to somebody who is there at a frame where nobody in sight is."""
        there = self._rows.living_at(frame)
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

    def _arrange(self, arrangement: Arrangement) -> None:
        self._rows.arrange(arrangement, self._axis)
        self._fit_scroll_bars()
        self._redraw()

    # what is shown of the recording

    def set_axis(self, axis: TimeAxis) -> None:
        """Show other frames."""
        name_width = self._name_width()
        fitted = axis.resized(name_width, self.width() - name_width - _RIGHT_PX)
        if fitted == self._axis:
            return
        self._axis = fitted
        if self.controls.arrangement.in_view_only:
            self._rows.arrange(self.controls.arrangement, fitted)
        self._fit_scroll_bars()
        self._redraw()
        self.axis_changed.emit(fitted)

    def zoom(self, factor: float) -> None:
        """Closer around the playhead where it is in sight, else around the middle."""
        axis, frame = self._axis, self._scene.frame if self._scene is not None else 0
        inside = axis.start <= frame < axis.start + axis.frames
        x = axis.x_of(frame + 0.5) if inside else axis.left + axis.width / 2
        self.set_axis(axis.zoomed(x, factor))

    def pan(self, share: float) -> None:
        """Later, or earlier, by a share of the frames shown."""
        self.set_axis(self._axis.moved(share * self._axis.frames))

    def centre(self, frame: int) -> None:
        """As many frames as now, around another one."""
        self.set_axis(self._axis.around(frame, self._axis.frames))

    def scroll_lanes(self, lanes: float) -> None:
        """Further down by so many lanes, or up."""
        self.scroll_bar.setValue(round(self.scroll_bar.value() + lanes * self.lane_height))

    def show_all(self) -> None:
        """The whole recording."""
        if self._scene is not None:
            self.set_axis(self._axis.whole(self._scene.frame_count))

    def show_selected(self) -> None:
        """The selected track from its first to its last frame."""
        lanes = self._scene.lanes if self._scene is not None else ()
        chosen = [lane.spans for lane in lanes if lane.selected and len(lane.spans)]
        if chosen:
            first = min(int(spans[0, 0]) for spans in chosen)
            self.set_axis(self._axis.fitting(first, max(int(spans[-1, 1]) for spans in chosen)))

    def show_second(self) -> None:
        """A second around the playhead."""
        if self._scene is not None:
            self.set_axis(self._axis.around(self._scene.frame, self._scene.fps))

    def show_track_or_second(self, lane: Lane | None, frame: int) -> None:
        """All of a track; where it is shown already, or beside the lanes, a second there."""
        if self._scene is None:
            return
        second = self._axis.around(frame, self._scene.fps)
        if lane is None or not len(lane.spans):
            self.set_axis(second)
            return
        whole = self._axis.fitting(int(lane.spans[0, 0]), int(lane.spans[-1, 1]))
        shown = (whole.start, whole.frames) == (self._axis.start, self._axis.frames)
        self.set_axis(second if shown else whole)

    def _scroll_time(self, first: int) -> None:
        if first != int(self._axis.start):
            self.set_axis(self._axis.moved(first - self._axis.start))

    def _redraw(self) -> None:
        self._still.forget()
        self.update()

    def _update_moved(self, before: TimelineScene | None, scene: TimelineScene) -> None:
        """Paint where the playhead was and is; all where something else changed, too."""
        if (
            before is None
            or before.lanes is not scene.lanes
            or before.reviewed is not scene.reviewed
            or (before.tracked, before.cut, before.marked, before.message)
            != (scene.tracked, scene.cut, scene.marked, scene.message)
        ):
            self._redraw()
            return
        for frame in (before.frame, scene.frame):
            left = self._axis.x_of(frame + 0.5) - _PLAYHEAD_PX
            self.update(QRectF(left, 0, 2 * _PLAYHEAD_PX, self.height()).toAlignedRect())

    def _lanes_rect(self) -> QRectF:
        return QRectF(self.rect()).adjusted(0, self.ruler_height, 0, -self.time_bar.room)

    def _fit_scroll_bars(self) -> None:
        self.controls.setGeometry(0, 0, round(self._axis.left), round(self.ruler_height))
        self.time_bar.fit(self._axis, self.height())
        whole = len(self._rows) * self.lane_height
        self.scroll_bar.fit(self._lanes_rect(), whole, self.lane_height)

    # drawing

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Lanes from their picture, then what moves."""
        theme, painter = current_theme(), QPainter(self)
        self._still.paint(painter, theme.surface, lambda still: self._draw_still(still, theme))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._scene is not None:
            area = self._lanes_rect()
            painter.setClipRect(
                QRectF(self._axis.left - 6, 0, self._axis.width + 12, area.bottom())
            )
            draw_edit(painter, self._scene, self._axis, area, theme)
            draw_playhead(painter, self._axis.x_of(self._scene.frame + 0.5), area, theme)
        painter.end()

    def _draw_still(self, painter: QPainter, theme: Theme) -> None:
        painter.setFont(self.font())
        if self._scene is not None:
            size = QSizeF(self.width(), self.ruler_height)
            draw_ruler(painter, self._scene, self._axis, size, theme)
            draw_tick_lines(painter, self._scene, self._axis, self._lanes_rect(), theme)
            painter.setFont(self.font())
            self._draw_lanes(painter, self._scene, theme)

    def _draw_lanes(self, painter: QPainter, scene: TimelineScene, theme: Theme) -> None:
        area = self._lanes_rect()
        self.lanes_drawn = 0
        if not scene.lanes:
            draw_message(painter, area, scene.message, theme)
            return
        placed = area, float(self.scroll_bar.value()), self.lane_height
        self.lanes_drawn = draw_rows(painter, scene, self._rows, placed, self._axis, theme)
        if not len(self._rows):
            draw_message(painter, area, self.tr("No track is in the frames shown"), theme)

    # gestures

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """The same frames over the new width."""
        super().resizeEvent(event)
        self.set_axis(self._axis)
        self._fit_scroll_bars()

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow theme and font."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self._fit_scroll_bars()
            self._redraw()

    def wheelEvent(self, event: QWheelEvent) -> None:  # noqa: N802
        """Zoom, pan or scroll."""
        self._gestures.turn_wheel(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Seek, pick, pan or move the cut."""
        self._gestures.press(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go on."""
        self._gestures.move(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:  # noqa: ARG002, N802
        """Done."""
        self._gestures.release()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:  # noqa: N802
        """Ask for what can be done to the lane's track, or by key to who is selected."""
        by_key = event.reason() is QContextMenuEvent.Reason.Keyboard
        lane = self.lane_at(QPointF(event.pos()))
        track = -1 if by_key else lane.track if lane is not None else 0
        self.menu_asked.emit(track, event.globalPos())
        event.accept()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Zoom to what is there."""
        self._gestures.double_click(event)

    def lane_at(self, at: QPointF) -> Lane | None:
        """The lane under a point."""
        if not self._lanes_rect().contains(at):
            return None
        offset = at.y() - self.ruler_height + self.scroll_bar.value()
        return self._rows.lane(int(offset // self.lane_height))

    def words_at(self, at: QPointF) -> str:
        """What is told of a point: the track, the frame and its time, and what is there."""
        if self._scene is None:
            return ""
        lane, x = self.lane_at(at), at.x()
        beside = x < self._axis.left
        mark = mark_at(lane.marks, x, self._axis) if lane is not None and not beside else None
        frame = None if beside else self._axis.frame_at(x)
        return words_at(self._scene, lane, frame, mark)

    def event(self, event: QEvent) -> bool:
        """Tell what is under the mouse."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.words_at(QPointF(event.pos())), self)
            return True
        return super().event(event)
