"""The figures of a score: over all frames, over those shown, and how the last edits moved them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QColor, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.theme import current_theme, scaled_font
from app.core.scenes.score_figures import ScoreRow
from app.core.widgets.table_cells import write_cell
from app.features.scoring.scene import ScoreScene

_COLUMNS, _MOST_GROUPS = 4, 3
_WIDEST, _WIDEST_MOVE = "100.0%", "\u25b2 +88.888"
_PAD_PX, _TIGHT_PAD_PX = 28, 22
"""Beside a figure; tight where several stand side by side."""


class FiguresTable(QTableWidget):
    """Draws the rows of a :class:`ScoreScene`, in groups side by side where it is too low.

    A group has the columns name, all frames, frames shown and last edits; where there are several,
    names and titles are short, and of a move there is the arrow; three have no room for the frames
    shown. Arrows, and the frames shown, give way to names. Tooltips say it in full.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, _COLUMNS, parent)
        self._scene: ScoreScene | None = None
        self._rows: tuple[ScoreRow, ...] = ()
        self._widths: dict[int, int] = {}  # by part of a group: a hidden column has none
        self.setAccessibleName(tr("Score"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setShowGrid(False)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.verticalHeader().hide()
        self._line = self.fontMetrics().height() + 2
        self.verticalHeader().setMinimumSectionSize(self._line)
        self.verticalHeader().setDefaultSectionSize(self._line)
        self.horizontalHeader().setHighlightSections(False)
        self._title()

    @property
    def groups(self) -> int:
        """How many figures stand side by side."""
        return self.columnCount() // _COLUMNS

    def show_scene(self, scene: ScoreScene) -> None:
        """Show other figures; only those that are others are written."""
        self._scene = scene
        if len(scene.rows) != len(self._rows):
            self._rows = ()
            self._arrange(len(scene.rows))
        self._tell_frames()
        for number, row in enumerate(scene.rows):
            if number >= len(self._rows) or self._rows[number] != row:
                self._write(number, row)
        self._rows = scene.rows
        self._give_names_room(scene.rows)
        self.updateGeometry()

    # arranging

    def _arrange(self, figures: int) -> bool:
        """As few groups as the height allows; whether there are others than before."""
        around, line = self.horizontalHeader().sizeHint().height() + 2, self._line
        self.setMinimumHeight(around + line * math.ceil(figures / _MOST_GROUPS))
        fitting = max(1, (self.height() - around) // line)
        groups = min(_MOST_GROUPS, max(1, math.ceil(figures / fitting)))
        lines = math.ceil(figures / groups)
        if (groups, lines) == (self.groups, self.rowCount()):
            return False
        self.setRowCount(0)
        self.setColumnCount(groups * _COLUMNS)
        self.setRowCount(lines)
        self._title()
        return True

    def _title(self) -> None:
        """Titles and widths of the columns."""
        full = (
            tr("Figure"),
            tr("All frames"),
            tr("Frames shown"),
            tr("Last edits"),
        )
        narrow = self.groups > 1
        names = ("", tr("All"), tr("Shown"), "") if narrow else full
        widest = (_WIDEST, _WIDEST, "\u25b2" if narrow else _WIDEST_MOVE)
        header, width = self.horizontalHeader(), self.fontMetrics().horizontalAdvance
        for column in range(self.columnCount()):
            part = column % _COLUMNS
            item = QTableWidgetItem(names[part])
            side = Qt.AlignmentFlag.AlignRight if part else Qt.AlignmentFlag.AlignLeft
            item.setTextAlignment(side | Qt.AlignmentFlag.AlignVCenter)
            item.setToolTip(full[part])
            self.setHorizontalHeaderItem(column, item)
            mode = QHeaderView.ResizeMode
            header.setSectionResizeMode(column, mode.Interactive if part else mode.Stretch)
            self.setColumnHidden(column, part == 2 and self.groups == _MOST_GROUPS)
            if part:
                px = max(width(names[part]), width(widest[part - 1]))
                self._widths[part] = px + (_TIGHT_PAD_PX if narrow else _PAD_PX)
                self.setColumnWidth(column, self._widths[part])

    def _tell_frames(self) -> None:
        scene = self._scene
        if scene is None:
            return
        for column in range(self.columnCount()):
            item, part = self.horizontalHeaderItem(column), column % _COLUMNS
            frames = ("", scene.whole, scene.visible, scene.moved)[part]
            if item is not None and frames:
                item.setToolTip(tr("frames {0}").format(frames) if part < 3 else frames)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """All figures stay in sight."""
        super().resizeEvent(event)
        if self._rows and self._arrange(len(self._rows)):
            self._tell_frames()
            for number, row in enumerate(self._rows):
                self._write(number, row)
        self._give_names_room(self._rows)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """As wide as all figures and their names."""
        letters = self.fontMetrics().horizontalAdvance
        names = max((letters(row.short or row.name) for row in self._rows), default=0)
        three = self.groups == _MOST_GROUPS
        figures = self.groups * sum(
            px for part, px in self._widths.items() if not (three and self.isColumnHidden(part))
        )
        width = figures + self.groups * (names + _PAD_PX) + 2 * self.frameWidth()
        return QSize(width, super().sizeHint().height())

    def _give_names_room(self, rows: Sequence[ScoreRow]) -> None:
        """Where there is little room: rather no arrows, then no frames shown, than cut names.

        Tooltips tell both.
        """
        letters, several = self.fontMetrics().horizontalAdvance, self.groups > 1
        told = [(several and row.short) or row.name for row in rows]
        names = max(map(letters, told), default=0) + _TIGHT_PAD_PX
        each = self.viewport().width() // self.groups
        left_out = {2} if self.groups == _MOST_GROUPS else set()
        for part in (3, 2):
            kept = sum(px for one, px in self._widths.items() if one not in left_out)
            if kept + names > each:
                left_out.add(part)
        for column in range(self.columnCount()):
            self.setColumnHidden(column, column % _COLUMNS in left_out)

    # writing

    def _write(self, number: int, row: ScoreRow) -> None:
        group, line = divmod(number, max(1, self.rowCount()))
        first, narrow = group * _COLUMNS, self.groups > 1
        name, moved = (row.short or row.name, row.moved[:1]) if narrow else (row.name, row.moved)
        hint = row.hint
        if narrow:
            shown = tr("{0} in the frames shown").format(row.visible)
            hint = "\n".join(filter(None, (row.name, row.hint, shown, row.moved)))
        for part, text in enumerate((name, row.whole, row.visible, moved)):
            item = write_cell(self, line, first + part, text, hint)
            if part == 0:
                item.setTextAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
                item.setData(Qt.ItemDataRole.AccessibleTextRole, row.name)
        item.setForeground(_colour(row.better))
        said = {1: tr("better"), -1: tr("worse")}.get(row.better, "")
        item.setFont(scaled_font(self.font(), 1.0, bold=row.better < 0))
        item.setToolTip("\n".join(filter(None, (said, hint))))
        item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{row.moved} {said}".strip())

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            for number, row in enumerate(self._rows):
                self._write(number, row)


def _colour(better: int) -> QColor:
    theme = current_theme()
    return {1: theme.good, -1: theme.danger}.get(better, theme.text_muted)
