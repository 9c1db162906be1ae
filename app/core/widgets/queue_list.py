"""Rows of the review queue: what, who, when, and below it why."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QPointF,
    QRectF,
    QSize,
    Qt,
)
from PySide6.QtGui import QFont, QFontMetricsF, QPainter
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem

from app.core.i18n import joined_text, tr
from app.core.look.theme import current_theme, line_height, scaled_font
from app.core.scenes.queue_rows import ReviewPerson, ReviewRow
from app.core.widgets.abstract import AbstractQt
from app.core.widgets.command_list import draw_row_ground

ITEM = Qt.ItemDataRole.UserRole
_PAD, _SIDE, _GAP = 4, 8, 6
_SMALL = 0.88
_LEAST_TITLE = 0.3
"""Of a row's first line: so much stays of its title where people's names are long."""
_Index = QModelIndex | QPersistentModelIndex


class ReviewModel(QAbstractListModel):
    """The review items of a queue; another queue is taken as a whole, however long it is."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._items: tuple[ReviewRow, ...] = ()

    def take(self, items: tuple[ReviewRow, ...]) -> None:
        """Show another queue."""
        if items is not self._items:
            self.beginResetModel()
            self._items = items
            self.endResetModel()

    def item(self, row: int) -> ReviewRow:
        """The review item in a row."""
        return self._items[row]

    def rowCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008, N802 - Qt's name
        """How many there are."""
        return 0 if parent.isValid() else len(self._items)

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """The item, its words, or all its reasons as the tooltip."""
        item = self._items[index.row()]
        if role == ITEM:
            return item
        if role == Qt.ItemDataRole.ToolTipRole:
            return "\n".join((item.why, *item.others, _likely(item)))
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            who = joined_text(", ", (person.label for person in item.people))
            return f"{item.title} {who} {item.when}: {item.why}"
        return None


def _likely(item: ReviewRow) -> str:
    return tr("frame {0}, {1:.0f} % likely").format(item.frame, 100 * item.likelihood)


def row_height(font: QFont, lower_lines: int = 1) -> int:
    """A line, and below it so many smaller ones."""
    small = scaled_font(font, _SMALL)
    return line_height(font) + lower_lines * line_height(small) + 2 * _PAD


def lower_lines(font: QFont, text: str, width: float) -> int:
    """How many lines, 1 or 2, a text takes below the first line of a row so wide."""
    small = QFontMetricsF(scaled_font(font, _SMALL))
    return 1 if small.horizontalAdvance(text) <= width - 2 * _SIDE else 2


