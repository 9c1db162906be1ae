"""The rows of the history: tens of thousands of them without a widget each."""

from __future__ import annotations

from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSize,
    Qt,
)
from PySide6.QtGui import QFont, QFontMetrics, QPainter
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem

from app.core.i18n import tr
from app.core.look.theme import current_theme, line_height, scaled_font
from app.core.scenes import HistoryItem
from app.core.widgets.command_list import draw_row_ground

ITEM = Qt.ItemDataRole.UserRole
_PAD = 3
_MOST_STEPS = 64  # told one by one; more of them are told as a new list
Index = QModelIndex | QPersistentModelIndex
_NO_PARENT = QModelIndex()


class HistoryModel(QAbstractListModel):
    """Shows :class:`HistoryItem`, given oldest first, the newest on top."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._items: tuple[HistoryItem, ...] = ()

    def rowCount(self, parent: Index = _NO_PARENT) -> int:  # noqa: N802 - Qt's name
        """One row an edit."""
        return 0 if parent.isValid() else len(self._items)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """The edit's line, its tooltip, or the whole item."""
        if not index.isValid() or not 0 <= index.row() < len(self._items):
            return None
        item = self.item(index.row())
        if role == ITEM:
            return item
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            return item.text
        if role == Qt.ItemDataRole.ToolTipRole:
            return tr("{0}\n{1}, {2}, edit {3}").format(
                item.text, item.when, item.author, item.edit
            )
        return None

    def item(self, row: int) -> HistoryItem:
        """The edit in a row."""
        return self._items[len(self._items) - 1 - row]

    def row_of(self, edit: int) -> int:
        """Where an edit stands; -1 where it is not listed."""
        rows = (row for row in range(len(self._items)) if self.item(row).edit == edit)
        return next(rows, -1)

    def show_items(self, items: tuple[HistoryItem, ...]) -> None:
        """Show another history; rows that stay are left alone, with what is selected of them."""
        before = self._items
        both = zip(before, items, strict=False)
        changed = [at for at, (old, new) in enumerate(both) if old is not new and old != new]
        more = len(items) - len(before)
        if len(changed) > _MOST_STEPS or abs(more) > _MOST_STEPS:
            self.beginResetModel()
            self._items = items
            self.endResetModel()
            return
        if more > 0:
            self.beginInsertRows(QModelIndex(), 0, more - 1)
            self._items = before + items[len(before) :]
            self.endInsertRows()
        elif more < 0:
            self.beginRemoveRows(QModelIndex(), 0, -more - 1)
            self._items = before[: len(items)]
            self.endRemoveRows()
        self._items = items
        for at in changed:
            index = self.index(len(items) - 1 - at)
            self.dataChanged.emit(index, index)


def row_height(font: QFont) -> int:
    """Two lines, the lower one smaller."""
    return line_height(font) + line_height(scaled_font(font, 0.85)) + 2 * _PAD


class EditDelegate(QStyledItemDelegate):
    """Two lines an edit: what, and when by whom; undone ones greyed and struck out."""

    def sizeHint(  # noqa: N802 - Qt's name
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        """As high as every other row."""
        del index
        return QSize(64, row_height(option.font))

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        """What above, who and when below."""
        item: HistoryItem = index.data(ITEM)
        theme, gone = current_theme(), item.undone or bool(item.taken_by)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        draw_row_ground(painter, option)
        inner = option.rect.adjusted(8, _PAD, -8, -_PAD)
        font = scaled_font(option.font, 1.0)
        font.setStrikeOut(gone)
        painter.setFont(font)
        painter.setPen(theme.text_faint if gone else theme.text)
        metrics = QFontMetrics(font)
        shown = metrics.elidedText(item.text, Qt.TextElideMode.ElideRight, inner.width())
        painter.drawText(inner, Qt.AlignmentFlag.AlignTop, shown)
        painter.setFont(scaled_font(option.font, 0.85))
        painter.setPen(theme.text_faint if gone else theme.text_muted)
        painter.drawText(inner, Qt.AlignmentFlag.AlignBottom, self._detail(item))
        painter.restore()

    def _detail(self, item: HistoryItem) -> str:
        taken = tr("undone by edit {0}").format(item.taken_by) if item.taken_by else ""
        parts = (f"#{item.edit}", item.when, item.author, item.moved, taken)
        return "  \u00b7  ".join(part for part in parts if part)
