"""All steps as a table: what passed each line, who was inside each region."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from numpy.typing import NDArray
from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Signal,
)
from PySide6.QtGui import QFont, QFontMetrics, QGuiApplication, QKeyEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import QAbstractItemView, QStyle, QTableView, QWidget

from app.core.i18n import time_text, tr
from tracking.counting import Counts, number_as_text

_Index = QModelIndex | QPersistentModelIndex
_Role = Qt.ItemDataRole
_Column = tuple[str, str, NDArray[Any]]
"""Name, what is counted, and its values by step."""


class StepsModel(QAbstractTableModel):
    """A row a step; two columns a line, one to three a region. Cells are made as they are seen."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._counts: Counts | None = None
        self._columns: list[_Column] = []
        self._now = -1

    def show_counts(self, counts: Counts | None) -> bool:
        """Show others; whether they are."""
        if counts is self._counts:
            return False
        self.beginResetModel()
        self._counts, self._columns = counts, _columns_of(counts)
        self.endResetModel()
        return True

    def show_now(self, step: int) -> None:
        """Another step is that of the frame shown."""
        before, self._now = self._now, step
        for row in {before, step} - {-1}:
            if before != step and row < self.rowCount():
                last = self.index(row, self.columnCount() - 1)
                self.dataChanged.emit(self.index(row, 0), last, [_Role.FontRole])

    @property
    def now(self) -> int:
        """The step of the frame shown; -1: none."""
        return self._now

    def frame_of(self, row: int) -> int:
        """The frame at which a step begins."""
        return int(self._counts.steps.frame[row]) if self._counts is not None else 0

    def rowCount(self, parent: _Index | None = None) -> int:  # noqa: N802 - Qt's name
        """Steps."""
        inside = parent is not None and parent.isValid()
        return 0 if inside or self._counts is None else len(self._counts.steps)

    def columnCount(self, parent: _Index | None = None) -> int:  # noqa: N802
        """The time, then what is counted."""
        return 0 if parent is not None and parent.isValid() else 1 + len(self._columns)

    def headerData(  # noqa: N802
        self, section: int, orientation: Qt.Orientation, role: int = _Role.DisplayRole
    ) -> object:
        """What is counted where; in full where the mouse rests."""
        if orientation is not Qt.Orientation.Horizontal or section > len(self._columns):
            return None
        if role not in (_Role.DisplayRole, _Role.ToolTipRole):
            return None
        if section == 0:
            return tr("Time")
        name, what, _ = self._columns[section - 1]
        return f"{name}\n{what}" if role == _Role.DisplayRole else f"{name}: {what}"

    def data(self, index: _Index, role: int = _Role.DisplayRole) -> object:
        """A number of a step; that of the frame shown in bold."""
        row, column = index.row(), index.column()
        if role == _Role.DisplayRole:
            return self.text(row, column)
        if role == _Role.TextAlignmentRole:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == _Role.FontRole and row == self._now:
            font = QFont()
            font.setBold(True)
            return font
        return None

    def text(self, row: int, column: int) -> str:
        """What stands in a cell."""
        if self._counts is None:
            return ""
        if column == 0:
            return time_text(row * self._counts.steps.step_s)
        number = float(self._columns[column - 1][2][row])
        return number_as_text(round(number, 3))

    def as_text(self, rows: Sequence[int]) -> str:
        """Some rows under their headings, with tabs between, for other programs."""
        headings = [tr("Time"), *(f"{name}: {what}" for name, what, _ in self._columns)]
        lines = [[self.text(row, column) for column in range(len(headings))] for row in rows]
        return "\n".join("\t".join(cells) for cells in (headings, *lines))


class StepsTable(QTableView):
    """Shows :class:`StepsModel`.

    Signals:
        frame_sought(int): a step was clicked or walked to.
    """

    frame_sought = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.steps = StepsModel(self)
        self.setModel(self.steps)
        self.setAccessibleName(tr("Counts of each step"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setShowGrid(False)
        self.verticalHeader().hide()
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignRight)
        self.horizontalHeader().setResizeContentsPrecision(0)  # what is seen, not ten thousand rows
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 6)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.clicked.connect(self._seek)

    def show_counts(self, counts: Counts | None, frame: int, fps: float) -> None:
        """Show the steps, and which one the frame lies in."""
        if self.steps.show_counts(counts):
            self.resizeColumnsToContents()
            self._make_room_for_bold()
        if counts is not None and len(counts.steps):
            self.steps.show_now(int(frame / fps / counts.steps.step_s + 1e-9))

    def _make_room_for_bold(self) -> None:
        """The row of the frame shown is bold: its time, too, is to be read whole."""
        font = QFont(self.font())
        font.setBold(True)
        last = self.steps.text(max(0, self.steps.rowCount() - 1), 0)
        inside = 2 * (self.style().pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin) + 1)
        wide = QFontMetrics(font).horizontalAdvance(last + "0") + inside
        self.setColumnWidth(0, max(self.columnWidth(0), wide))

    def showEvent(self, event: QShowEvent) -> None:  # noqa: N802 - Qt's name
        """Begin at the step of the frame shown."""
        super().showEvent(event)
        centre = QAbstractItemView.ScrollHint.PositionAtCenter
        self.scrollTo(self.steps.index(max(self.steps.now, 0), 0), centre)

    def copy(self) -> int:
        """Put the chosen rows, or all, on the clipboard; how many."""
        selection = self.selectionModel()
        assert isinstance(selection, QItemSelectionModel)
        rows = sorted(index.row() for index in selection.selectedRows())
        chosen = rows or range(self.steps.rowCount())
        QGuiApplication.clipboard().setText(self.steps.as_text(chosen))
        return len(chosen)

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Copy as in every table."""
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy()
        else:
            super().keyPressEvent(event)

    def _seek(self, index: QModelIndex) -> None:
        self.frame_sought.emit(self.steps.frame_of(index.row()))


def _columns_of(counts: Counts | None) -> list[_Column]:
    """Name, what is counted, and its values by step."""
    if counts is None:
        return []
    found: list[_Column] = []
    for line in counts.lines:
        found.append((line.line.name, tr("forward"), line.forward))
        found.append((line.line.name, tr("backward"), line.backward))
    for region in counts.regions:
        name = region.region.name
        found.append((name, tr("people"), region.people))
        if not region.region.in_picture:
            found.append((name, tr("people/m²"), region.density))
        found.append((name, tr("m/s"), region.mean_speed))
    return found
