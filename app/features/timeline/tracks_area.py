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

from app.core.drawing.name_plates import draw_message
from app.core.i18n import tr
from app.core.look.theme import Theme, current_theme, scaled_font
from app.core.plots.axis import TimeAxis
from app.core.scenes import Lane, TimelineScene
from app.core.widgets.spoken_description import SpokenDescription
from app.core.widgets.still_picture import StillPicture
from app.features.timeline.area_painter import draw_edit, draw_rows
from app.features.timeline.controls import TimelineControls
from app.features.timeline.gestures import Gestures
from app.features.timeline.hover import words_at
from app.features.timeline.lane_marks import mark_at
from app.features.timeline.lane_scroll import LaneScroll
from app.features.timeline.rows import Arrangement, LaneRows
from app.features.timeline.ruler import (
    PLAYHEAD_HEIGHT,
    SMALL,
    draw_playhead,
    draw_ruler,
    draw_tick_lines,
)
from app.features.timeline.scroll_bars import BAR_PX, LanesBar, TimeBar
from app.features.timeline.spoken_timeline import told_timeline
from app.features.timeline.stretch import TimeStretch

_PLAYHEAD_PX = 8.0  # to either side of its line
_RIGHT_PX = BAR_PX + 2


class TracksArea(QWidget):
    """Lanes are drawn once into a picture and kept while only the playhead moves.

    Signals:
        frame_sought(int): a click or drag on ruler or lanes.
        track_picked(int): a click on a lane, 0 below the last. track_added(int): with Shift.
        menu_asked(int, QPoint): a right click on a lane (0: below the last), or the menu key (-1:
            on who is selected); where on the screen.
        cut_moved(int): the cut of a preview was dragged to a frame.

    Attributes:
        stretch: which frames are shown. lanes: which lanes are in sight.
    """

    frame_sought = Signal(int)
    track_picked = Signal(int)
    track_added = Signal(int)
    menu_asked = Signal(int, QPoint)
    cut_moved = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: TimelineScene | None = None
        self.stretch = TimeStretch(self)
        self.stretch.changed.connect(self._take_axis)
        self._rows = LaneRows()
        self._still = StillPicture(self)
        self._gestures = Gestures(self)
        self.lanes_drawn = 0
        self.scroll_bar = LanesBar(self)
        self.scroll_bar.valueChanged.connect(self._redraw)
        self.lanes = LaneScroll(self.scroll_bar, self._rows)
        self.time_bar = TimeBar(self)
        self.time_bar.valueChanged.connect(self.stretch.begin_at)
        self.controls = TimelineControls(self)
        self._connect_controls()
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(tr("Timeline"))
        self._spoken = SpokenDescription(self, self._words)
        self.scroll_bar.setAccessibleName(tr("Scroll the lanes"))
        self.time_bar.setAccessibleName(tr("Scroll in time"))
        self._fit_scroll_bars()

    def _connect_controls(self) -> None:
        self.controls.zoomed.connect(self.stretch.zoom)
        self.controls.fit_all.connect(self.stretch.show_all)
        self.controls.fit_selected.connect(self.stretch.show_selected)
        self.controls.fit_second.connect(self.stretch.show_second)
        self.controls.arranged.connect(self._arrange)

    # sizes

    @property
    def axis(self) -> TimeAxis:
        """The stretch of frames shown."""
        return self.stretch.axis

    @property
    def cut(self) -> int | None:
        """The frame of a previewed edit's cut."""
        return self._scene.cut if self._scene is not None else None

    @property
    def lane_height(self) -> float:
        """Of a lane now."""
        return self.lanes.height

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
        """Draw another frame; lanes only where they are other ones."""
        before, self._scene = self._scene, scene
        self._place_axis()
        self.stretch.take(scene, still=self._gestures.dragging)
        if before is None or before.lanes is not scene.lanes:
            self._rows.take(scene.lanes)
            self._arrange(self.controls.arrangement)
        if before is not None and before.frame != scene.frame and not self._gestures.dragging:
            self.lanes.follow(scene.frame)
        self._update_moved(before, scene)
        self._spoken.changed()

    def _words(self) -> str:
        return told_timeline(self._scene, self.axis)

    def reveal(self, tracks: tuple[int, ...]) -> None:
        """Scroll to the lanes of these."""
        if self.lanes.reveal(tracks):
            self._redraw()

    def _arrange(self, arrangement: Arrangement) -> None:
        self._rows.arrange(arrangement, self.axis)
        self._fit_scroll_bars()
        self._redraw()

    def _place_axis(self) -> None:
        """Give the frames the room there is beside the names."""
        names = self._name_width()
        self.stretch.place(names, self.width() - names - _RIGHT_PX)

    def _take_axis(self, axis: TimeAxis) -> None:
        """Other frames are shown."""
        if self.controls.arrangement.in_view_only:
            self._rows.arrange(self.controls.arrangement, axis)
        self._fit_scroll_bars()
        self._spoken.changed()
        self._redraw()

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
            left = self.axis.x_of(frame + 0.5) - _PLAYHEAD_PX
            self.update(QRectF(left, 0, 2 * _PLAYHEAD_PX, self.height()).toAlignedRect())

    def _lanes_rect(self) -> QRectF:
        return QRectF(self.rect()).adjusted(0, self.ruler_height, 0, -self.time_bar.room)

    def _fit_scroll_bars(self) -> None:
        self.controls.setGeometry(0, 0, round(self.axis.left), round(self.ruler_height))
        self.time_bar.fit(self.axis, self.height())
        self.lanes.fit(self._lanes_rect(), self._chosen_height())

    def _chosen_height(self) -> float:
        """Of a lane, by the font and the user's choice."""
        return self.fontMetrics().height() * self.controls.arrangement.height.value

    # drawing

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Lanes from their picture, then what moves."""
        theme, painter = current_theme(), QPainter(self)
        self._still.paint(painter, theme.surface, lambda still: self._draw_still(still, theme))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self._scene is not None:
            area = self._lanes_rect()
            painter.setClipRect(QRectF(self.axis.left - 6, 0, self.axis.width + 12, area.bottom()))
            draw_edit(painter, self._scene, self.axis, area, theme)
            draw_playhead(painter, self.axis.x_of(self._scene.frame + 0.5), area, theme)
        painter.end()

    def _draw_still(self, painter: QPainter, theme: Theme) -> None:
        painter.setFont(self.font())
        if self._scene is not None:
            size = QSizeF(self.width(), self.ruler_height)
            draw_ruler(painter, self._scene, self.axis, size, theme)
            draw_tick_lines(painter, self._scene, self.axis, self._lanes_rect(), theme)
            painter.setFont(self.font())
            self._draw_lanes(painter, self._scene, theme)

    def _draw_lanes(self, painter: QPainter, scene: TimelineScene, theme: Theme) -> None:
        area = self._lanes_rect()
        self.lanes_drawn = 0
        if not scene.lanes:
            draw_message(painter, area, scene.message, theme)
            return
        placed = area, self.lanes.offset, self.lane_height
        self.lanes_drawn = draw_rows(painter, scene, self._rows, placed, self.axis, theme)
        if not len(self._rows):
            draw_message(painter, area, tr("No track is in the frames shown"), theme)

    # gestures

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """The same frames over the new width."""
        super().resizeEvent(event)
        self._place_axis()
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
        return self._rows.lane(self.lanes.row_at(at.y() - self.ruler_height))

    def words_at(self, at: QPointF) -> str:
        """What is told of a point: the track, the frame and its time, and what is there."""
        if self._scene is None:
            return ""
        lane, x = self.lane_at(at), at.x()
        beside = x < self.axis.left
        mark = mark_at(lane.marks, x, self.axis) if lane is not None and not beside else None
        frame = None if beside else self.axis.frame_at(x)
        return words_at(self._scene, lane, frame, mark)

    def event(self, event: QEvent) -> bool:
        """Tell what is under the mouse."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.words_at(QPointF(event.pos())), self)
            return True
        return super().event(event)
