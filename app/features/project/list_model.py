"""The recordings of a project as a table: sorted, filtered, with images."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSortFilterProxyModel,
    Qt,
)
from PySide6.QtGui import QColor, QPixmap

from app.core.i18n import tr
from app.core.look.theme import current_theme
from app.features.project.presenter import COLUMNS, HINTS, NUMBERS
from app.features.project.scene import Mood, RecordingRow

ROW = Qt.ItemDataRole.UserRole
ORDER = Qt.ItemDataRole.UserRole + 1
STATE = 8
Index = QModelIndex | QPersistentModelIndex
_NO_PARENT = QModelIndex()
_MOST_IMAGES = 1000
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class RecordingModel(QAbstractTableModel):
    """Shows `RecordingRow`s; those that stay keep their place and are selected as before."""

    def __init__(self, image_of: Callable[[str], bytes], parent: QObject) -> None:
        """image_of: the JPEG image of a recording by its name; b"": there is none."""
        super().__init__(parent)
        self._rows: tuple[RecordingRow, ...] = ()
        self._image_of = image_of
        self._images: dict[tuple[str, ...], QPixmap] = {}

    def rowCount(self, parent: Index = _NO_PARENT) -> int:  # noqa: N802 - Qt's name
        """One row a recording."""
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = _NO_PARENT) -> int:  # noqa: N802 - Qt's name
        """The columns of the presenter."""
        return 0 if parent.isValid() else len(COLUMNS)

    def headerData(  # noqa: N802 - Qt's name
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Titles, and what they mean."""
        if orientation is not Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return tr(COLUMNS[section])
        if role == Qt.ItemDataRole.ToolTipRole:
            return tr(HINTS[section]) if HINTS[section] else None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _RIGHT if section in NUMBERS else _LEFT
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """A cell."""
        if not index.isValid() or not 0 <= index.row() < len(self._rows):
            return None
        row, column = self._rows[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return row.name if column == 0 else row.cells[column - 1]
        if role == ORDER:
            return row.order[column]
        if role == ROW:
            return row
        if role == Qt.ItemDataRole.ToolTipRole:
            return row.tip
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _RIGHT if column in NUMBERS else _LEFT
        if role == Qt.ItemDataRole.ForegroundRole and column == STATE:
            return _colour(row.mood)
        if role == Qt.ItemDataRole.AccessibleTextRole:
            return f"{row.name}, {row.detail}" if column == 0 else row.cells[column - 1]
        return None

    def show_rows(self, rows: tuple[RecordingRow, ...]) -> None:
        """Show other rows."""
        before = self._rows
        if before == rows:
            return
        if [row.name for row in before] != [row.name for row in rows]:
            self.beginResetModel()
            self._rows = rows
            self.endResetModel()
            return
        self._rows = rows
        last = len(COLUMNS) - 1
        for number, (old, new) in enumerate(zip(before, rows, strict=True)):
            if old != new:
                self.dataChanged.emit(self.index(number, 0), self.index(number, last))

    def texts(self, column: int) -> set[str]:
        """What the cells of a column after the first say."""
        return {row.cells[column - 1] for row in self._rows}

    def row(self, number: int) -> RecordingRow:
        """A recording."""
        return self._rows[number]

    def number_of(self, name: str) -> int:
        """Where a recording stands; -1 where it is not listed."""
        return next((n for n, row in enumerate(self._rows) if row.name == name), -1)

    def image(self, row: RecordingRow) -> QPixmap:
        """The image of a recording; an empty one where none is known yet."""
        known = self._images.get(row.image)
        if known is None:
            known = QPixmap()
            data = self._image_of(row.name)
            if data:
                known.loadFromData(data, "JPEG")
            while len(self._images) >= _MOST_IMAGES:
                self._images.pop(next(iter(self._images)))
            self._images[row.image] = known
        return known


class RecordingFilter(QSortFilterProxyModel):
    """Rows that hold all words of a text, in a name, a state or who works on it."""

    def __init__(self, model: RecordingModel, parent: QObject) -> None:
        super().__init__(parent)
        self._model = model
        self._words: tuple[str, ...] = ()
        self.setSourceModel(model)
        self.setSortRole(ORDER)
        self.setDynamicSortFilter(True)

    def set_text(self, text: str) -> None:
        """Show the rows that hold these words alone."""
        self._words = tuple(text.casefold().split())
        self.invalidate()

    def filterAcceptsRow(self, number: int, parent: Index) -> bool:  # noqa: ARG002, N802
        """Whether a row holds all words."""
        row = self._model.row(number)
        held = " ".join((row.name, row.detail, *row.cells)).casefold()
        return all(word in held for word in self._words)

    def lessThan(self, left: Index, right: Index) -> bool:  # noqa: N802 - Qt's name
        """Numbers by size, words by letter; what is missing comes first, as the least."""
        one, other = left.data(ORDER), right.data(ORDER)
        if isinstance(one, str) != isinstance(other, str):
            return isinstance(other, str)
        return bool(one < other)


def _colour(mood: Mood) -> QColor:
    theme = current_theme()
    return {
        Mood.PLAIN: theme.text,
        Mood.QUIET: theme.text_muted,
        Mood.GOOD: theme.good,
        Mood.BAD: theme.danger,
    }[mood]
