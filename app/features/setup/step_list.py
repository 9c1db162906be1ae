"""The list of the set-up's steps, each with how it stands."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QIcon, QPainter, QPen, QPixmap
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from app.core.i18n import tr
from app.core.look.icons import icon
from app.core.look.theme import Theme, current_theme
from app.features.setup.presenter import STEPS, step_title
from app.features.setup.scene import Mark

_LETTERS = 23
_SIDE_PX, _RING_PX = 18, 48
_AROUND_PX = 30
"""Around the words of a step and beside its mark."""


class StepList(QListWidget):
    """Steps to choose with mouse or arrow keys.

    Signals: chosen(row).
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._marks: tuple[tuple[Mark, str], ...] = ()
        self.setAccessibleName(tr("Steps"))
        letters = self.fontMetrics()
        widest = max(letters.horizontalAdvance(step_title(step)) for step in STEPS)
        least = _LETTERS * letters.averageCharWidth()
        self.setFixedWidth(max(least, widest + _SIDE_PX + _AROUND_PX))
        self.setIconSize(QSize(_SIDE_PX, _SIDE_PX))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWordWrap(True)
        self.setSpacing(1)
        for number, step in enumerate(STEPS, 1):
            self.addItem(QListWidgetItem(f"{number}  {step_title(step)}"))
        self.setCurrentRow(0)
        self.currentRowChanged.connect(self.chosen)

    def choose(self, row: int) -> None:
        """Go to a step."""
        self.setCurrentRow(min(max(row, 0), self.count() - 1))

    def show_marks(self, marks: Sequence[tuple[Mark, str]]) -> None:
        """Show how each step stands."""
        theme, self._marks = current_theme(), tuple(marks)
        for row, (step, (mark, why)) in enumerate(zip(STEPS, marks, strict=True)):
            item = self.item(row)
            title = step_title(step)
            item.setText(f"{title}\n{why}")
            item.setIcon(_icon(mark, theme))
            said = tr("{step}: {mark}", step=title, mark=why)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, said)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Marks have the colours of the theme."""
        if event.type() == QEvent.Type.PaletteChange and self._marks:
            self.show_marks(self._marks)
        super().changeEvent(event)


def _icon(mark: Mark, theme: Theme) -> QIcon:
    """A tick where a step is done, a warning, and a ring where it is open."""
    if mark is Mark.DONE:
        return icon("check", theme.good)
    if mark is Mark.WARNING:
        return icon("warning", theme.warning)
    drawn = QPixmap(_RING_PX, _RING_PX)
    drawn.fill(Qt.GlobalColor.transparent)
    painter = QPainter(drawn)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(theme.text_faint, _RING_PX / 12))
    edge = _RING_PX // 5
    painter.drawEllipse(drawn.rect().adjusted(edge, edge, -edge, -edge))
    painter.end()
    return QIcon(drawn)
