"""How surely a part of a lane's person has failed, over the lane: which part, the threshold."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.core.look.theme import Theme, contrast, faded, scaled_font
from app.core.plots.axis import TimeAxis
from app.core.plots.curves import curve_path, score_span, stretches
from app.core.plots.strips import covered, draw_strip, opacity
from app.core.scenes.labels import PART_COLOURS
from app.core.scenes.part_curve import THRESHOLD, LaneScore
from app.core.scenes.part_names import part_name

_READABLE = 4.0
_SMALL, _LEAST_NAME, _GAP_PX = 0.84, 0.7, 4.0


def draw_score(
    painter: QPainter, score: LaneScore, place: QRectF, axis: TimeAxis, theme: Theme
) -> None:
    """A curve; above the dashed line the part has failed, and the ground is shaded there.

    The line runs where the person was tracked; before it stands which part it is.
    """
    curve = score.curve
    span = score_span([curve.score])
    columns = max(1, int(axis.width * painter.device().devicePixelRatioF()))
    shares = covered(stretches(curve.frames[curve.failed]), axis.edges(columns))
    draw_strip(painter, opacity(shares), faded(theme.danger, 0.35), place)
    level = (THRESHOLD - span[0]) / (span[1] - span[0])
    y = place.bottom() - level * place.height()
    painter.setPen(QPen(theme.danger, 1.0, Qt.PenStyle.DashLine))
    left = max(place.left(), axis.x_of(int(curve.frames[0])))
    right = min(place.right(), axis.x_of(int(curve.frames[-1]) + 1))
    painter.drawLine(QLineF(left, y, max(left, right), y))
    path = curve_path(curve.frames, curve.score, axis, place, span)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for colour, width in ((_casing(theme), 3.4), (_ink(theme, score.part), 1.6)):
        painter.setPen(QPen(colour, width))
        painter.drawPath(path)
    _draw_name(painter, score.part, left, place, theme)


def _draw_name(painter: QPainter, part: int, left: float, place: QRectF, theme: Theme) -> None:
    """The part's name before where its curve begins, else at the start of what is in view."""
    font = painter.font()
    painter.setFont(scaled_font(font, _SMALL))
    metrics = painter.fontMetrics()
    if place.height() >= _LEAST_NAME * metrics.height():
        width = metrics.horizontalAdvance(part_name(part)) + 6
        before = left - width - _GAP_PX
        at = before if before >= place.left() else max(left, place.left()) + 2
        plate = QRectF(at, place.top(), width, place.height())
        painter.fillRect(plate, _casing(theme))
        painter.setPen(_ink(theme, part))
        painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, part_name(part))
    painter.setFont(font)


def _ink(theme: Theme, part: int) -> QColor:
    """The part's colour, so dark (on a light ground) that thin lines and letters are read."""
    colour = theme.track(PART_COLOURS[part])
    while not theme.is_dark and contrast(colour, theme.sunken) < _READABLE:
        colour = colour.darker(110)
    return colour


def _casing(theme: Theme) -> QColor:
    return faded(theme.sunken, 0.85)
