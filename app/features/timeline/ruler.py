"""The timeline's ruler, and the lines that stand across the lanes."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QFontMetricsF, QPainter, QPen, QPolygonF

from app.core.look.theme import Theme, faded, scaled_font
from app.core.plots.axis import TimeAxis, ticks
from app.core.scenes import TimelineScene

SMALL = 0.85  # the ruler's font, of the widget's own
_PLAYHEAD = [(-5, -10), (5, -10), (5, -6), (0, -1), (-5, -6)]
PLAYHEAD_HEIGHT = 10.0  # it stands below the numbers and hides none


def draw_ruler(
    painter: QPainter, scene: TimelineScene, axis: TimeAxis, size: QSizeF, theme: Theme
) -> None:
    """Times, frames below them, and a line under what is tracked."""
    painter.fillRect(QRectF(0, 0, size.width(), size.height()), theme.window)
    painter.setFont(scaled_font(painter.font(), SMALL))
    metrics = QFontMetricsF(painter.font())
    for x, frame, text in _placed_ticks(scene, axis, metrics):
        painter.setPen(QPen(theme.line, 1.0))
        painter.drawLine(QPointF(x, 0), QPointF(x, size.height()))
        widest = max(metrics.horizontalAdvance(text), metrics.horizontalAdvance(str(frame)))
        if x + 4 + widest > size.width():
            continue
        painter.setPen(theme.text_muted)
        painter.drawText(QPointF(x + 4, 3 + metrics.ascent()), text)
        painter.setPen(theme.text_faint)
        painter.drawText(QPointF(x + 4, 3 + metrics.height() + metrics.ascent()), str(frame))
    painter.fillRect(QRectF(0, size.height() - 1, size.width(), 1), theme.line)
    _draw_tracked(painter, scene.tracked, axis, size.height(), theme)


def draw_tick_lines(
    painter: QPainter, scene: TimelineScene, axis: TimeAxis, area: QRectF, theme: Theme
) -> None:
    """The ruler's ticks going on through the lanes; the painter has the ruler's font."""
    metrics = QFontMetricsF(painter.font())
    painter.setPen(QPen(theme.line, 1.0))
    painter.drawLines(
        [QLineF(x, area.top(), x, area.bottom()) for x, _, _ in _placed_ticks(scene, axis, metrics)]
    )


def _placed_ticks(
    scene: TimelineScene, axis: TimeAxis, metrics: QFontMetricsF
) -> Iterator[tuple[float, int, str]]:
    least_px = metrics.horizontalAdvance("00:00:00") + 22
    for frame, text in ticks(axis, scene.fps, least_px):
        x = round(axis.x_of(frame)) + 0.5
        if x >= axis.left - 1:
            yield x, frame, text


def _draw_tracked(
    painter: QPainter, tracked: tuple[int, int], axis: TimeAxis, bottom: float, theme: Theme
) -> None:
    left = max(axis.x_of(tracked[0]), axis.left)
    right = min(axis.x_of(tracked[1]), axis.left + axis.width)
    if right > left:
        painter.fillRect(QRectF(left, bottom - 2, right - left, 2), faded(theme.accent, 0.7))


def draw_playhead(painter: QPainter, x: float, lanes: QRectF, theme: Theme) -> None:
    """A line through the lanes with a handle on the ruler."""
    painter.setPen(QPen(theme.accent, 1.6))
    painter.drawLine(QPointF(x, lanes.top() - 6), QPointF(x, lanes.bottom()))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme.accent)
    painter.drawPolygon(QPolygonF([QPointF(x + dx, lanes.top() + dy) for dx, dy in _PLAYHEAD]))


def draw_cut(painter: QPainter, x: float, end_x: float | None, lanes: QRectF, theme: Theme) -> None:
    """Where a previewed edit begins: a dashed line, and what it touches after it tinted."""
    stop = lanes.right() if end_x is None else end_x
    after = QRectF(QPointF(x, lanes.top()), QPointF(max(stop, x), lanes.bottom()))
    painter.fillRect(after, faded(theme.warning, 0.07 if end_x is None else 0.16))
    pen = QPen(theme.warning, 2.0)
    pen.setDashPattern([3.0, 2.0])
    painter.setPen(pen)
    painter.drawLine(after.topLeft(), after.bottomLeft())
    if end_x is not None:
        painter.drawLine(after.topRight(), after.bottomRight())


def draw_range(painter: QPainter, ends: tuple[float, float], lanes: QRectF, theme: Theme) -> None:
    """The range the user has set: tinted, with a bracket at each end."""
    left, right = ends
    painter.fillRect(
        QRectF(QPointF(left, lanes.top()), QPointF(right, lanes.bottom())),
        faded(theme.accent, 0.12),
    )
    painter.setPen(QPen(theme.accent, 2.0))
    for x, inward in ((left, 5.0), (right, -5.0)):
        painter.drawLine(QPointF(x, lanes.top()), QPointF(x, lanes.bottom()))
        for y in (lanes.top() + 1, lanes.bottom() - 1):
            painter.drawLine(QPointF(x, y), QPointF(x + inward, y))
