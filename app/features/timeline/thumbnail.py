"""The picture of a frame above the overview, while the mouse is over it."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QFrame, QLabel, QVBoxLayout, QWidget

_GAP_PX = 6


class ThumbnailPopup(QFrame):
    """A small picture with its frame and time below; it never takes the mouse."""

    def __init__(self, over: QWidget) -> None:
        """`over`: the strip that it stands above."""
        super().__init__(over)
        self._over = over
        self.setProperty("card", True)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAutoFillBackground(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 2)
        column.setSpacing(2)
        self._picture, self._words = QLabel(self), QLabel(self)
        self._words.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        column.addWidget(self._picture)
        column.addWidget(self._words)
        self.hide()

    def show_at(self, x: float, words: str, image: QImage) -> None:
        """Show a picture above a place of the strip."""
        if image.isNull():
            self.hide()
            return
        window = self._over.window()
        if self.parentWidget() is not window:
            self.setParent(window)
        self._picture.setPixmap(QPixmap.fromImage(image))
        self._words.setText(words)
        self.adjustSize()
        at = self._over.mapTo(window, QPoint(round(x) - self.width() // 2, 0))
        left = min(max(0, at.x()), max(0, window.width() - self.width()))
        self.move(left, max(0, at.y() - self.height() - _GAP_PX))
        self.show()
        self.raise_()
