"""What the colours laid over a picture mean."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.look.theme import Theme, faded
from app.core.scenes import LegendEntry

_PAD, _GAP = 7.0, 6.0
_DASHES = [2.0, 1.5]
_OUTLINED = QColor(70, 70, 70)
"""Ground of an outline, in place of the picture's, so that a light one shows on any plate."""


def legend_size(metrics: QFontMetricsF, entries: Sequence[LegendEntry]) -> QSizeF:
    """Of the plate for these entries; empty where there are none."""
    if not entries:
        return QSizeF()
    words = max(metrics.horizontalAdvance(entry.text) for entry in entries)
    height = len(entries) * _line(metrics) + 2 * _PAD
    return QSizeF(words + metrics.ascent() + _GAP + 2 * _PAD, height)


def draw_legend(
    painter: QPainter, entries: Sequence[LegendEntry], corner: QPointF, theme: Theme
) -> float:
    """A plate with a line for each colour, its lower left corner given; how high it stands."""
    if not entries:
        return 0.0
    metrics = QFontMetricsF(painter.font())
    line, side = _line(metrics), metrics.ascent()
    plate = QRectF(QPointF(), legend_size(metrics, entries))
    plate.moveBottomLeft(corner)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(faded(theme.window, 0.82))
    painter.drawRoundedRect(plate, 5, 5)
    for row, entry in enumerate(entries):
        inside = QRectF(plate.left() + _PAD, plate.top() + _PAD + row * line, plate.width(), line)
        swatch = QRectF(inside.left(), inside.center().y() - side / 2, side, side)
        _draw_swatch(painter, entry, swatch, theme)
        painter.setPen(theme.text)
        inside.setLeft(swatch.right() + _GAP)
        painter.drawText(inside, Qt.AlignmentFlag.AlignVCenter, entry.text)
    return plate.height()


def _draw_swatch(painter: QPainter, entry: LegendEntry, swatch: QRectF, theme: Theme) -> None:
    """A spot of the colour as it looks over the ground that it lies on."""
    painter.setPen(QPen(theme.line_strong, 1.0))
    if entry.dashed:
        painter.setBrush(_OUTLINED)
        painter.drawRoundedRect(swatch, 2, 2)
        outline = QPen(QColor(*entry.colour), 1.2)
        outline.setDashPattern(_DASHES)
        painter.setPen(outline)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(swatch.adjusted(2.5, 2.5, -2.5, -2.5))
        return
    if entry.opacity < 1.0:
        painter.setBrush(theme.sunken)
        painter.drawRoundedRect(swatch, 2, 2)
    painter.setBrush(faded(QColor(*entry.colour), entry.opacity))
    painter.drawRoundedRect(swatch, 2, 2)


def _line(metrics: QFontMetricsF) -> float:
    return metrics.height() + 2
