"""The list of the review queue, and under it further reasons in the room there is."""

from __future__ import annotations

from itertools import pairwise

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QResizeEvent, QTextLayout
from PySide6.QtWidgets import QListView, QSizePolicy, QWidget

from app.core.look.theme import current_theme


class QueueView(QListView):
    """A list of whole rows that keeps its current one in sight, also when it gets less room."""

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """No higher than it must be: it has what is left, and in a low place buttons are seen."""
        return QSize(super().sizeHint().width(), self.minimumHeight())

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """The list was given other room: what is left below the last whole row stays empty."""
        super().resizeEvent(event)
        row, room = self.sizeHintForRow(0), self.height() - 2 * self.frameWidth()
        below = room % row if 0 < row <= room else 0
        if self.viewportMargins().bottom() != below:
            self.setViewportMargins(0, 0, 0, below)
        if self.currentIndex().isValid() and self.selectionModel().hasSelection():
            self.scrollTo(self.currentIndex())


class FewLines(QWidget):
    """Words on at most three lines, always as high: what is beside it stays where it is.

    What has no room ends in an ellipsis; the tooltip says it all.
    """

    LINES = 3
    _ABOVE = 4

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._text = ""
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def text(self) -> str:
        """The whole of it."""
        return self._text

    def setText(self, text: str) -> None:  # noqa: N802 - as labels have it
        """Say something else."""
        self._text = text
        self.setToolTip(text)
        self.setAccessibleName(text)
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """All lines, whatever is said."""
        return QSize(64, self._ABOVE + self.LINES * self.fontMetrics().lineSpacing())

    def lines(self) -> list[str]:
        """What is drawn, line by line."""
        laid = QTextLayout(self._text, self.font())
        laid.beginLayout()
        cuts = []
        while (line := laid.createLine()).isValid():
            line.setLineWidth(self.width())
            cuts.append(line.textStart())
        laid.endLayout()
        cuts.append(len(self._text))
        parts = [self._text[a:b].strip() for a, b in pairwise(cuts)]
        if len(parts) > self.LINES:
            rest = self._text[cuts[self.LINES - 1] :]
            elided = Qt.TextElideMode.ElideRight
            last = self.fontMetrics().elidedText(rest, elided, self.width())
            parts = [*parts[: self.LINES - 1], last]
        return parts

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        """Draw the lines."""
        del event
        painter = QPainter(self)
        painter.setPen(current_theme().text_muted)
        metrics = self.fontMetrics()
        first = self._ABOVE + metrics.ascent()
        for number, line in enumerate(self.lines()):
            painter.drawText(QPointF(0, first + number * metrics.lineSpacing()), line)
