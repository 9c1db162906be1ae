"""Dark and light: colours as data, laid over Qt's palette and a small stylesheet.

The palette is the one truth: a widget asks :func:`current_theme` while painting, and Qt itself
repaints it when the look changes.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from enum import Enum
from functools import cache
from importlib.resources import files
from pathlib import Path
from string import Template

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from app.core.colours import shown_colours
from app.core.colours.shown_colours import readable_colour, theme_table
from app.core.i18n import tr
from app.core.scenes import Colour

_SIGNS = ("check", "partly", "dot", "up", "down")
"""Pictures of what is ticked, partly ticked, chosen, and of the arrows of fields."""


class Look(Enum):
    """What the user chose."""

    SYSTEM = "system"
    LIGHT = "light"
    DARK = "dark"


@dataclass(frozen=True, slots=True)
class Theme:
    """The colours of one look, named by what they are for; see `resources/themes`."""

    name: str
    window: QColor
    surface: QColor
    raised: QColor
    sunken: QColor
    line: QColor
    line_strong: QColor
    field: QColor
    text: QColor
    text_muted: QColor
    text_faint: QColor
    text_disabled: QColor
    accent: QColor
    accent_fill: QColor
    accent_hover: QColor
    accent_text: QColor
    hover: QColor
    pressed: QColor
    selection: QColor
    good: QColor
    warning: QColor
    danger: QColor
    danger_ground: QColor
    grid: QColor
    grid_major: QColor
    measured: QColor
    measured_rim: QColor
    shadow: QColor

    @property
    def is_dark(self) -> bool:
        """Whether light text stands on a dark ground."""
        return self.window.lightness() < 128

    def track(self, colour: Colour) -> QColor:
        """A track's colour, moved towards the text's where the ground would swallow it."""
        return _standing_out(self.name, colour)


@cache
def load_theme(name: str) -> Theme:
    """Read `dark` or `light` from the resources."""
    return Theme(name, **{key: QColor(code) for key, code in theme_table(name).items()})


@cache
def _standing_out(theme_name: str, colour: Colour) -> QColor:
    return QColor(*readable_colour(theme_name, colour))


def current_theme() -> Theme:
    """The theme that fits the program's palette as it is now.

    Not a widget's own palette: the stylesheet puts a button's ground in there.
    """
    ground = QGuiApplication.palette().color(QPalette.ColorRole.Window)
    return load_theme("dark" if ground.lightness() < 128 else "light")


def apply_look(application: QApplication, look: Look) -> Theme:
    """Give the program a look; SYSTEM takes what the desktop says now.

    Call it again when `QStyleHints.colorSchemeChanged` fires to follow the desktop.
    """
    theme = load_theme(_theme_name(look))
    sheet = stylesheet(theme)
    if application.styleSheet() != sheet:  # setting it again would polish every widget anew
        application.setStyle("Fusion")
        application.setPalette(_palette(theme))
        application.setStyleSheet(sheet)
    return theme


def _theme_name(look: Look) -> str:
    desktop_dark = QGuiApplication.styleHints().colorScheme() is Qt.ColorScheme.Dark
    dark = look is Look.DARK or (look is Look.SYSTEM and desktop_dark)
    return "dark" if dark else "light"


def stylesheet(theme: Theme) -> str:
    """The stylesheet with the theme's colours filled in."""
    themes = files("resources") / "themes"
    text = (themes / "style.qss").read_text(encoding="utf-8")
    colours = {
        one.name: colour.name()
        for one in fields(theme)
        if isinstance(colour := getattr(theme, one.name), QColor)
    }
    signs = {name: _as_url(themes / f"{name}.svg") for name in _SIGNS}
    filled: str = Template(text).substitute(colours | signs)
    return filled


def _as_url(file: object) -> str:
    """A file as a stylesheet between quotes writes it."""
    return Path(str(file)).as_posix().replace("\\", "\\\\").replace('"', '\\"')


def _palette(theme: Theme) -> QPalette:
    role = QPalette.ColorRole
    palette = QPalette(theme.raised, theme.window)
    for roles, colour in (
        ((role.Window,), theme.window),
        ((role.Base,), theme.surface),
        ((role.AlternateBase, role.Button, role.ToolTipBase), theme.raised),
        ((role.WindowText, role.Text, role.ButtonText, role.ToolTipText), theme.text),
        ((role.PlaceholderText,), theme.text_faint),
        ((role.Highlight, role.Accent), theme.accent_fill),
        ((role.HighlightedText, role.BrightText), theme.accent_text),
        ((role.Link,), theme.accent),
        ((role.Mid, role.Dark), theme.line_strong),
        ((role.Light, role.Midlight), theme.line),
        ((role.Shadow,), theme.shadow),
    ):
        for one in roles:
            palette.setColor(one, colour)
    for one in (role.WindowText, role.Text, role.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, one, theme.text_disabled)
    return palette


def scaled_font(font: QFont, factor: float, bold: bool = False) -> QFont:
    """The font at another size, with figures of equal width so that numbers do not jump."""
    changed = QFont(font)
    if font.pointSizeF() > 0:
        changed.setPointSizeF(font.pointSizeF() * factor)
    else:
        changed.setPixelSize(max(1, round(font.pixelSize() * factor)))
    if bold:
        changed.setWeight(QFont.Weight.DemiBold)
    changed.setFeature(QFont.Tag("tnum"), 1)
    return changed


def line_height(font: QFont) -> int:
    """How high a line is, px; letters of the language in use may come from a higher font."""
    metrics = QFontMetrics(font)
    return max(metrics.height(), metrics.boundingRect(tr("Frame")).height())


def faded(colour: QColor, opacity: float) -> QColor:
    """The colour with its alpha times `opacity` (0..1)."""
    other = QColor(colour)
    other.setAlphaF(colour.alphaF() * opacity)
    return other


def ink_on(ground: QColor) -> QColor:
    """Black or white, whichever reads better on the ground."""
    return _ink_on(ground.rgb())


@cache
def _ink_on(rgb: int) -> QColor:
    dark, light = QColor(16, 18, 20), QColor(255, 255, 255)
    return max(dark, light, key=lambda ink: contrast(ink, QColor.fromRgb(rgb)))


def contrast(one: QColor, other: QColor) -> float:
    """How well two colours are told apart, 1 to 21; see `shown_colours.contrast`."""
    return shown_colours.contrast(
        (one.red(), one.green(), one.blue()), (other.red(), other.green(), other.blue())
    )
