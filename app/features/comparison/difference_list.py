"""Rows of the differences between two versions of the tracks, each with its tick."""

from __future__ import annotations

from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractListModel,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QRectF,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor, QKeyEvent, QMouseEvent, QPainter, QPen, QResizeEvent
from PySide6.QtWidgets import QListView, QStyleOptionViewItem, QWidget

from app.core.i18n import joined_text
from app.core.look.icons import pixmap
from app.core.look.theme import current_theme
from app.core.widgets.queue_list import ITEM, PeopleDelegate, lower_lines
from app.features.comparison.differences_scene import DifferenceItem

_BOX_PX, _ROOM_PX = 15, 26
_Index = QModelIndex | QPersistentModelIndex


class DifferenceModel(QAbstractListModel):
    """The differences as a list; ticks alone change rows in place.

    Signals: `ticked(number, on)`, the user ticked a difference, or took the tick away.
    """

    ticked = Signal(int, bool)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._items: tuple[DifferenceItem, ...] = ()

    def take(self, items: tuple[DifferenceItem, ...]) -> None:
        """Show other differences, or the same with other ticks."""
        before, same = self._items, _numbers(items) == _numbers(self._items)
        if items == before:
            return
        if not same:
            self.beginResetModel()
        self._items = items
        if same:
            self.dataChanged.emit(self.index(0), self.index(len(items) - 1))
        else:
            self.endResetModel()

    @property
    def longest(self) -> str:
        """The longest words that stand below a first line."""
        return max((item.locked or item.text for item in self._items), key=len, default="")

    def item(self, row: int) -> DifferenceItem:
        """The difference in a row."""
        return self._items[row]

    def rowCount(self, parent: _Index = QModelIndex()) -> int:  # noqa: B008, N802 - Qt's name
        """How many there are."""
        return 0 if parent.isValid() else len(self._items)

    def flags(self, index: _Index) -> Qt.ItemFlag:
        """What is protected has no tick."""
        flags = super().flags(index)
        if index.isValid() and not self._items[index.row()].locked:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        """The item, its tick, its words, or all of it as the tooltip."""
        item = self._items[index.row()]
        if role == ITEM:
            return item
        if role == Qt.ItemDataRole.CheckStateRole and not item.locked:
            return Qt.CheckState.Checked if item.ticked else Qt.CheckState.Unchecked
        if role == Qt.ItemDataRole.ToolTipRole:
            return "\n".join(line for line in (item.text, item.when, item.locked) if line)
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            who = joined_text(", ", (person.label for person in item.people))
            return f"{item.title} {who} {item.when}: {item.locked or item.text}"
        return None

    def setData(  # noqa: N802 - Qt's name
        self, index: _Index, value: object, role: int = Qt.ItemDataRole.EditRole
    ) -> bool:
        """Report a tick; it is shown once the scene says so."""
        if role != Qt.ItemDataRole.CheckStateRole:
            return False
        on = Qt.CheckState(value) is Qt.CheckState.Checked
        self.ticked.emit(self._items[index.row()].number, on)
        return True


def _numbers(items: tuple[DifferenceItem, ...]) -> tuple[int, ...]:
    return tuple(item.number for item in items)


class DifferenceDelegate(PeopleDelegate):
    """Draws a :class:`DifferenceItem`: a box to tick, or a lock, at the left."""

    def below(self, item: DifferenceItem) -> str:
        """Why it stays, else what would change."""
        return item.locked or item.text

    def lead(self, painter: QPainter, item: DifferenceItem, inner: QRectF) -> None:
        """The tick box; a lock where nothing can be ticked."""
        theme = current_theme()
        box = QRectF(inner.left(), 0, _BOX_PX, _BOX_PX)
        box.moveTop(inner.center().y() - _BOX_PX / 2)
        inner.setLeft(inner.left() + _ROOM_PX)
        if item.locked:
            _draw_icon(painter, "lock", box, theme.text_muted)
            return
        painter.setPen(QPen(theme.accent if item.ticked else theme.field, 1.4))
        painter.setBrush(theme.accent_fill if item.ticked else theme.raised)
        painter.drawRoundedRect(box, 3, 3)
        if item.ticked:
            _draw_icon(painter, "check", box, theme.accent_text)

    def editorEvent(  # noqa: N802 - Qt's name
        self,
        event: QEvent,
        model: QAbstractItemModel,
        option: QStyleOptionViewItem,
        index: _Index,
    ) -> bool:
        """A click on the box ticks; one beside it is left to the list."""
        item: DifferenceItem = index.data(ITEM)
        if item.locked or not isinstance(event, QMouseEvent):
            return False
        on_box = event.position().x() < option.rect.left() + _ROOM_PX + 4
        if on_box and event.type() == QEvent.Type.MouseButtonRelease:
            _toggle(model, index)
        return on_box


class DifferenceView(QListView):
    """The list; with the keyboard in it the arrows walk and Space ticks."""

    def __init__(self, model: DifferenceModel, parent: QWidget) -> None:
        super().__init__(parent)
        self._model = model
        self.setModel(model)
        self._delegate = DifferenceDelegate(self)
        self.setItemDelegate(self._delegate)
        model.modelReset.connect(self._fit_rows)
        self.setProperty("rows", True)
        self.setUniformItemSizes(True)
        self.setMouseTracking(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def _fit_rows(self) -> None:
        """Give the rows a line more where the longest words need it at this width."""
        lines = lower_lines(self.font(), self._model.longest, self.viewport().width() - _ROOM_PX)
        if lines != self._delegate.lower_lines:
            self._delegate.lower_lines = lines
            self.scheduleDelayedItemsLayout()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Wrap the words anew."""
        super().resizeEvent(event)
        self._fit_rows()

    def sizeHint(self) -> QSize:  # noqa: N802
        """A dozen rows."""
        return QSize(280, 12 * max(20, self.sizeHintForRow(0)))

    def event(self, event: QEvent) -> bool:
        """Keep the keys that walk and tick from being the window's."""
        wanted = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Space)
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and event.key() in wanted
            and not event.modifiers()
        ):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Space ticks the current row."""
        index = self.currentIndex()
        if event.key() == Qt.Key.Key_Space and index.isValid():
            item: DifferenceItem = index.data(ITEM)
            if not item.locked:
                _toggle(self.model(), index)
        else:
            super().keyPressEvent(event)


def _toggle(model: QAbstractItemModel, index: _Index) -> None:
    item: DifferenceItem = index.data(ITEM)
    state = Qt.CheckState.Unchecked if item.ticked else Qt.CheckState.Checked
    model.setData(index, state, Qt.ItemDataRole.CheckStateRole)


def _draw_icon(painter: QPainter, drawing: str, box: QRectF, colour: QColor) -> None:
    ratio = painter.device().devicePixelRatioF()
    drawn = pixmap(drawing, colour, round(box.width() * ratio))
    drawn.setDevicePixelRatio(ratio)
    painter.drawPixmap(box.topLeft(), drawn)
