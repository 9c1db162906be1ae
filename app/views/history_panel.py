"""What was done, newest first; any point can be gone back to."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QPoint, QSize, Qt, Signal
from PySide6.QtGui import QFont, QFontMetrics, QPainter
from PySide6.QtWidgets import (
    QListWidget,
    QListWidgetItem,
    QMenu,
    QStackedLayout,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from app.presenters.scenes import HistoryItem
from app.views.command_list import draw_row_ground
from app.views.icons import IconButton
from app.views.parts import EmptyState, Panel
from app.views.theme import current_theme, scaled_font

_ITEM = Qt.ItemDataRole.UserRole
_PAD = 3
_ROWS = 5  # seen at least


class HistoryPanel(Panel):
    """Draws the history, a tuple of :class:`HistoryItem`, oldest first.

    Signals:
        undo_asked(), redo_asked(): the buttons.
        frame_sought(int): an entry was clicked; to the frame it changed.
        goto_asked(int): undo, or redo, until this edit is the last one done.
    """

    undo_asked = Signal()
    redo_asked = Signal()
    frame_sought = Signal(int)
    goto_asked = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(self.tr("History"), parent)
        self._items: tuple[HistoryItem, ...] = ()
        self._undo = IconButton("undo", self.tr("Undo"), "Ctrl+Z", self)
        self._undo.clicked.connect(self.undo_asked)
        self._redo = IconButton("redo", self.tr("Redo"), "Ctrl+Shift+Z", self)
        self._redo.clicked.connect(self.redo_asked)
        self.add_to_heading(self._undo)
        self.add_to_heading(self._redo)
        self._list = QListWidget(self)
        self._list.setAccessibleName(self.tr("Edits, newest first"))
        self._list.setProperty("rows", True)
        self._list.setUniformItemSizes(True)
        self._list.setMouseTracking(True)
        self._list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._list.setItemDelegate(_EditDelegate(self._list))
        self._list.setMinimumHeight(_ROWS * _row_height(self._list.font()))
        self._list.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self._list.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._list.customContextMenuRequested.connect(self._open_menu)
        self._list.itemClicked.connect(lambda item: self.frame_sought.emit(_edit_of(item).frame))
        self._list.itemDoubleClicked.connect(lambda item: self.goto_asked.emit(_edit_of(item).edit))
        self._empty = EmptyState("history", parent=self)
        self._empty.say(self.tr("No edits yet"), self.tr("What you correct is listed here."))
        self._stack = QStackedLayout()
        self._stack.addWidget(self._empty)
        self._stack.addWidget(self._list)
        self.layout_body(self._stack)
        self.show_scene(())

    def show_scene(self, items: tuple[HistoryItem, ...]) -> None:
        """Show another history."""
        self._undo.setEnabled(any(not item.undone for item in items))
        self._redo.setEnabled(any(item.undone for item in items))
        self._stack.setCurrentIndex(1 if items else 0)
        if items == self._items:
            return
        before, self._items = self._items, items
        self._take_away(len(before) - len(items))
        for number, item in enumerate(items):
            if number >= len(before):
                self._list.insertItem(0, QListWidgetItem())
            if number >= len(before) or item != before[number]:
                self._fill(self._list.item(self._list.count() - 1 - number), item)

    def _take_away(self, count: int) -> None:
        """Remove the newest rows: only what differs is made anew, as a history may be long."""
        for _ in range(max(0, count)):
            self._list.takeItem(0)

    def _fill(self, row: QListWidgetItem, item: HistoryItem) -> None:
        row.setText(item.text)
        row.setData(_ITEM, item)
        row.setToolTip(self.tr("{0}\n{1}, {2}").format(item.text, item.when, item.author))

    def _open_menu(self, at: QPoint) -> None:
        row = self._list.itemAt(at)
        if row is None:
            return
        item = _edit_of(row)
        menu = QMenu(self._list)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        text = self.tr("Redo to here") if item.undone else self.tr("Undo to here")
        menu.addAction(text).triggered.connect(lambda: self.goto_asked.emit(item.edit))
        go = self.tr("Go to frame {0}").format(item.frame)
        menu.addAction(go).triggered.connect(lambda: self.frame_sought.emit(item.frame))
        menu.popup(self._list.viewport().mapToGlobal(at))


def _edit_of(row: QListWidgetItem) -> HistoryItem:
    item = row.data(_ITEM)
    assert isinstance(item, HistoryItem)
    return item


def _row_height(font: QFont) -> int:
    """Two lines, the lower one smaller."""
    small = QFontMetrics(scaled_font(font, 0.85))
    return QFontMetrics(font).height() + small.height() + 2 * _PAD


class _EditDelegate(QStyledItemDelegate):
    """Two lines an edit: what, and when by whom; undone ones greyed and struck out."""

    def sizeHint(  # noqa: N802 - Qt's name
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        del index
        return QSize(64, _row_height(option.font))

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        item: HistoryItem = index.data(_ITEM)
        theme = current_theme()
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        draw_row_ground(painter, option)
        inner = option.rect.adjusted(8, _PAD, -8, -_PAD)
        font = scaled_font(option.font, 1.0)
        font.setStrikeOut(item.undone)
        painter.setFont(font)
        painter.setPen(theme.text_faint if item.undone else theme.text)
        metrics = QFontMetrics(font)
        shown = metrics.elidedText(item.text, Qt.TextElideMode.ElideRight, inner.width())
        painter.drawText(inner, Qt.AlignmentFlag.AlignTop, shown)
        painter.setFont(scaled_font(option.font, 0.85))
        painter.setPen(theme.text_faint if item.undone else theme.text_muted)
        detail = "  \u00b7  ".join(part for part in (item.when, item.author) if part)
        painter.drawText(inner, Qt.AlignmentFlag.AlignBottom, detail)
        painter.restore()
