"""Lines and regions with what is counted at them, at the frame shown."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.theme import current_theme
from app.core.widgets.table_cells import write_cell
from app.features.counting.scene import CountingScene, TallyRow

_MOST_ROWS = 4
_DOT_PX = 10
_WIDEST = ("88 of 88", "88 of 88", "88", "8.88", "8.88")
_PAD_PX = 22


class TallyList(QTableWidget):
    """Draws the rows of a :class:`CountingScene`; one of them is picked, to be plotted.

    Signals:
        picked(bool, str): whether it is a line, and its name.
    """

    picked = Signal(bool, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 6, parent)
        self._rows: tuple[TallyRow, ...] = ()
        names = (
            tr("Name"),
            tr("Forward"),
            tr("Backward"),
            tr("Inside"),
            tr("People/m²"),
            tr("m/s"),
        )
        self.setHorizontalHeaderLabels(names)
        self.setAccessibleName(tr("Counts at the frame shown"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setShowGrid(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 8)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setMinimumSectionSize(4 * self.fontMetrics().averageCharWidth())
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        width = self.fontMetrics().horizontalAdvance
        for column, texts in enumerate(zip(names[1:], _WIDEST, strict=True), 1):
            self.setColumnWidth(column, max(map(width, texts)) + _PAD_PX)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignRight)
        passed = tr("Passages up to the frame shown, of those in all frames")
        for column in (1, 2):
            title = QTableWidgetItem(names[column])
            title.setToolTip(passed)
            self.setHorizontalHeaderItem(column, title)
        first = QTableWidgetItem(names[0])
        first.setTextAlignment(Qt.AlignmentFlag.AlignLeft)
        self.setHorizontalHeaderItem(0, first)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.currentCellChanged.connect(self._pick)

    def show_scene(self, scene: CountingScene) -> None:
        """Show another frame; only cells that are others are written."""
        self.blockSignals(True)
        if len(scene.rows) != len(self._rows):
            self.setRowCount(len(scene.rows))
            self._limit_height(len(scene.rows))
        for number, row in enumerate(scene.rows):
            if number >= len(self._rows) or self._rows[number] != row:
                self._write(number, row)
        self._rows = scene.rows
        if self.currentRow() != scene.picked:
            self.setCurrentCell(scene.picked, 0)
        self.blockSignals(False)

    def _limit_height(self, rows: int) -> None:
        shown = min(max(rows, 1), _MOST_ROWS)
        height = self.horizontalHeader().sizeHint().height() + 4
        self.setFixedHeight(height + shown * self.verticalHeader().defaultSectionSize())

    def _write(self, number: int, row: TallyRow) -> None:
        for column, text in enumerate((row.name, *row.cells)):
            item = write_cell(self, number, column, text, row.hint)
            if column == 0:
                item.setIcon(_dot(current_theme().track(row.colour), row.is_line))

    def _pick(self, number: int) -> None:
        if 0 <= number < len(self._rows):
            self.picked.emit(self._rows[number].is_line, self._rows[number].name)


def _dot(colour: QColor, is_line: bool) -> QIcon:
    """A stroke for a line, a square for a region."""
    picture = QPixmap(2 * _DOT_PX, 2 * _DOT_PX)
    picture.setDevicePixelRatio(2)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    if is_line:
        painter.fillRect(0, _DOT_PX // 2 - 1, _DOT_PX, 3, colour)
    else:
        painter.fillRect(1, 1, _DOT_PX - 2, _DOT_PX - 2, colour)
    painter.end()
    return QIcon(picture)
