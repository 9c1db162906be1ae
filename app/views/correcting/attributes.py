"""A small table of names and values that the user makes up."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.views.look.icons import IconButton

Pairs = tuple[tuple[str, str], ...]


class AttributesTable(QTableWidget):
    """Name and value a row; its buttons add and remove rows and may stand anywhere.

    Signals:
        edited(object): all (name, value) pairs with a name, after a change by hand.
    """

    edited = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 2, parent)
        self.setHorizontalHeaderLabels([self.tr("Name"), self.tr("Value")])
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft)
        self.verticalHeader().hide()
        self.setShowGrid(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setAccessibleName(self.tr("Attributes of the track"))
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 10)
        self.setMinimumHeight(3 * (self.fontMetrics().height() + 10))
        self.add_button = IconButton("add", self.tr("Add an attribute"), parent=self)
        self.add_button.clicked.connect(self.add_row)
        self.remove_button = IconButton("remove", self.tr("Remove the attribute"), parent=self)
        self.remove_button.clicked.connect(self._remove_row)
        self.itemSelectionChanged.connect(self._enable)
        self.itemChanged.connect(self._send)
        self._enable()

    def pairs(self) -> Pairs:
        """What stands in the table; rows without a name are left out."""
        rows = [(self._text(row, 0), self._text(row, 1)) for row in range(self.rowCount())]
        return tuple((name, value) for name, value in rows if name)

    def show_pairs(self, pairs: Pairs, keep_editing: bool = False) -> None:
        """Show other attributes; with `keep_editing`, not while a cell is being typed into."""
        editing = self.state() is QAbstractItemView.State.EditingState
        if (keep_editing and editing) or pairs == self.pairs():
            return
        self.blockSignals(True)
        self.setRowCount(0)
        for name, value in pairs:
            self._append(name, value)
        self.blockSignals(False)
        self._enable()

    def add_row(self) -> None:
        """A new row, its name ready to be typed."""
        self.blockSignals(True)
        item = self._append("", "")
        self.blockSignals(False)
        self.setCurrentItem(item)
        self.editItem(item)

    def _append(self, name: str, value: str) -> QTableWidgetItem:
        row, first = self.rowCount(), QTableWidgetItem(name)
        self.insertRow(row)
        self.setItem(row, 0, first)
        self.setItem(row, 1, QTableWidgetItem(value))
        return first

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
