"""What is said of somebody's parts: a card beside them, with a line to each rectangle."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen

from app.core.drawing.free_place import free_place
from app.core.drawing.part_signs import draw_off, draw_on
from app.core.drawing.viewport import Viewport
from app.core.look.theme import Theme, faded, scaled_font
from app.core.scenes.pictured_parts import CardLine, PartCard, Verdict

_PAD, _BAR_PX, _GAP, _APART_PX = 5.0, 4.0, 5.0, 8.0
_CASING = QColor(0, 0, 0, 150)
_FOOT = 0.86
_GROUND = 0.92


def draw_cards(
    painter: QPainter,
    cards: Sequence[PartCard],
    viewport: Viewport,
    area: QRectF,
    people: Mapping[int, QRectF],
    taken: Sequence[QRectF],
    theme: Theme,
) -> None:
    """Each card where it hides nobody, else less of it.

    Those of others are left out where there is no such place.

    Args:
        people: where everybody's box is on the widget. taken: names and notes that stand there.
    """
    kept = [*taken]
    for whole in cards:
        own = people.get(whole.track, QRectF())
        for line in whole.lines:
            own = own.united(viewport.rect(QRectF(*line.box)))
        if not own.intersects(area):
            continue
        others = [*kept, *(box for track, box in people.items() if track != whole.track)]
        card, place, hides = _fitting(painter.font(), whole, own, others, area)
        if card.selected or not hides:
            kept.append(place)
            rects = [viewport.rect(QRectF(*line.box)) for line in card.lines]
            _draw_leaders(painter, card, rects, place)
            _draw_card(painter, card, place, theme)


def _fitting(
    font: QFont, card: PartCard, own: QRectF, others: Sequence[QRectF], area: QRectF
) -> tuple[PartCard, QRectF, bool]:
    """As much of a card as has room without hiding anybody, its place, and whether it does."""
    chosen = tuple(line for line in card.lines if line.chosen) or card.lines
    shorter = (card, replace(card, foot=()), replace(card, foot=(), lines=chosen))
    for one in shorter if card.selected else shorter[:1]:
        place, hidden = free_place(_size(font, one), own, others, area)
        if hidden < 1.0:
            return one, place, False
    return one, place, True


def _size(font: QFont, card: PartCard) -> QSizeF:
    metrics = QFontMetricsF(font)
    small = QFontMetricsF(scaled_font(font, _FOOT))
    widths = [metrics.horizontalAdvance(line.text) + _lead(metrics, card) for line in card.lines]
    widths += [small.horizontalAdvance(text) for text in card.foot]
    height = len(card.lines) * metrics.height() + len(card.foot) * small.height()
    return QSizeF(max(widths) + 2 * _PAD + _BAR_PX, height + 2 * _PAD)


def _lead(metrics: QFontMetricsF, card: PartCard) -> float:
    """Room for the signs before the lines."""
    signs = any(line.verdict is not Verdict.NONE for line in card.lines)
    return metrics.ascent() + _GAP if signs else 0.0


def _draw_card(painter: QPainter, card: PartCard, place: QRectF, theme: Theme) -> None:
    font = painter.font()
    painter.setPen(QPen(QColor(*card.colour), 1.4))
    painter.setBrush(faded(theme.window, _GROUND))
    painter.drawRoundedRect(place, 4, 4)
    bar = QRectF(place.left(), place.top(), _BAR_PX, place.height())
    painter.fillRect(bar, QColor(*card.colour))
    height = QFontMetricsF(font).height()
    top, left = place.top() + _PAD, place.left() + _BAR_PX + _PAD
    lead = _lead(QFontMetricsF(font), card)
    for line in card.lines:
        _draw_line(painter, line, QRectF(left, top, place.right() - left, height), lead, theme)
        top += height
    painter.setFont(scaled_font(font, _FOOT))
    painter.setPen(theme.text_muted)
    for text in card.foot:
        row = QRectF(left, top, place.right() - left, painter.fontMetrics().height())
        painter.drawText(row, Qt.AlignmentFlag.AlignVCenter, text)
        top = row.bottom()
    painter.setFont(font)


def _draw_line(painter: QPainter, line: CardLine, row: QRectF, lead: float, theme: Theme) -> None:
    metrics = QFontMetricsF(painter.font())
    if line.chosen:
        painter.fillRect(row.adjusted(-2, 0, -2, 0), faded(theme.accent, 0.3))
    radius = 0.42 * metrics.ascent()
    at = QPointF(row.left() + radius, row.center().y())
    if line.verdict is Verdict.OFF:
        draw_off(painter, at, radius)
    elif line.verdict is Verdict.ON:
        draw_on(painter, at, radius, theme.text_muted)
    painter.setPen(theme.text)
    words = row.adjusted(lead, 0, 0, 0)
    painter.drawText(words, Qt.AlignmentFlag.AlignVCenter, line.text)


def _draw_leaders(
    painter: QPainter, card: PartCard, rects: Sequence[QRectF], place: QRectF
) -> None:
    """From each line of words to the rectangle it speaks of, in the person's colour."""
    lines = leaders(place, rects, QFontMetricsF(painter.font()).height())
    for pen in (QPen(_CASING, 2.8), QPen(QColor(*card.colour), 1.2)):
        painter.setPen(pen)
        painter.drawLines(lines)


def leaders(place: QRectF, rects: Sequence[QRectF], height: float) -> list[QLineF]:
    """A line from the edge of a card to the near edge of each rectangle that it does not cover.

    Args:
        place: of the card, whose rows are so high. rects: one a row.
    """
    lines = []
    for row, rect in enumerate(rects):
        y = place.top() + _PAD + (row + 0.5) * height
        middle, apart = rect.center(), (row - (len(rects) - 1) / 2) * _APART_PX
        above = place.bottom() <= rect.top()
        if place.left() >= rect.right():
            lines.append(QLineF(place.left(), y, rect.right(), middle.y()))
        elif place.right() <= rect.left():
            lines.append(QLineF(place.right(), y, rect.left(), middle.y()))
        elif above or place.top() >= rect.bottom():
            # From the edge that faces the rectangle: from a side it would run along the card.
            x = min(max(middle.x() + apart, place.left()), place.right())
            near, far = place.bottom() if above else place.top(), rect.top()
            end = min(max(x, rect.left()), rect.right())
            lines.append(QLineF(x, near, end, far if above else rect.bottom()))
    return lines
