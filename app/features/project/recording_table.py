"""The table of a project's recordings: all of it by keys alone, too."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QItemSelectionModel, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from app.core.i18n import tr
from app.features.project.list_model import ROW, STATE, RecordingFilter, RecordingModel
from app.features.project.name_cell import NameCell, row_height
from app.features.project.presenter import COLUMNS
from app.features.project.scene import RecordingRow

_LETTERS = (36, 8, 8, 0, 0, 0, 11, 6, 12, 12)
"""Of columns, at least; the first one takes what is left."""
_MOST_LETTERS = 32
_PAD_PX = 24
"""Around the words of a cell: what the stylesheet and the style of the desktop leave free."""


class RecordingTable(QTableView):
    """Lists recordings.

    Signals: `open_asked(row)`, a `RecordingRow`: Enter or a double click.
    """

    open_asked = Signal(object)

    def __init__(self, image_of: Callable[[str], bytes], parent: QWidget) -> None:
        """image_of: see `RecordingModel`."""
        super().__init__(parent)
        self._fitted: dict[int, int] = {}
        self.recordings = RecordingModel(image_of, self)
        self.shown = RecordingFilter(self.recordings, self)
        self.setModel(self.shown)
        self.setItemDelegateForColumn(0, NameCell(self.recordings))
        self.setAccessibleName(tr("Recordings of the project"))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setShowGrid(False)
        self.setTabKeyNavigation(False)
        self.setWordWrap(False)
        self.setSortingEnabled(True)
        self.sortByColumn(0, Qt.SortOrder.AscendingOrder)
        self.verticalHeader().hide()
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.verticalHeader().setDefaultSectionSize(row_height(self.fontMetrics()))
        header = self.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.sectionResized.connect(lambda column, *_: self._fit_first() if column else None)
        self._fit_columns()

    def _fit_columns(self) -> None:
        """Each column as wide as its words, the first one with what is left.

        What somebody made wider or narrower stays so.
        """
        header, letters = self.horizontalHeader(), self.fontMetrics()
        header.setHighlightSections(False)
        for column in range(1, len(COLUMNS)):
            if self.columnWidth(column) != self._fitted.get(column, self.columnWidth(column)):
                continue
            words = [letters.horizontalAdvance(tr(COLUMNS[column])) + letters.height()]
            words += map(letters.horizontalAdvance, self.recordings.texts(column))
            most = _MOST_LETTERS * letters.averageCharWidth()
            wide = max(min(max(words), most), _LETTERS[column] * letters.averageCharWidth())
            self._fitted[column] = wide + _PAD_PX
            self.setColumnWidth(column, wide + _PAD_PX)
        self._fit_first()

    def _fit_first(self) -> None:
        """The first column takes what is left, and has room for a name where little is."""
        header = self.horizontalHeader()
        least = _LETTERS[0] * self.fontMetrics().averageCharWidth()
        others = sum(map(self.columnWidth, range(1, len(COLUMNS))))
        header.resizeSection(0, max(least, self.viewport().width() - others))

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Another width is left for the first column."""
        super().resizeEvent(event)
        self._fit_first()

    def show_rows(self, rows: tuple[RecordingRow, ...]) -> None:
        """Show other rows; what is selected stays so, where it is still listed."""
        chosen, current = set(self.chosen_names()), self.current_name()
        self.recordings.show_rows(rows)
        self._fit_columns()
        if self.chosen_names() == chosen or not chosen:
            return
        flags = QItemSelectionModel.SelectionFlag
        for name in chosen:
            self._choose(name, flags.Select | flags.Rows)
        if current:
            self._choose(current, flags.Current)

    def choose(self, name: str) -> None:
        """Select a recording alone and show it."""
        flags = QItemSelectionModel.SelectionFlag
        self._choose(name, flags.ClearAndSelect | flags.Rows | flags.Current)
        self.scrollTo(self.currentIndex())

    def _choose(self, name: str, how: QItemSelectionModel.SelectionFlag) -> None:
        number = self.recordings.number_of(name)
        if number >= 0:
            index = self.shown.mapFromSource(self.recordings.index(number, 0))
            if index.isValid():
                self.selectionModel().setCurrentIndex(index, how)

    def chosen(self) -> list[RecordingRow]:
        """The recordings that are selected, as they are listed."""
        found = self.selectionModel().selectedRows()
        return [index.data(ROW) for index in sorted(found, key=lambda one: one.row())]

    def chosen_names(self) -> set[str]:
        """Their names."""
        return {row.name for row in self.chosen()}

    def current_name(self) -> str:
        """The recording that the keyboard is on; "": none."""
        index = self.currentIndex()
        return index.data(ROW).name if index.isValid() else ""

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Enter opens."""
        index = self.currentIndex()
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and index.isValid():
            self.open_asked.emit(index.data(ROW))
        else:
            super().keyPressEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        """So does a double click."""
        index = self.indexAt(event.position().toPoint())
        if index.isValid() and event.button() is Qt.MouseButton.LeftButton:
            self.open_asked.emit(index.data(ROW))


__all__ = ["STATE", "RecordingTable"]
