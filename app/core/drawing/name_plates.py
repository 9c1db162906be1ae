"""Name plates that stay readable on any picture."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.look.theme import Theme, faded, ink_on

PAD_PX = 10.0
"""Of a plate: what its sides leave empty, in all."""
_MOST_LETTERS, _MOST_WHOLE = 16, 40
"""Of a name on a plate, in average letters: a long one would hide others; where it hides nobody."""
_NOTE_FLAGS = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap


def plate_text(metrics: QFontMetricsF, name: str, *, alone: bool = False) -> str:
    """As much of a name as stands on a plate. alone: where nothing else needs the place."""
    room = (_MOST_WHOLE if alone else _MOST_LETTERS) * metrics.averageCharWidth()
    return metrics.elidedText(name, Qt.TextElideMode.ElideRight, room)


def plate_sizes(
    metrics: QFontMetricsF, texts: Sequence[str], pad: float = PAD_PX
) -> list[tuple[float, float]]:
    """Width and height of the plate for each text; pad: what its sides leave empty, in all."""
    height = metrics.height() + 0.4 * pad
    return [(metrics.horizontalAdvance(text) + pad, height) for text in texts]


def plate_rect(metrics: QFontMetricsF, text: str, corner: QPointF) -> QRectF:
    """The plate for a text, its lower left corner given."""
    ((width, height),) = plate_sizes(metrics, [text])
    return QRectF(corner.x(), corner.y() - height, width, height)


def note_size(metrics: QFontMetricsF, text: str, width: float) -> QSizeF:
    """Of the plate of a note that is no wider, over several lines where need be."""
    if not text:
        return QSizeF()
    room = QRectF(0, 0, width - PAD_PX, 1e4)
    words = metrics.boundingRect(room, _NOTE_FLAGS, text)
    return QSizeF(words.width() + PAD_PX, words.height() + 0.4 * PAD_PX)


def draw_plate(
    painter: QPainter, rect: QRectF, text: str, colour: QColor, emphasised: bool = False
) -> None:
    """A filled plate with text in whichever of black and white reads better."""
    painter.setPen(Qt.PenStyle.NoPen)
    if emphasised:
        painter.setBrush(QColor(255, 255, 255, 235))
        painter.drawRoundedRect(rect.adjusted(-1.5, -1.5, 1.5, 1.5), 5.5, 5.5)
    painter.setBrush(faded(colour, 1.0 if emphasised else 0.88))
    painter.drawRoundedRect(rect, 4, 4)
    painter.setPen(ink_on(colour))
    painter.drawText(rect, Qt.AlignmentFlag.AlignCenter, text)


def draw_leader(
    painter: QPainter, at: QPointF, plate: QRectF, radius: float, colour: QColor
) -> None:
    """A thin line from somebody's ring to their plate, where that stands some way off."""
    line = QLineF(at, plate.center())
    if line.length() > radius:
        painter.setPen(QPen(colour, 1.2))
        painter.drawLine(QLineF(line.pointAt(radius / line.length()), plate.center()))


def draw_name(
    painter: QPainter, rect: QRectF, text: str, colour: QColor, theme: Theme, picked: bool = False
) -> None:
    """What something that was drawn is called: the theme's ground and ink, framed in its colour.

    People's plates are filled with their colour; these are not, and stand off what they name.
    """
    painter.setPen(QPen(colour, 2.6 if picked else 1.4))
    painter.setBrush(faded(theme.window, 0.94))
    painter.drawRoundedRect(rect.adjusted(0.7, 0.7, -0.7, -0.7), 4, 4)
    painter.setPen(theme.text)
    painter.drawText(rect, Qt.AlignmentFlag.AlignCenter, text)


def draw_note(painter: QPainter, rect: QRectF, text: str, theme: Theme) -> None:
    """A quiet plate of the theme, e.g. which camera a picture is of."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(faded(theme.window, 0.82))
    painter.drawRoundedRect(rect, 5, 5)
    painter.setPen(theme.text)
    painter.drawText(rect, _NOTE_FLAGS, text)


def draw_message(painter: QPainter, area: QRectF, text: str, theme: Theme) -> None:
    """What to say, in the middle, where there is nothing to draw."""
    painter.setPen(theme.text_muted)
    painter.drawText(area.adjusted(24, 24, -24, -24), _NOTE_FLAGS, text)
