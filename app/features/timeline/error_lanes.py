"""Lanes of errors below those of people: stretches of misses and false alarms, other marks."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QFont, QFontMetricsF, QHelpEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from app.core.drawing.error_signs import draw_signs, error_colour
from app.core.i18n import time_text, tr
from app.core.look.theme import Theme, current_theme, scaled_font
from app.core.plots.axis import TimeAxis
from app.core.plots.strips import draw_strip
from app.core.scenes.ground_truth import ErrorLane, ErrorLanes
from app.core.widgets.spoken_description import SpokenDescription
from app.core.widgets.still_picture import StillPicture
from app.features.timeline.spoken_timeline import told_errors
from tracking.scoring import ErrorKind

_SMALL, _PAD_PX = 0.86, 3
_LEAST_SIZE = 0.7  # of the usual one, for a name that has little room
_REACH_PX = 5.0  # of the mouse
_APART_PX = 5.0
_FAINTEST = 0.45
_MOST_TOLD = 6
_STRIPS = (ErrorKind.MISS, ErrorKind.FALSE_ALARM)


class ErrorLanesView(QWidget):
    """Draws :class:`ErrorLanes`, once into a picture that stays while only the playhead moves.

    Signals:
        frame_sought(int): a click beside all errors, or a drag.
        event_sought(int, object): a click on one: its first frame, and the tracks it is about.
    """

    frame_sought = Signal(int)
    event_sought = Signal(int, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: ErrorLanes | None = None
        self._axis = TimeAxis(0.0, 1.0, 0.0, 1.0, 1)
        self._frame = 0
        self._still = StillPicture(self)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName(tr("Errors against ground truth"))
        self._spoken = SpokenDescription(self, lambda: told_errors(self._scene))
        self.hide()

    def show_scene(self, scene: ErrorLanes | None) -> None:
        """Show other errors, or none."""
        if scene is self._scene:
            return
        lanes = len(scene.lanes) if scene is not None else 0
        before = len(self._scene.lanes) if self._scene is not None else 0
        self._scene = scene
        self.setVisible(bool(lanes))
        if lanes != before:
            self.updateGeometry()
        self._spoken.changed()
        self._draw_anew()

    def show_axis(self, axis: TimeAxis) -> None:
        """Show the frames that the lanes of people show."""
        self._axis = axis
        self._draw_anew()

    def show_playhead(self, frame: int) -> None:
        """Put the playhead into another frame."""
        if frame != self._frame:
            self._frame = frame
            self.update()

    def _draw_anew(self) -> None:
        self._still.forget()
        self.update()

    # sizes

    @property
    def lane_height(self) -> float:
        """Of one lane, by the font."""
        return float(round(QFontMetricsF(scaled_font(self.font(), _SMALL)).height()))

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """All lanes."""
        lanes = len(self._scene.lanes) if self._scene is not None else 0
        return QSize(800, round(lanes * self.lane_height) + 2 * _PAD_PX)

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """The height is fixed."""
        return QSize(200, self.sizeHint().height())

    # drawing

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """The lanes from their picture, then the playhead."""
        theme, painter = current_theme(), QPainter(self)
        self._still.paint(painter, theme.surface, lambda still: self._draw_still(still, theme))
        x = self._axis.x_of(self._frame + 0.5)
        if self._axis.left <= x <= self._axis.left + self._axis.width:
            painter.setPen(QPen(theme.accent, 1.6))
            painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
        painter.end()

    def _draw_still(self, painter: QPainter, theme: Theme) -> None:
        painter.setPen(QPen(theme.line_strong, 1.0))
        painter.drawLine(QPointF(0, 0.5), QPointF(self.width(), 0.5))
        painter.setFont(scaled_font(self.font(), _SMALL))
        for row, lane in enumerate(self._scene.lanes if self._scene is not None else ()):
            top = _PAD_PX + row * self.lane_height
            self._draw_lane(painter, lane, top, theme)

    def _draw_lane(self, painter: QPainter, lane: ErrorLane, top: float, theme: Theme) -> None:
        axis, height = self._axis, self.lane_height
        self._draw_name(painter, lane, top, theme)
        band = QRectF(axis.left, top + 2, axis.width, height - 4)
        painter.fillRect(band, theme.sunken)
        painter.setClipRect(band.adjusted(-4, -2, 4, 2))
        if lane.kind in _STRIPS:
            columns = max(1, round(axis.width * self.devicePixelRatioF()))
            inked = _inked(lane.density, axis, columns)
            draw_strip(painter, inked, error_colour(lane.kind, theme), band)
        else:
            places = _places(lane.events.start, axis)
            middle = band.center().y()
            at = [QPointF(x, middle) for x in places]
            draw_signs(painter, lane.kind, at, 0.3 * height, theme)
        painter.setClipping(False)

    def _draw_name(self, painter: QPainter, lane: ErrorLane, top: float, theme: Theme) -> None:
        """The kind's sign, its name, and how many there are."""
        height = self.lane_height
        draw_signs(painter, lane.kind, [QPointF(17, top + height / 2)], 0.26 * height, theme)
        side = Qt.AlignmentFlag
        room = QRectF(30, top, self._axis.left - 36, height)
        painter.setPen(theme.text_muted)
        number = str(lane.count)
        painter.drawText(room, side.AlignRight | side.AlignVCenter, number)
        room.setRight(room.right() - painter.fontMetrics().horizontalAdvance(number) - 4)
        font, name = painter.font(), lane.name
        painter.setFont(_fitting(font, name, room.width()))
        name = painter.fontMetrics().elidedText(
            name, Qt.TextElideMode.ElideRight, int(room.width())
        )
        painter.setPen(theme.text)
        painter.drawText(room, side.AlignLeft | side.AlignVCenter, name)
        painter.setFont(font)

    # what is where

    def lane_at(self, y: float) -> ErrorLane | None:
        """The lane at a height."""
        lanes = self._scene.lanes if self._scene is not None else ()
        row = int((y - _PAD_PX) // self.lane_height)
        return lanes[row] if 0 <= row < len(lanes) else None

    def words_at(self, at: QPointF) -> str:
        """What is told of a place: the kind, the frame, the errors there."""
        lane, scene = self.lane_at(at.y()), self._scene
        if lane is None or scene is None:
            return ""
        if at.x() < self._axis.left:
            return tr(
                "{name}: {n} in {places} places. Click one to go there.\nIn the frames that are "
                "shown: {rate:.2f} a second",
                name=lane.name,
                n=lane.count,
                places=len(lane.events),
                rate=self._rate(lane, scene.fps),
            )
        frame = self._axis.frame_at(at.x())
        first, end = self._near(at.x())
        there = lane.events.at(first, end)
        lines = [
            tr("frame {0}, {1}").format(frame, time_text(frame / max(scene.fps, 1e-6))),
            *there.rows(np.arange(min(len(there), _MOST_TOLD))).words(),
        ]
        if len(there) > _MOST_TOLD:
            lines.append(tr("and {0} more").format(len(there) - _MOST_TOLD))
        return "\n".join(lines)

    def _rate(self, lane: ErrorLane, fps: float) -> float:
        """Errors a second in the frames that are shown."""
        axis = self._axis
        first = axis.frame_at(axis.left)
        end = min(int(np.ceil(axis.start + axis.frames)), len(lane.density))
        return float(lane.density[first:end].sum()) * fps / max(end - first, 1)

    def _near(self, x: float) -> tuple[int, int]:
        """The half-open frames within reach of the mouse."""
        return self._axis.frame_at(x - _REACH_PX), self._axis.frame_at(x + _REACH_PX) + 1

    # gestures

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go to the error there, else to the frame."""
        at = event.position()
        lane = self.lane_at(at.y())
        if at.x() < self._axis.left or event.button() is not Qt.MouseButton.LeftButton:
            return
        frame = self._axis.frame_at(at.x())
        there = lane.events.at(*self._near(at.x())) if lane is not None else None
        if there is None or not len(there):
            self.frame_sought.emit(frame)
            return
        # Inside a stretch one stays where one clicked.
        nearest = np.clip(frame, there.start, there.end - 1)
        best = int(np.abs(nearest - frame).argmin())
        self.event_sought.emit(int(nearest[best]), there.rows(np.array([best])).tracks)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go on with the button held."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.frame_sought.emit(self._axis.frame_at(event.position().x()))

    def event(self, event: QEvent) -> bool:
        """Tell what is under the mouse."""
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            QToolTip.showText(event.globalPos(), self.words_at(QPointF(event.pos())), self)
            return True
        return super().event(event)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow theme and font."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self.updateGeometry()
            self._draw_anew()


def _inked(density: NDArray[np.uint16], axis: TimeAxis, columns: int) -> NDArray[np.float64]:
    """(columns,) how strongly each column of pixels is inked: by the most errors at once in it."""
    if not len(density) or not density.any():
        return np.zeros(columns)
    first = np.clip(np.floor(axis.edges(columns)), 0, len(density)).astype(np.int64)
    # Behind the last frame stands nobody, so that the last column ends where it should.
    most = np.maximum.reduceat(np.append(density, 0), first)[:-1].astype(np.float64)
    share = most / float(density.max())
    return np.where(most > 0, _FAINTEST + (1.0 - _FAINTEST) * share, 0.0)


def _places(frames: NDArray[np.int64], axis: TimeAxis) -> list[float]:
    """Where ascending frames in view lie; of those that would cover each other the first."""
    xs = axis.xs_of(frames) + axis.px_per_frame / 2
    xs = xs[(xs >= axis.left - _APART_PX) & (xs <= axis.left + axis.width + _APART_PX)]
    _, first = np.unique(xs // _APART_PX, return_index=True)
    places: list[float] = xs[first].tolist()
    return places


def _fitting(font: QFont, text: str, room: float) -> QFont:
    """The font, smaller where that lets a text have room."""
    share = room / max(QFontMetricsF(font).horizontalAdvance(text), 1)
    return font if share >= 1 else scaled_font(font, max(0.93 * share, _LEAST_SIZE))
