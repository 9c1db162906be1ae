"""Icons: our own SVG drawings, coloured by the theme."""

from __future__ import annotations

from functools import cache
from importlib.resources import files

from PySide6.QtCore import QByteArray, QEvent, QSize, Qt
from PySide6.QtGui import QColor, QGuiApplication, QIcon, QPainter, QPalette, QPixmap, QPixmapCache
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QToolButton, QWidget

from app.core.keymap import first_key
from app.core.look.theme import current_theme

_SIZES_PX = (16, 20, 24, 32, 48, 64)


@cache
def _drawing(name: str) -> str:
    return (files("resources") / "icons" / f"{name}.svg").read_text(encoding="utf-8")


def pixmap(name: str, colour: QColor, size_px: int) -> QPixmap:
    """Draw an icon at a size in device pixels; `currentColor` in the SVG becomes the colour.

    What was drawn before is had from Qt's cache: a window asks for the same few thousand times.
    """
    key, kept = f"{name} {colour.name()} {size_px}", QPixmap()
    if QPixmapCache.find(key, kept):
        return kept
    text = _drawing(name).replace("currentColor", colour.name())
    picture = QPixmap(size_px, size_px)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    QSvgRenderer(QByteArray(text.encode())).render(painter)
    painter.end()
    QPixmapCache.insert(key, picture)
    return picture


def icon(name: str, colour: QColor | None = None) -> QIcon:
    """An icon in a colour, the program's text colour by default, sharp at 100 to 200 %."""
    palette, group = QGuiApplication.palette(), QPalette.ColorGroup
    role = QPalette.ColorRole.WindowText
    drawn = QIcon()
    for size_px in _SIZES_PX:
        enabled = colour or palette.color(group.Active, role)
        drawn.addPixmap(pixmap(name, enabled, size_px), QIcon.Mode.Normal)
        greyed = palette.color(group.Disabled, role)
        drawn.addPixmap(pixmap(name, greyed, size_px), QIcon.Mode.Disabled)
    return drawn


def application_icon() -> QIcon:
    """The program's own icon, in its own colours."""
    drawn = QIcon()
    for size_px in (*_SIZES_PX, 128, 256):
        drawn.addPixmap(pixmap("trackwright", QColor(0, 0, 0), size_px))
    return drawn


class IconButton(QToolButton):
    """A tool button whose icon follows the theme; its name is told to screen readers.

    Where it does what a command does, its tooltip names the key of that command.
    """

    def __init__(
        self,
        drawing: str,
        name: str,
        command: str = "",
        parent: QWidget | None = None,
        primary: bool = False,
    ) -> None:
        super().__init__(parent)
        self._icon_name = drawing
        self._primary = primary
        self.setProperty("primary", primary)
        self.setAccessibleName(name)
        self._name, self._command = name, command
        self.setToolTip(self._tip())
        self.setIconSize(QSize(20, 20))
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # every one has a key of the window
        self._recolour()

    def set_name(self, name: str) -> None:
        """It does something else by now."""
        self._name = name
        self.setAccessibleName(name)
        self.setToolTip(self._tip())

    def set_drawing(self, drawing: str) -> None:
        """Show another icon."""
        if drawing != self._icon_name:
            self._icon_name = drawing
            self._recolour()

    def event(self, event: QEvent) -> bool:
        """Name the key in use, which the user may have changed."""
        if event.type() == QEvent.Type.ToolTip and self._command:
            self.setToolTip(self._tip())
        return super().event(event)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802 - Qt's name
        """Follow the theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._recolour()

    def _tip(self) -> str:
        key = first_key(self._command)
        return f"{self._name}  ({key})" if key else self._name

    def _recolour(self) -> None:
        theme = current_theme()
        colour = theme.accent_text if self._primary else theme.text
        self.setIcon(icon(self._icon_name, colour))
