"""Pieces that several panels are made of."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLayout,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.views.look.icons import pixmap
from app.views.look.theme import current_theme, scaled_font


class Panel(QFrame):
    """A titled column at the right of the window."""

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("panel", True)
        self.setAccessibleName(title)
        self._rows = QVBoxLayout(self)
        self._rows.setContentsMargins(16, 12, 16, 12)
        self._rows.setSpacing(8)
        self._heading = QHBoxLayout()
        self._heading.setSpacing(4)
        self._heading.addWidget(heading(title, self), 1)
        self._rows.addLayout(self._heading)

    def add_to_heading(self, widget: QWidget) -> None:
        """Put something small at the right of the title."""
        self._heading.addWidget(widget)

    def layout_body(self, body: QLayout) -> None:
        """Put the panel's content under the title."""
        self._rows.addLayout(body, 1)


def heading(text: str, parent: QWidget) -> QLabel:
    """A panel's title."""
    label = QLabel(text, parent)
    label.setFont(scaled_font(parent.font(), 1.0, bold=True))
    return label


def quiet(text: str, parent: QWidget, role: str = "muted") -> QLabel:
    """A label in a softer colour; `role` is "muted" or "faint"."""
    label = QLabel(text, parent)
    label.setProperty("role", role)
    return label


class Swatch(QWidget):
    """A spot in a track's colour."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._colour = QColor(0, 0, 0, 0)

    def set_colour(self, colour: QColor) -> None:
        """Show another colour."""
        self._colour = colour
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """A spot as high as small letters."""
        side = self.fontMetrics().ascent()
        return QSize(side, side)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """A disc."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._colour)
        side = min(self.width(), self.height(), self.fontMetrics().ascent())
        painter.drawEllipse(self.rect().center(), side // 2, side // 2)


class EmptyState(QWidget):
    """An icon, what there is not, and what to do next."""

    def __init__(self, drawing: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._drawing = drawing
        self._icon = QLabel(self)
        self._icon.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self._title = QLabel(self)
        self._title.setAlignment(Qt.AlignmentFlag.AlignHCenter)
        self._title.setFont(scaled_font(self.font(), 1.0, bold=True))
        self._text = quiet("", self)
        self._text.setWordWrap(True)
        self._text.setAlignment(Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop)
        self._text.setMinimumHeight(2 * self.fontMetrics().lineSpacing())
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(4)
        rows.addStretch(1)
        for widget in (self._icon, self._title, self._text):
            rows.addWidget(widget)
        rows.addStretch(2)
        self._recolour()

    def say(self, title: str, text: str) -> None:
        """Change the words."""
        self._title.setText(title)
        self._text.setText(text)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._recolour()

    def _recolour(self) -> None:
        ratio = self.devicePixelRatioF()
        drawn = pixmap(self._drawing, current_theme().text_faint, round(28 * ratio))
        drawn.setDevicePixelRatio(ratio)
        self._icon.setPixmap(drawn)


def bring_into_view(widget: QWidget) -> None:
    """Scroll whatever the widget lies in, the innermost first, so that it is seen."""
    around = widget.parentWidget()
    while around is not None:
        if isinstance(around, QScrollArea):
            around.ensureWidgetVisible(widget)
        around = around.parentWidget()
