"""The figures of a score: over all frames, over those shown, and how the last edits moved them."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.presenters.scoring.score_scene import ScoreRow, ScoreScene
from app.views.look.theme import current_theme
from app.views.widgets.table_cells import write_cell

_WIDEST, _WIDEST_MOVE = "100.0%", "\u25b2 +88.888"
_PAD_PX = 20


class FiguresTable(QTableWidget):
    """Draws the rows of a :class:`ScoreScene`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, 4, parent)
        self._rows: tuple[ScoreRow, ...] = ()
        self.setAccessibleName(self.tr("Score"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setShowGrid(False)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 3)
        names = (
            self.tr("Figure"),
            self.tr("All frames"),
            self.tr("Frames shown"),
            self.tr("Last edits"),
        )
        self.setHorizontalHeaderLabels(names)
        header, width = self.horizontalHeader(), self.fontMetrics().horizontalAdvance
        header.setHighlightSections(False)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column, (name, widest) in enumerate(
            zip(names[1:], (_WIDEST, _WIDEST, _WIDEST_MOVE), strict=True), 1
        ):
            self.setColumnWidth(column, max(width(name), width(widest)) + _PAD_PX)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        first = QTableWidgetItem(names[0])
        first.setTextAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        self.setHorizontalHeaderItem(0, first)

    def show_scene(self, scene: ScoreScene) -> None:
        """Show other figures; only rows that are others are written."""
        for column, frames in ((1, scene.whole), (2, scene.visible), (3, scene.moved)):
            item = self.horizontalHeaderItem(column)
            if item is not None and frames:
                told = self.tr("frames {0}").format(frames) if column < 3 else frames
                item.setToolTip(told)
        if len(scene.rows) != len(self._rows):
            self.setRowCount(len(scene.rows))
        for number, row in enumerate(scene.rows):
            if number >= len(self._rows) or self._rows[number] != row:
                self._write(number, row)
        self._rows = scene.rows

    def _write(self, number: int, row: ScoreRow) -> None:
        for column, text in enumerate((row.name, row.whole, row.visible, row.moved)):
            write_cell(self, number, column, text, row.hint)
        moved = self.item(number, 3)
        if moved is not None:
            moved.setForeground(_colour(row.better))
            said = {1: self.tr("better"), -1: self.tr("worse")}.get(row.better, "")
            moved.setData(Qt.ItemDataRole.AccessibleTextRole, f"{row.moved} {said}".strip())

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            for number, row in enumerate(self._rows):
                self._write(number, row)


def _colour(better: int) -> QColor:
    theme = current_theme()
    return {1: theme.good, -1: theme.danger}.get(better, theme.text_muted)
