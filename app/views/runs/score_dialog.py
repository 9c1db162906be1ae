"""How the tracks compare with the truth beside the recording."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QGridLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from app.views.widgets.parts import heading, quiet

_SHARES = ("MOTA", "IDF1", "HOTA", "DetA", "AssA", "tracking_accuracy")
_COUNTS = (
    "truth_people",
    "people_detected",
    "people_kept",
    "id_switches",
    "fragmentations",
    "false_positives",
    "misses",
)


class ScoreDialog(QDialog):
    """Shows the figures of one score, as the command line's `score --json` names them."""

    def __init__(self, figures: Mapping[str, Any], title: str, parent: QWidget | None = None):
        super().__init__(parent)
        self.setWindowTitle(self.tr("Score against truth"))
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        rows.addWidget(quiet(title, self))
        grid = QGridLayout()
        grid.setHorizontalSpacing(32)
        grid.setVerticalSpacing(6)
        rows.addLayout(grid)
        self._fill(grid, 0, self.tr("Shares"), [(n, _number(figures.get(n))) for n in _SHARES])
        self._fill(grid, 2, self.tr("Counts"), [(n, _count(figures.get(n))) for n in _COUNTS])
        error = figures.get("position_error_m") or {}
        names = ("mean", "median", "p95")
        lines = [(name, _metres(error.get(name))) for name in names]
        self._fill(grid, 4, self.tr("Floor error"), lines)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        buttons.rejected.connect(self.reject)
        rows.addWidget(buttons)

    def _fill(
        self, grid: QGridLayout, column: int, title: str, lines: list[tuple[str, str]]
    ) -> None:
        grid.addWidget(heading(title, self), 0, column, 1, 2)
        for row, (name, text) in enumerate(lines, start=1):
            grid.addWidget(quiet(name.replace("_", " "), self), row, column)
            value = QLabel(text, self)
            value.setAccessibleName(f"{name} {text}")
            value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            grid.addWidget(value, row, column + 1, Qt.AlignmentFlag.AlignRight)


def _number(value: float | None) -> str:
    return "\u2013" if value is None or value != value else f"{value:.3f}"


def _count(value: int | None) -> str:
    return "\u2013" if value is None else str(value)


def _metres(value: float | None) -> str:
    return "\u2013" if value is None or value != value else f"{value:.2f} m"
