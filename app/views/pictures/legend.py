"""What the colours laid over a picture mean."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.presenters.scenes import LegendEntry
from app.views.look.theme import Theme, faded

_PAD, _GAP = 7.0, 6.0


def draw_legend(
    painter: QPainter, entries: Sequence[LegendEntry], corner: QPointF, theme: Theme
) -> float:
    """A plate with a line for each colour, its lower left corner given; how high it stands."""
    if not entries:
        return 0.0
    metrics = QFontMetricsF(painter.font())
    line, side = metrics.height() + 2, metrics.ascent()
    words = max(metrics.horizontalAdvance(entry.text) for entry in entries)
    size = (words + side + _GAP + 2 * _PAD, len(entries) * line + 2 * _PAD)
    plate = QRectF(corner.x(), corner.y() - size[1], *size)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(faded(theme.window, 0.82))
    painter.drawRoundedRect(plate, 5, 5)
    for row, entry in enumerate(entries):
        inside = QRectF(plate.left() + _PAD, plate.top() + _PAD + row * line, size[0], line)
        painter.setPen(QPen(theme.line_strong, 1.0))
        swatch = QRectF(inside.left(), inside.center().y() - side / 2, side, side)
        if entry.opacity < 1.0:  # as it looks over the ground it lies on
            painter.setBrush(theme.sunken)
            painter.drawRoundedRect(swatch, 2, 2)
        painter.setBrush(faded(QColor(*entry.colour), entry.opacity))
        painter.drawRoundedRect(swatch, 2, 2)
        painter.setPen(theme.text)
        inside.setLeft(swatch.right() + _GAP)
        painter.drawText(inside, Qt.AlignmentFlag.AlignVCenter, entry.text)
    return plate.height()
