"""What is shown only where there is room for it."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QSizePolicy, QWidget


class RoomLeft(QWidget):
    """Takes the room the others in its line leave, and shows its content where all of it fits.

    It asks for no room itself: a narrow screen goes without the content.
    """

    def __init__(self, content: QWidget, parent: QWidget) -> None:
        super().__init__(parent)
        self._content = content
        self._laid_out = False
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(content, 1, Qt.AlignmentFlag.AlignRight)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """All of its content's, also while that is hidden."""
        return self._content.sizeHint()

    def minimumSizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """No width at all, though it would like all of its content's."""
        return QSize(0, super().minimumSizeHint().height())

    def fit(self) -> None:
        """Show the content, which may be another, or hide it."""
        if not self._laid_out:
            return
        fits = self._content.sizeHint().width() <= self.width()
        if fits == self._content.isHidden():
            self._content.setVisible(fits)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """There is more room, or less."""
        super().resizeEvent(event)
        self._laid_out = True
        self.fit()
