"""Drawing the lanes: a track a row.

Solid where it was measured, dotted where it was predicted, an outline where it is interpolated.
"""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QFontMetricsF, QPainter

from app.core.look.theme import Theme, faded
from app.core.plots.axis import TimeAxis
from app.core.plots.strips import covered, covered_by_kind, dotted, draw_strip, opacity
from app.core.scenes import Lane, SpanKind
from app.features.timeline.lane_marks import draw_ends, draw_keyframes, draw_marks, shown_marks
from app.features.timeline.lane_score import draw_score

_BAR, _DOTS = 0.52, 0.2  # of a lane's height
_BELOW_SCORE = 0.2  # the bar, where a curve stands above it
_RAIL_PX = 1.5
_BETWEEN_RAILS = 0.22
_REVIEWED = 0.16
_REVIEWED_PX = 2.0
_CHOSEN_PX = 4.0  # a bar before the names of those selected
_LEAST_NAME = 0.85  # of a line of text: lower lanes bear no name


def draw_lane(
    painter: QPainter,
    lane: Lane,
    row: QRectF,
    axis: TimeAxis,
    tracked: tuple[int, int],
    theme: Theme,
) -> None:
    """One track in its row; `row` spans the whole width, name and bar."""
    if lane.selected:
        painter.fillRect(row, theme.selection)
        painter.fillRect(QRectF(row.left(), row.top(), _CHOSEN_PX, row.height()), theme.accent)
    _draw_name(painter, lane, row, axis, theme)
    painter.save()
    bars = QRectF(axis.left, row.top(), axis.width, row.height())
    painter.setClipRect(bars, Qt.ClipOperation.IntersectClip)  # a row may be half under the ruler
    if lane.reviewed:
        draw_reviewed(painter, lane.reviewed, axis, row, theme)
    bar = QRectF(axis.left, row.top(), axis.width, _BAR * row.height())
    bar.moveCenter(QPointF(bar.center().x(), row.center().y()))
    if lane.score is not None:
        bar = QRectF(axis.left, 0, axis.width, _BELOW_SCORE * row.height())
        bar.moveBottom(row.bottom() - 1)
    _draw_bar(painter, lane, bar, row.height(), axis, theme)
    if lane.score is not None:
        above = QRectF(axis.left, row.top() + 1, axis.width, bar.top() - row.top() - 2)
        draw_score(painter, lane.score, above, axis, theme)
    draw_ends(painter, lane, row, axis, tracked, theme)
    draw_keyframes(painter, lane, row, axis, theme)
    draw_marks(painter, shown_marks(lane), row, axis, theme)
    painter.restore()


def draw_reviewed(
    painter: QPainter,
    reviewed: tuple[tuple[int, int], ...],
    axis: TimeAxis,
    place: QRectF,
    theme: Theme,
    above_px: float = 0.0,
) -> None:
    """Shade and underline what a person has looked at; the line so far above the place's foot."""
    ranges = np.array(_apart(reviewed), np.int64)
    shares = covered(ranges, axis.edges(_columns(painter, axis)))
    across = QRectF(axis.left, place.top(), axis.width, place.height())
    draw_strip(painter, opacity(shares), faded(theme.good, _REVIEWED), across)
    foot = across.bottom() - above_px - _REVIEWED_PX
    line = QRectF(axis.left, foot, axis.width, _REVIEWED_PX)
    draw_strip(painter, opacity(shares), theme.good, line)


def _apart(ranges: tuple[tuple[int, int], ...]) -> list[tuple[int, int]]:
    """The ranges ascending, those that touch or overlap as one."""
    whole: list[tuple[int, int]] = []
    for start, end in sorted(ranges):
        if whole and start <= whole[-1][1]:
            whole[-1] = whole[-1][0], max(end, whole[-1][1])
        else:
            whole.append((start, end))
    return whole


def _columns(painter: QPainter, axis: TimeAxis) -> int:
    return max(1, int(axis.width * painter.device().devicePixelRatioF()))


def _draw_bar(
    painter: QPainter, lane: Lane, bar: QRectF, row_height: float, axis: TimeAxis, theme: Theme
) -> None:
    colour, ratio = theme.track(lane.colour), painter.device().devicePixelRatioF()
    shares = covered_by_kind(lane.spans, axis, _columns(painter, axis))
    if SpanKind.PREDICTED in shares:
        dots = QRectF(bar.left(), 0, bar.width(), max(2.0, _DOTS * row_height))
        dots.moveCenter(bar.center())
        draw_strip(painter, dotted(opacity(shares[SpanKind.PREDICTED]), ratio), colour, dots)
    if SpanKind.INTERPOLATED in shares:
        inked = opacity(shares[SpanKind.INTERPOLATED])
        draw_strip(painter, inked, faded(colour, _BETWEEN_RAILS), bar)
        for top in (bar.top(), bar.bottom() - _RAIL_PX):
            draw_strip(painter, inked, colour, QRectF(bar.left(), top, bar.width(), _RAIL_PX))
    if SpanKind.MEASURED in shares:
        draw_strip(painter, opacity(shares[SpanKind.MEASURED]), colour, bar)


def _draw_name(painter: QPainter, lane: Lane, row: QRectF, axis: TimeAxis, theme: Theme) -> None:
    metrics = QFontMetricsF(painter.font())
    radius = min(metrics.ascent() * 0.32, 0.36 * row.height())
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(theme.track(lane.colour))
    painter.drawEllipse(QPointF(row.left() + 12 + radius, row.center().y()), radius, radius)
    if row.height() < _LEAST_NAME * metrics.height():
        return
    left = row.left() + 20 + 2 * radius
    place = QRectF(left, row.top(), axis.left - left - 8, row.height())
    painter.setPen(theme.text if lane.selected else theme.text_muted)
    text = metrics.elidedText(lane.label, Qt.TextElideMode.ElideRight, place.width())
    flags = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
    painter.drawText(place, flags, text)
