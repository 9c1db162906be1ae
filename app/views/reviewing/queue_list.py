"""Rows of the review queue: what, who, when, and below it why."""

from __future__ import annotations

from abc import abstractmethod
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
from PySide6.QtGui import QFont, QFontMetrics, QFontMetricsF, QPainter
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem

from app.presenters.reviewing.review_scene import ReviewItem, ReviewPerson
from app.views.look.theme import current_theme, scaled_font
from app.views.widgets.abstract import AbstractQt
from app.views.widgets.command_list import draw_row_ground

ITEM = Qt.ItemDataRole.UserRole
_PAD, _SIDE, _GAP = 4, 8, 6
_SMALL = 0.88
_Index = QModelIndex | QPersistentModelIndex


class ReviewModel(QAbstractListModel):
    """The suspicions of a queue; another queue is taken as a whole, however long it is."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._items: tuple[ReviewItem, ...] = ()

    def take(self, items: tuple[ReviewItem, ...]) -> None:
        """Show another queue."""
        if items is not self._items:
            self.beginResetModel()
            self._items = items
            self.endResetModel()

    def item(self, row: int) -> ReviewItem:
        """The suspicion in a row."""
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
            return "\n".join((item.why, *item.others, _likely(self, item)))
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            who = ", ".join(person.label for person in item.people)
            return f"{item.title} {who} {item.when}: {item.why}"
        return None


def _likely(words: QObject, item: ReviewItem) -> str:
    return words.tr("frame {0}, {1:.0f} % likely").format(item.frame, 100 * item.likelihood)


def row_height(font: QFont, lower_lines: int = 1) -> int:
    """A line, and below it so many smaller ones."""
    small = QFontMetrics(scaled_font(font, _SMALL))
    return QFontMetrics(font).height() + lower_lines * small.height() + 2 * _PAD


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
        line.setHeight(QFontMetricsF(option.font).height())
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
        painter.setFont(small)
        painter.setPen(theme.text_muted)
        painter.drawText(line, _RIGHT, item.when)
        line.setRight(line.right() - QFontMetricsF(small).horizontalAdvance(item.when) - _GAP)
        painter.setFont(scaled_font(font, 1.0, bold=True))
        painter.setPen(theme.text)
        title = QFontMetricsF(painter.font()).horizontalAdvance(item.title)
        _draw_elided(painter, line, item.title)
        line.setLeft(line.left() + title + 2 * _GAP)
        painter.setFont(font)
        for person in item.people:
            if line.width() <= 3 * _GAP:
                return
            self._draw_person(painter, person, line)

    def _draw_person(self, painter: QPainter, person: ReviewPerson, line: QRectF) -> None:
        """A spot in their colour and their name; `line` is left with the room behind."""
        theme, metrics = current_theme(), painter.fontMetrics()
        radius = metrics.ascent() * 0.32
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.track(person.colour))
        painter.drawEllipse(QPointF(line.left() + radius, line.center().y()), radius, radius)
        line.setLeft(line.left() + 2 * radius + _GAP / 2)
        painter.setPen(theme.text)
        _draw_elided(painter, line, person.label)
        line.setLeft(line.left() + metrics.horizontalAdvance(person.label) + 1.5 * _GAP)


class ReviewDelegate(PeopleDelegate):
    """Draws a :class:`ReviewItem`, its reason on two lines."""

    lower_lines = 2

    def below(self, item: ReviewItem) -> str:
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
