"""How surely a part of a lane's person has failed, drawn over the lane, with the threshold."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from app.presenters.labelling.labelling_scene import PART_COLOURS
from app.presenters.parts.part_curve import THRESHOLD, LaneScore
from app.views.look.theme import Theme, faded
from app.views.timeline.axis import TimeAxis
from app.views.timeline.curves import curve_path, score_span, stretches
from app.views.timeline.strips import covered, draw_strip, opacity


def draw_score(
    painter: QPainter, score: LaneScore, place: QRectF, axis: TimeAxis, theme: Theme
) -> None:
    """A curve; above the dashed line the part has failed, and the ground is shaded there."""
    curve = score.curve
    span = score_span([curve.score])
    columns = max(1, int(axis.width * painter.device().devicePixelRatioF()))
    shares = covered(stretches(curve.frames[curve.failed]), axis.edges(columns))
    draw_strip(painter, opacity(shares), faded(theme.danger, 0.35), place)
    level = (THRESHOLD - span[0]) / (span[1] - span[0])
    y = place.bottom() - level * place.height()
    painter.setPen(QPen(theme.danger, 1.0, Qt.PenStyle.DashLine))
    painter.drawLine(QLineF(place.left(), y, place.right(), y))
    path = curve_path(curve.frames, curve.score, axis, place, span)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for colour, width in ((_casing(theme), 3.4), (theme.track(PART_COLOURS[score.part]), 1.6)):
        painter.setPen(QPen(colour, width))
        painter.drawPath(path)


def _casing(theme: Theme) -> QColor:
    return faded(theme.sunken, 0.85)