class PeopleDelegate(QStyledItemDelegate, metaclass=AbstractQt):
    """Rows of two lines: what, who and when; below it, smaller, why.

    A delegate of a kind says with `below` what stands in the second line, and may draw something
    at the left of both with `lead`.

    Attributes:
        lower_lines: of how many lines the words below are in every row.
    """

    lower_lines = 1

    @abstractmethod
    def below(self, item: Any) -> str:
        """The second line."""

    def lead(self, painter: QPainter, item: Any, inner: QRectF) -> None:
        """Draw at the left and move the left edge of what is left."""

    def sizeHint(self, option: QStyleOptionViewItem, index: _Index) -> QSize:  # noqa: N802
        """As many lines as every row has."""
        del index
        return QSize(64, row_height(option.font, self.lower_lines))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: _Index) -> None:
        """Ground, what leads, time, kind, people, reason."""
        item = index.data(ITEM)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        draw_row_ground(painter, option)
        inner = QRectF(option.rect).adjusted(_SIDE, _PAD, -_SIDE, -_PAD)
        self.lead(painter, item, inner)
        line = QRectF(inner)
        line.setHeight(line_height(option.font))
        inner.setTop(line.bottom())
        self._draw_first(painter, item, line, option.font)
        painter.setFont(scaled_font(option.font, _SMALL))
        painter.setPen(current_theme().text_muted)
        if self.lower_lines == 1:
            _draw_elided(painter, inner, self.below(item))
        else:
            painter.drawText(inner, _WRAPPED, self.below(item))
        painter.restore()

    def _draw_first(self, painter: QPainter, item: Any, line: QRectF, font: QFont) -> None:
        theme, small = current_theme(), scaled_font(font, _SMALL)
        bold, plain = scaled_font(font, 1.0, bold=True), QFontMetricsF(font)
        title = QFontMetricsF(bold).horizontalAdvance(item.title) + 2 * _GAP
        labels = [plain.horizontalAdvance(one.label) for one in item.people]
        signs = len(labels) * (2 * _radius(plain) + 2 * _GAP)
        room = line.width() - title - signs - sum(labels) - _GAP
        when = shown_time(QFontMetricsF(small), item.when, room)
        painter.setFont(small)
        painter.setPen(theme.text_muted)
        painter.drawText(line, _RIGHT, when)
        line.setRight(line.right() - QFontMetricsF(small).horizontalAdvance(when) - _GAP)
        title = max(min(title, line.width() - signs - sum(labels)), _LEAST_TITLE * line.width())
        painter.setFont(bold)
        painter.setPen(theme.text)
        place = QRectF(line.left(), line.top(), title - 2 * _GAP + 1, line.height())
        _draw_elided(painter, place, item.title)
        line.setLeft(line.left() + min(title, line.width()))
        painter.setFont(font)
        widths = shares(labels, line.width() - signs)
        for person, width in zip(item.people, widths, strict=True):
            self._draw_person(painter, person, line, width)

    def _draw_person(
        self, painter: QPainter, person: ReviewPerson, line: QRectF, width: float
    ) -> None:
        """A spot in their colour and their name, so wide; `line` is left with the room behind."""
        theme = current_theme()
        radius = _radius(QFontMetricsF(painter.font()))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.track(person.colour))
        painter.drawEllipse(QPointF(line.left() + radius, line.center().y()), radius, radius)
        line.setLeft(line.left() + 2 * radius + _GAP / 2)
        painter.setPen(theme.text)
        text, number = person.label, str(person.track)
        whole = painter.fontMetrics().horizontalAdvance(number)
        if width < painter.fontMetrics().horizontalAdvance(f"{number}\u2026") and text != number:
            text, width = number, max(width, whole)  # half a number is somebody else's
        _draw_elided(painter, QRectF(line.left(), line.top(), width + 1, line.height()), text)
        line.setLeft(line.left() + width + 1.5 * _GAP)


def shown_time(metrics: QFontMetricsF, when: str, room: float) -> str:
    """When something is; of a span where there is no room for it when it begins, at least.

    All of it stands in the tooltip: what and who come first.
    """
    begin, space, _ = when.partition(" ")
    if not space or metrics.horizontalAdvance(when) <= room:
        return when
    return f"{begin}\u2026"


def _radius(metrics: QFontMetricsF) -> float:
    """Of the spot before a name."""
    return metrics.ascent() * 0.32


def shares(wanted: Sequence[float], room: float) -> list[float]:
    """What each gets of a room: what it wants, or where that is too much, as much as the others.

    Who wants less than an even share leaves the rest to the others.
    """
    given = [0.0] * len(wanted)
    left = max(0.0, room)
    for after, number in enumerate(sorted(range(len(wanted)), key=lambda one: wanted[one])):
        given[number] = min(wanted[number], left / (len(wanted) - after))
        left -= given[number]
    return given


class ReviewDelegate(PeopleDelegate):
    """Draws a :class:`ReviewRow`, its reason on two lines."""

    lower_lines = 2

    def below(self, item: ReviewRow) -> str:
        """Why it is listed."""
        return item.why


_LEFT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
_WRAPPED = Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft | Qt.TextFlag.TextWordWrap
_RIGHT = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight


def _draw_elided(painter: QPainter, place: QRectF, text: str) -> None:
    shown = painter.fontMetrics().elidedText(
        text, Qt.TextElideMode.ElideRight, max(0, int(place.width()))
    )
    painter.drawText(place, _LEFT, shown)
