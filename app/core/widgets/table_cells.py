"""Cells of tables whose rows are written again and again."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QTableWidget, QTableWidgetItem


def write_cell(
    table: QTableWidget, row: int, column: int, text: str, hint: str
) -> QTableWidgetItem:
    """Put a text into a cell, which is made where there is none; names left, figures right."""
    item = table.item(row, column)
    if item is None:
        item = QTableWidgetItem()
        side = Qt.AlignmentFlag.AlignLeft if column == 0 else Qt.AlignmentFlag.AlignRight
        item.setTextAlignment(side | Qt.AlignmentFlag.AlignVCenter)
        table.setItem(row, column, item)
    item.setText(text)
    item.setToolTip(hint)
    return item
