"""Points clicked on the floor, with their places or the distances between them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.features.setup import floor_presenter
from app.features.setup.floor_presenter import pairs_of_points
from app.features.setup.scene import SetupScene, SetupState
from app.features.setup.step_page import plain

if TYPE_CHECKING:
    from app.features.setup.floor_page import FloorPage

_ROWS_SEEN = 5
_FEWEST = 4


class PointsTable(QWidget):
    """A row a point (its place), or a row two points (their distance)."""

    def __init__(self, page: FloorPage) -> None:
        super().__init__(page)
        self._page = page
        self._distances = False
        self.chosen = -1
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        self.told = plain("", self)
        rows.addWidget(self.told)
        self.table = QTableWidget(0, 3, self)
        self.table.verticalHeader().hide()
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectItems)
        self.table.setAccessibleName(tr("Points on the floor"))
        self.table.itemChanged.connect(self._edit)
        self.table.currentCellChanged.connect(self._choose)
        line = self.table.fontMetrics().height() + 10
        self.table.verticalHeader().setDefaultSectionSize(line)
        self.table.setFixedHeight((_ROWS_SEEN + 1) * line)
        rows.addWidget(self.table)
        across = QHBoxLayout()
        self.use = page.button(tr("Find the floor"), page.estimate)
        self.remove = page.button(tr("Delete point"), page.delete)
        across.addWidget(self.use)
        across.addWidget(self.remove)
        rows.addLayout(across)

    def fill(self, scene: SetupScene) -> None:
        """The points and what is known of them."""
        state = scene.state
        self._distances = state.floor_method == "distances"
        self.told.setText(
            tr("Click four or more points on the floor, then enter distances between them.")
            if self._distances
            else tr(
                "Click four or more points on the floor, not on a line, and enter where they are."
            )
        )
        self.remove.setEnabled(0 <= self.chosen < len(state.points))
        self.use.setEnabled(scene.checked.calibration is not None and not scene.busy)
        self.table.blockSignals(True)
        (self._fill_distances if self._distances else self._fill_places)(state)
        self.table.blockSignals(False)

    def _fill_places(self, state: SetupState) -> None:
        self._head((tr("Point"), tr("x, m"), tr("y, m")), len(state.points))
        for row, point in enumerate(state.points):
            self._put(row, 0, str(row + 1), editable=False)
            self._put(row, 1, f"{point.x_m:g}")
            self._put(row, 2, f"{point.y_m:g}")

    def _fill_distances(self, state: SetupState) -> None:
        pairs = pairs_of_points(state)
        known = {(one, other): metres for one, other, metres in state.distances}
        self._head((tr("From"), tr("To"), tr("Distance, m")), len(pairs))
        for row, (one, other) in enumerate(pairs):
            self._put(row, 0, str(one + 1), editable=False)
            self._put(row, 1, str(other + 1), editable=False)
            metres = known.get((one, other))
            self._put(row, 2, "" if metres is None else f"{metres:g}")

    def _head(self, names: tuple[str, str, str], rows: int) -> None:
        self.table.setHorizontalHeaderLabels(list(names))
        if self.table.rowCount() != rows:
            self.table.setRowCount(rows)

    def _put(self, row: int, column: int, text: str, *, editable: bool = True) -> None:
        item = self.table.item(row, column)
        if item is None:
            item = QTableWidgetItem()
            self.table.setItem(row, column, item)
        if item.text() != text:
            item.setText(text)
        flags = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled
        item.setFlags(flags | Qt.ItemFlag.ItemIsEditable if editable else flags)

    def is_complete(self, state: SetupState) -> bool:
        """Whether enough is entered for a floor."""
        if state.floor_method == "distances":
            return len(state.distances) >= _FEWEST
        placed = {(point.x_m, point.y_m) for point in state.points}
        return len(state.points) >= _FEWEST and len(placed) == len(state.points)

    def choose_row(self, number: int) -> None:
        """Have a point chosen."""
        self.chosen = number
        if not self._distances:
            self.table.blockSignals(True)
            self.table.setCurrentCell(number, 1)
            self.table.blockSignals(False)
        self.remove.setEnabled(number >= 0)

    def _choose(self, row: int, *_: int) -> None:
        if not self._distances and row >= 0:
            self.chosen = row
            self.remove.setEnabled(True)
            self._page.redrawn.emit()

    def _edit(self, item: QTableWidgetItem) -> None:
        editor, row = self._page.editor, item.row()
        value = _number(item.text())
        if value is None:
            self._page.editor.tell(
                self._page.step, tr("{typed} is no number of metres", typed=item.text())
            )
            return
        editor.tell(self._page.step, "")
        state = editor.state
        if self._distances:
            known = {(one, other): metres for one, other, metres in state.distances}
            known[pairs_of_points(state)[row]] = value
            editor.change(floor_presenter.with_distances(state, known))
        else:
            point = state.points[row]
            x_m, y_m = (value, point.y_m) if item.column() == 1 else (point.x_m, value)
            editor.change(floor_presenter.with_place(state, row, x_m, y_m))
        self._page.estimate(quietly=True)


def _number(text: str) -> float | None:
    text = text.strip().replace(",", ".")
    if not text:
        return 0.0
    try:
        value = float(text)
    except ValueError:
        return None
    return value if abs(value) < 1e4 else None
