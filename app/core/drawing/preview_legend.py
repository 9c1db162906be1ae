"""How the trails of a previewed edit are drawn: as they are now, and as they would be."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from app.core.drawing.people_marks import preview_pen
from app.core.i18n import tr
from app.core.look.theme import current_theme

_LINE_PX, _GAP_PX, _APART_PX = 34, 6, 18


class PreviewLegend(QWidget):
    """A line of each kind with its word: before, after."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._words = (tr("before"), tr("after"))
        self.setAccessibleName(tr("Dashed trails: before the edit; solid ones: after it"))

    def set_words(self, dashed: str, solid: str) -> None:
        """Say something else of the dashed and of the solid trails."""
        self._words = (dashed, solid)
        self.setAccessibleName(tr("Dashed: {0}; solid: {1}").format(dashed, solid))
        self.updateGeometry()
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Both beside each other."""
        words = sum(self.fontMetrics().horizontalAdvance(word) for word in self._words)
        width = words + 2 * (_LINE_PX + _GAP_PX) + _APART_PX
        return QSize(width, self.fontMetrics().height())

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """They are never cut off."""
        return self.sizeHint()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """With the same pens as the trails themselves, in the colour of the words."""
        theme, painter = current_theme(), QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        left, middle = 0.0, self.height() / 2
        for after, word in enumerate(self._words):
            painter.setPen(preview_pen(theme.text_muted, bool(after)))
            painter.drawLine(QLineF(left, middle, left + _LINE_PX, middle))
            left += _LINE_PX + _GAP_PX
            width = self.fontMetrics().horizontalAdvance(word)
            painter.setPen(theme.text_muted)
            place = QRectF(left, 0, width + 1, self.height())
            painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, word)
            left += width + _APART_PX
        painter.end()
