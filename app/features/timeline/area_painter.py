"""What stands in the area of the lanes: the rows in sight, and the edit that waits."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainter, QPen

from app.core.look.theme import Theme
from app.core.plots.axis import TimeAxis
from app.core.scenes import TimelineScene
from app.features.timeline.lanes import draw_lane, draw_reviewed
from app.features.timeline.rows import LaneRows
from app.features.timeline.ruler import draw_cut, draw_range


def draw_rows(
    painter: QPainter,
    scene: TimelineScene,
    rows: LaneRows,
    placed: tuple[QRectF, float, float],
    axis: TimeAxis,
    theme: Theme,
) -> int:
    """The lanes in sight; gives how many. `placed`: area, how far it is scrolled, lane height."""
    area, offset, height = placed
    painter.setClipRect(area)
    if scene.reviewed:
        draw_reviewed(painter, scene.reviewed, axis, area, theme)
    drawn = 0
    for at in range(int(offset // height), int((offset + area.height()) // height) + 1):
        lane = rows.lane(at)
        if lane is not None:
            row = QRectF(0, area.top() + at * height - offset, area.width(), height)
            draw_lane(painter, lane, row, axis, scene.tracked, theme)
            drawn += 1
    painter.setPen(QPen(theme.line, 1.0))
    edge = round(axis.left) - 0.5
    painter.drawLine(QPointF(edge, area.top()), QPointF(edge, area.bottom()))
    return drawn


def draw_edit(
    painter: QPainter, scene: TimelineScene, axis: TimeAxis, area: QRectF, theme: Theme
) -> None:
    """The range that is set, or where a previewed edit begins and ends."""
    first, end = scene.marked if scene.marked is not None else (0, None)
    end_x = axis.x_of(end) if end is not None else None
    if scene.cut is not None:
        draw_cut(painter, axis.x_of(scene.cut), end_x, area, theme)
    elif end_x is not None:
        draw_range(painter, (axis.x_of(first), end_x), area, theme)
