"""A small table of names and values that the user makes up."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemDelegate,
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.icons import IconButton
from app.core.widgets.parts import bring_into_view

_Hint = QAbstractItemDelegate.EndEditHint
_STEPS = {_Hint.SubmitModelCache: 1, _Hint.EditNextItem: 1, _Hint.EditPreviousItem: -1}
_LEAST_ROWS = 3
Pairs = tuple[tuple[str, str], ...]


class AttributesTable(QTableWidget):
    """Name and value a row; its buttons add and remove rows and may stand anywhere.

    Enter goes from the name to the value, and from there gives the keyboard back; Tab goes on
    through all cells and begins a new row after the last one.

    Signals:
        edited(object): all (name, value) pairs, after a change by hand; once for a row, when it
            is left or complete.
    """

    edited = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 2, parent)
        self._shown: Pairs = ()
        self.setHorizontalHeaderLabels([tr("Name"), tr("Value")])
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft)
        self.verticalHeader().hide()
        self.setShowGrid(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAccessibleName(tr("Attributes of the track"))
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 10)
        rows = _LEAST_ROWS * self.verticalHeader().defaultSectionSize()
        self.setMinimumHeight(self.horizontalHeader().sizeHint().height() + rows + 4)
        self.add_button = IconButton("add", tr("Add an attribute"), parent=self)
        self.add_button.clicked.connect(self.add_row)
        self.remove_button = IconButton("remove", tr("Delete the attribute"), parent=self)
        self.remove_button.clicked.connect(self._remove_row)
        self.itemSelectionChanged.connect(self._enable)
        self.itemChanged.connect(self._take_change)
        self._enable()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Its least rows: a table's usual hint is higher than the card on a low screen."""
        return QSize(super().sizeHint().width(), self.minimumHeight())

    def pairs(self) -> Pairs:
        """What stands in the table; rows that are only begun are left out."""
        whole = [row for row in range(self.rowCount()) if not self._begun(row)]
        return tuple((self._text(row, 0), self._text(row, 1)) for row in whole)

    def show_pairs(self, pairs: Pairs, keep_editing: bool = False) -> None:
        """Show other attributes; with `keep_editing`, not while a row is being typed."""
        if keep_editing and (self._typing or self._begun(self.rowCount() - 1)):
            return
        self._shown = pairs
        if pairs != self.pairs() or len(pairs) != self.rowCount():
            self._fill(pairs)

    def _fill(self, pairs: Pairs) -> None:
        self.blockSignals(True)
        self.setRowCount(0)
        for name, value in pairs:
            self._append(name, value)
        self.blockSignals(False)
        self._enable()

    def add_row(self) -> None:
        """A new row, its name ready to be typed; one that is already begun is gone on with."""
        last = self.rowCount() - 1
        if last < 0 or not self._begun(last):
            self.blockSignals(True)
            self._append("", "")
            self.blockSignals(False)
            last += 1
        self._type_into(last, 0)

    # typing

    @property
    def _typing(self) -> bool:
        return self.state() is QAbstractItemView.State.EditingState

    def _begun(self, row: int) -> bool:
        """Whether a row still lacks its name, or a new one its value."""
        if row < 0:
            return False
        name, value = self._text(row, 0), self._text(row, 1)
        return not name or (not value and name not in dict(self._shown))

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Enter types into the cell, Esc gives the keyboard back."""
        item = self.currentItem()
        if event.key() == Qt.Key.Key_Escape and not self._typing:
            self.clearFocus()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and item is not None:
            if not self._typing:
                self.editItem(item)
        else:
            super().keyPressEvent(event)

    def closeEditor(  # noqa: N802 - Qt's name
        self, editor: QWidget, hint: QAbstractItemDelegate.EndEditHint
    ) -> None:
        """Go on to the next cell that is to be typed; the keyboard stays in an editor till then."""
        row, column = self.currentRow(), self.currentColumn()
        inside = editor.hasFocus() or self.hasFocus()
        super().closeEditor(editor, _Hint.NoHint)
        if hint is _Hint.RevertModelCache:
            self._fill(self._shown)
            self.clearFocus()
        elif hint in _STEPS:
            self._go_on(row, column, hint)
        elif not inside:  # left for another part of the window
            self._send()
            self._drop_begun()

    def _go_on(self, row: int, column: int, hint: QAbstractItemDelegate.EndEditHint) -> None:
        """Where Enter and Tab lead from a cell."""
        place = 2 * row + column + _STEPS[hint]
        entered = hint is _Hint.SubmitModelCache
        if not self._text(row, 0) or place < 0 or (entered and column == 1):
            if self._text(row, 0) and self._begun(row):
                self._type_into(row, 1)
                return
            self._leave()
        elif place // 2 == row or self._begun(row):
            self._type_into(row, 1 if place // 2 != row else place % 2)
        else:
            self._send()
            if place // 2 < self.rowCount():
                self._type_into(place // 2, place % 2)
            else:
                self.add_row()

    def _type_into(self, row: int, column: int) -> None:
        item = self.item(row, column)
        if item is not None:
            bring_into_view(self)
            self.setCurrentItem(item)
            self.setFocus(Qt.FocusReason.OtherFocusReason)
            self.editItem(item)

    def _leave(self) -> None:
        self._send()
        self._drop_begun()
        self.clearFocus()

    def _drop_begun(self) -> None:
        for row in reversed(range(self.rowCount())):
            if self._begun(row):
                self.removeRow(row)

    def _take_change(self) -> None:
        """A cell was changed; what is typed is sent when its row is left or complete."""
        if not self._typing:
            self._send()

    # rows

    def _append(self, name: str, value: str) -> None:
        row = self.rowCount()
        self.insertRow(row)
        self.setItem(row, 0, QTableWidgetItem(name))
        self.setItem(row, 1, QTableWidgetItem(value))

    def _remove_row(self) -> None:
        if self.currentRow() >= 0:
            self.removeRow(self.currentRow())
            self._send()

    def _text(self, row: int, column: int) -> str:
        item = self.item(row, column)
        return item.text().strip() if item is not None else ""

    def _enable(self) -> None:
        self.remove_button.setEnabled(bool(self.selectedItems()))

    def _send(self) -> None:
        self.edited.emit(self.pairs())
