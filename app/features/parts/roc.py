"""Curves of found failures over false alarms, with the operating point to be moved."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFontMetricsF, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.core.drawing.viewport import Points, polygon
from app.core.i18n import tr
from app.core.look.theme import Theme, current_theme, scaled_font
from app.core.plots.curves import PART_LINES
from app.core.scenes.labels import PART_COLOURS
from app.features.parts.training_result import ResultScene, RocCurve

_WAYS = {Qt.Key.Key_Left: -1, Qt.Key.Key_Down: -1, Qt.Key.Key_Right: 1, Qt.Key.Key_Up: 1}
_SMALL = 0.88
_MOST_POINTS = 600


class RocPlot(QWidget):
    """Draws the curves of a :class:`ResultScene`.

    Dragging, or the arrow keys, move the operating point.

    Signals:
        put(float): at most this share of false alarms. stepped(int): one more (1) or less (-1).
    """

    put = Signal(float)
    stepped = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene: ResultScene | None = None
        self._most = 0.2
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.setAccessibleName(tr("Failures found over false alarms"))

    def show_scene(self, scene: ResultScene) -> None:
        """Draw another operating point."""
        self._scene = scene
        self.setAccessibleDescription("\n".join(one.said for one in scene.figures))
        self.update()

    def show_up_to(self, most: float) -> None:
        """Draw false alarms from 0 to this share."""
        self._most = most
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Nearly square."""
        side = 17 * self.fontMetrics().height()
        return QSize(round(1.15 * side), side)

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """Still readable."""
        return self.sizeHint() * 0.7

    def _area(self) -> QRectF:
        line = QFontMetricsF(scaled_font(self.font(), _SMALL)).height()
        letters = QFontMetricsF(self.font()).averageCharWidth()
        return QRectF(self.rect()).adjusted(9 * letters, 1.7 * line, -4 * letters, -3.2 * line)

    def _at(self, alarms: float, found: float) -> QPointF:
        area = self._area()
        share = min(alarms / self._most, 1.0)
        return QPointF(area.left() + share * area.width(), area.bottom() - found * area.height())

    def tick_labels(self) -> list[tuple[QRectF, str]]:
        """Shares along both axes, where they are written; fewer where they would touch."""
        area, metrics = self._area(), QFontMetricsF(scaled_font(self.font(), _SMALL))
        line, gap = metrics.height(), metrics.averageCharWidth()
        alarms = [f"{100 * fifth / 5 * self._most:.3g} %" for fifth in range(6)]
        found = [f"{20 * fifth} %" for fifth in range(6)]
        widest = max(map(metrics.horizontalAdvance, alarms)) + gap
        below = []
        for fifth in _with_room(area.width() / 5, widest):
            x = area.left() + fifth / 5 * area.width()
            place = QRectF(x - widest / 2, area.bottom() + 0.6 * line, widest, line)
            below.append((place, alarms[fifth]))
        beside = []
        for fifth in _with_room(area.height() / 5, line):
            y = area.bottom() - fifth / 5 * area.height()
            width = metrics.horizontalAdvance(found[fifth]) + 1
            place = QRectF(area.left() - 6 - width, y - line / 2, width, line)
            beside.append((place, found[fifth]))
        return below + beside

    # drawing

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Grid, curves, operating points."""
        theme, painter = current_theme(), QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self._area(), theme.sunken)
        painter.setFont(scaled_font(self.font(), _SMALL))
        self._draw_axes(painter, theme)
        if self._scene is not None:
            painter.save()
            painter.setClipRect(self._area().adjusted(-6, -6, 6, 6))
            for part, curve in enumerate(self._scene.curves):
                self._draw_curve(painter, part, curve, theme)
            painter.restore()
        if self.hasFocus():
            painter.setPen(QPen(theme.accent, 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(QRectF(self.rect()).adjusted(1, 1, -1, -1))
        painter.end()

    def _draw_axes(self, painter: QPainter, theme: Theme) -> None:
        area, flags = self._area(), Qt.AlignmentFlag
        line = painter.fontMetrics().height()
        for fifth in range(6):
            share = fifth / 5
            x = area.left() + share * area.width()
            y = area.bottom() - share * area.height()
            painter.setPen(QPen(theme.grid_major, 1.0))
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()))
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
        painter.setPen(theme.text_muted)
        for place, text in self.tick_labels():
            painter.drawText(place, flags.AlignCenter, text)
        title = QRectF(area.left(), area.bottom() + 1.7 * line, area.width(), 1.3 * line)
        painter.setPen(theme.text)
        painter.drawText(title, flags.AlignCenter, tr("false alarms"))
        above = QRectF(area.left(), area.top() - 1.4 * line, area.width(), 1.2 * line)
        painter.drawText(above, flags.AlignLeft, tr("failures found"))

    def _draw_curve(self, painter: QPainter, part: int, curve: RocCurve, theme: Theme) -> None:
        colour, meant = theme.track(PART_COLOURS[part]), self._is_meant(part)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(colour, 2.6 if meant else 1.6, PART_LINES[part]))
        painter.drawPolyline(polygon(self._places(curve)))
        at = self._at(*curve.at) if np.isfinite(curve.at).all() else None
        if at is not None:
            painter.setPen(QPen(QColor(20, 20, 20), 1.4))
            painter.setBrush(colour)
            painter.drawEllipse(at, 7.0 if meant else 5.0, 7.0 if meant else 5.0)

    def _places(self, curve: RocCurve) -> Points:
        """(p, 2) the curve on the widget, from nothing found on."""
        area = self._area()
        stop = int(np.searchsorted(curve.false_alarms, self._most, "right")) + 1
        kept = np.unique(np.linspace(0, max(stop - 1, 0), _MOST_POINTS).round().astype(int))
        kept = kept[kept < len(curve.found)]
        alarms = np.append(0.0, curve.false_alarms[kept]) / self._most
        found = np.append(0.0, curve.found[kept])
        x, y = area.left() + alarms * area.width(), area.bottom() - found * area.height()
        return np.column_stack((x, y))

    def _is_meant(self, part: int) -> bool:
        return self._scene is not None and self._scene.chosen in (-1, part)

    # gestures

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        """Put the point under the mouse."""
        if event.button() is Qt.MouseButton.LeftButton:
            self._put(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Drag it."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._put(event.position())

    def _put(self, at: QPointF) -> None:
        area = self._area()
        share = (at.x() - area.left()) / max(area.width(), 1.0)
        self.put.emit(min(max(share, 0.0), 1.0) * self._most)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Step by one false alarm."""
        way = _WAYS.get(Qt.Key(event.key()))
        if way is None:
            super().keyPressEvent(event)
        else:
            self.stepped.emit(way)


def _with_room(between: float, size: float) -> range:
    """Which of six ticks, so far from each other, have a label of a size: evenly, 0 among them."""
    return range(0, 6, next((step for step in (1, 2) if step * between > size), 5))
