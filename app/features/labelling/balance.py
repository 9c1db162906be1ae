"""How many labels of a part say on, and how many off: a bar that shows which are missing."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QRectF, QSize, Qt
from PySide6.QtGui import QBrush, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.core.i18n import tr
from app.core.look.theme import current_theme, faded

_LETTERS = 7
_HIGH_PX = 5.0


class BalanceBar(QWidget):
    """Filled from the left as far as labels say on; the rest, hatched, says off."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._on, self._off = 0, 0

    def show_counts(self, name: str, on: int, off: int) -> None:
        """Show other counts of a part."""
        self._on, self._off = on, off
        if on + off:
            said = tr("{0}: {1:.0f} % of {2} labels say on its part, {3:.0f} % off")
            text = said.format(name, 100 * on / (on + off), on + off, 100 * off / (on + off))
        else:
            text = tr("{0}: no labels yet").format(name)
        self.setAccessibleName(text)
        self.setToolTip(text)
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """A few letters wide."""
        return QSize(_LETTERS * self.fontMetrics().averageCharWidth(), round(_HIGH_PX) + 6)

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """Never pressed together."""
        return self.sizeHint()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """Two colours, and a line at the half."""
        theme, painter = current_theme(), QPainter(self)
        bar = QRectF(0.5, (self.height() - _HIGH_PX) / 2, self.width() - 1, _HIGH_PX)
        painter.fillRect(bar, theme.sunken)
        total = self._on + self._off
        if total:
            on = QRectF(bar.left(), bar.top(), bar.width() * self._on / total, bar.height())
            off = QRectF(on.right(), bar.top(), bar.right() - on.right(), bar.height())
            painter.fillRect(on, theme.good)
            painter.fillRect(off, faded(theme.danger, 0.35))
            painter.fillRect(off, QBrush(theme.danger, Qt.BrushStyle.BDiagPattern))
        painter.setPen(theme.text_muted)
        middle = bar.center().x()
        painter.drawLine(QLineF(middle, bar.top() - 2, middle, bar.bottom() + 2))
        painter.end()
