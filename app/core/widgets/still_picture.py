"""What of a widget stays while something small moves over it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QColor, QPainter, QPixmap
from PySide6.QtWidgets import QWidget


class StillPicture:
    """Drawn once into a picture as large as its widget, and kept until it is forgotten."""

    def __init__(self, widget: QWidget) -> None:
        self._widget = widget
        self._drawn: QPixmap | None = None

    def forget(self) -> None:
        """Draw it anew when it is asked for next."""
        self._drawn = None

    def paint(self, painter: QPainter, ground: QColor, draw: Callable[[QPainter], None]) -> None:
        """Paint it; `draw` draws it upon the ground where it is not kept, or of another size."""
        ratio = self._widget.devicePixelRatioF()
        if self._drawn is None or self._drawn.size() != self._widget.size() * ratio:
            self._drawn = self._made(ratio, ground, draw)
        painter.drawPixmap(0, 0, self._drawn)

    def _made(self, ratio: float, ground: QColor, draw: Callable[[QPainter], None]) -> QPixmap:
        picture = QPixmap(self._widget.size() * ratio)
        picture.setDevicePixelRatio(ratio)
        picture.fill(ground)
        painter = QPainter(picture)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        draw(painter)
        painter.end()
        return picture
