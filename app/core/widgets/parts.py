"""Pieces that several panels are made of."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLayout,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from app.core.look.theme import current_theme, scaled_font
from app.core.scenes import Colour
from app.core.widgets.eliding_label import ElidingLabel

NOTICE_MARGINS = (16, 10, 20, 10)
"""Of what stands above the panels: flush with their words, clear of the window's edge."""
_CLEARANCE_PX = 4
_UNLIMITED = 2**24 - 1
"""The height that Qt takes for no limit at all."""


class Panel(QFrame):
    """A titled column at the right of the window."""

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._low = False
        self._menu: QWidget | None = None
        self.setProperty("panel", True)
        self.setAccessibleName(title)
        self._rows = QVBoxLayout(self)
        self._rows.setContentsMargins(16, 6, 16, 6)
        self._rows.setSpacing(6)
        self._heading = QHBoxLayout()
        self._heading.setSpacing(4)
        self._named = ElidingLabel(title, self)
        self._named.setFont(scaled_font(self.font(), 1.0, bold=True))
        self._heading.addWidget(self._named, 1)
        self._rows.addLayout(self._heading)

    def set_title(self, title: str) -> None:
        """Say in the title whose the content is."""
        self._named.setText(title)

    def add_to_heading(self, widget: QWidget, stretch: int = 0) -> None:
        """Put something small at the right of the title; `stretch` is its share of the rest."""
        last = self._heading.count() - (1 if self._menu is not None else 0)
        if stretch:  # the title is as wide as its words; what is beside it has the rest
            self._heading.setStretchFactor(self._named, 0)
            policy = widget.sizePolicy()
            policy.setHorizontalPolicy(QSizePolicy.Policy.Ignored)
            widget.setSizePolicy(policy)
        self._heading.insertWidget(last, widget, stretch)

    def set_menu(self, button: QWidget) -> None:
        """Put the button of the panel's own menu at the end of the title."""
        self._heading.addWidget(button)
        self._menu = button

    def layout_body(self, body: QLayout) -> None:
        """Put the panel's content under the title."""
        self._rows.addLayout(body, 1)

    def keep_low(self, low: bool) -> None:
        """Give the room that is not needed to the other panels, or take it again."""
        self._low = low
        self._limit()

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Words wrap at another place."""
        super().resizeEvent(event)
        if self._low:
            self._limit()

    def _limit(self) -> None:
        """A low panel is exactly as high as all its words are at its width."""
        rows, height = self._rows, self._rows.totalMinimumSize().height()
        if self._low and rows.hasHeightForWidth():
            height = max(height, rows.totalHeightForWidth(self.width()))
        self.setMinimumHeight(height if self._low else 0)
        self.setMaximumHeight(height if self._low else _UNLIMITED)


def quiet_beside(text: str, parent: QWidget) -> ElidingLabel:
    """A label in a softer colour beside what it names, which gives way where there is no room."""
    label = ElidingLabel(text, parent)
    label.setProperty("role", "muted")
    return label


def heading(text: str, parent: QWidget) -> QLabel:
    """A panel's title."""
    label = QLabel(text, parent)
    label.setFont(scaled_font(parent.font(), 1.0, bold=True))
    return label


def quiet(text: str, parent: QWidget, role: str = "muted") -> QLabel:
    """A label in a softer colour; `role` is "muted" or "faint", or "warning"."""
    label = QLabel(text, parent)
    label.setProperty("role", role)
    return label


class Swatch(QWidget):
    """A spot in a track's colour."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._colour = QColor(0, 0, 0, 0)
        self._track: Colour | None = None

    def set_colour(self, colour: QColor) -> None:
        """Show another colour."""
        self._colour, self._track = colour, None
        self.update()

    def set_track_colour(self, colour: Colour) -> None:
        """Show a track's, as the look there is shows it: also after another was chosen."""
        self._track = colour
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
        track = self._track
        painter.setBrush(self._colour if track is None else current_theme().track(track))
        side = min(self.width(), self.height(), self.fontMetrics().ascent())
        painter.drawEllipse(self.rect().center(), side // 2, side // 2)


def bring_into_view(widget: QWidget) -> None:
    """Scroll whatever the widget lies in, the innermost first, so that it is seen."""
    around = widget.parentWidget()
    while around is not None:
        if isinstance(around, QScrollArea):
            around.ensureWidgetVisible(widget, 0, _CLEARANCE_PX)  # Qt's own would scroll past it
        around = around.parentWidget()
