from __future__ import annotations

import tomllib
from importlib.resources import files
from pathlib import Path
from xml.etree import ElementTree

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QGuiApplication
from PySide6.QtWidgets import QCheckBox, QComboBox, QDoubleSpinBox, QRadioButton, QSpinBox

from app.core.colours.palette import NOBODY, TRACK_COLOURS
from app.core.colours.shown_colours import GROUNDS
from app.core.look.icons import IconButton, application_icon, icon, pixmap
from app.core.look.theme import (
    Look,
    apply_look,
    contrast,
    current_theme,
    load_theme,
    scaled_font,
    stylesheet,
)
from app.core.scenes.ground_truth import ERROR_COLOURS
from app.core.scenes.labels import PART_COLOURS

THEMES = ("dark", "light")
ICONS = sorted(Path(str(one)).stem for one in (files("resources") / "icons").iterdir())


_EVERYWHERE = (*GROUNDS, "danger_ground")
_TEXTS = ("text", "text_muted", "text_faint", "accent", "good", "warning", "danger")
_GRAPHICS = ("field", *_TEXTS)


@pytest.mark.parametrize("name", THEMES)
@pytest.mark.parametrize("ink", _TEXTS)
@pytest.mark.parametrize("ground", _EVERYWHERE)
def test_text_is_readable_on_every_ground(name, ink, ground):
    theme = load_theme(name)
    assert contrast(getattr(theme, ink), getattr(theme, ground)) >= 4.5


@pytest.mark.parametrize("name", THEMES)
def test_text_is_readable_on_what_is_pressed_or_filled(name):
    theme = load_theme(name)
    for ink in (theme.text, theme.text_muted):
        assert contrast(ink, theme.pressed) >= 4.5
    for ground in (theme.accent_fill, theme.accent_hover):
        assert contrast(theme.accent_text, ground) >= 4.5


@pytest.mark.parametrize("name", THEMES)
@pytest.mark.parametrize("ink", _GRAPHICS)
@pytest.mark.parametrize("ground", ["window", "surface", "raised", "sunken"])
def test_lines_that_mean_something_are_seen(name, ink, ground):
    theme = load_theme(name)
    assert contrast(getattr(theme, ink), getattr(theme, ground)) >= 3.0


@pytest.mark.parametrize("name", THEMES)
@pytest.mark.parametrize("colour", [*TRACK_COLOURS, NOBODY, *ERROR_COLOURS.values(), *PART_COLOURS])
def test_every_colour_of_data_stands_out_on_every_ground(name, colour):
    theme = load_theme(name)
    for ground in GROUNDS:
        assert contrast(theme.track(colour), getattr(theme, ground)) >= 3.0


@pytest.mark.parametrize("name", THEMES)
def test_a_label_that_warns_has_the_colour_of_warnings(name):
    theme = load_theme(name)
    assert f'QLabel[role="warning"] {{ color: {theme.warning.name()}; }}' in stylesheet(theme)


def test_both_themes_name_the_same_colours():
    tables = [
        tomllib.loads((files("resources") / "themes" / f"{name}.toml").read_text("utf-8"))
        for name in THEMES
    ]
    assert tables[0]["colours"].keys() == tables[1]["colours"].keys()


@pytest.mark.parametrize("name", THEMES)
def test_the_stylesheet_is_filled_in(name):
    assert "$" not in stylesheet(load_theme(name))


def test_a_look_can_be_changed_while_the_program_runs(qapp, qtbot):
    apply_look(qapp, Look.LIGHT)
    button = IconButton("play", "Play")
    qtbot.addWidget(button)
    light = button.icon().pixmap(24, 24).toImage()
    apply_look(qapp, Look.DARK)
    assert current_theme().is_dark
    assert button.icon().pixmap(24, 24).toImage() != light


def test_the_system_look_follows_the_desktop(qapp):
    desktop_is_dark = QGuiApplication.styleHints().colorScheme() is Qt.ColorScheme.Dark
    assert apply_look(qapp, Look.SYSTEM).is_dark is desktop_is_dark


@pytest.mark.parametrize("name", ICONS)
def test_every_icon_is_drawn_in_the_colour_asked_for(qapp, name):
    shot = pixmap(name, QColor(255, 0, 0), 32).toImage()
    inks = [shot.pixelColor(x, y) for x in range(32) for y in range(32)]
    assert any(ink.alpha() > 200 for ink in inks)
    if name != "trackwright":
        assert all(ink.red() >= ink.green() for ink in inks if ink.alpha() > 200)


@pytest.mark.parametrize("name", ICONS)
def test_icons_are_plain_drawings(name):
    text = (files("resources") / "icons" / f"{name}.svg").read_text("utf-8")
    tags = {one.tag.split("}")[1] for one in ElementTree.fromstring(text).iter()}
    assert tags <= {"svg", "path", "circle", "rect"}


def test_icons_are_sharp_at_twice_the_scale(qapp):
    assert icon("play").actualSize(icon("play").availableSizes()[-1]).width() >= 48
    assert application_icon().availableSizes()[-1].width() == 256


def test_fonts_scale_from_points_and_from_pixels(qapp):
    font = qapp.font()
    font.setPointSizeF(10)
    assert scaled_font(font, 1.5).pointSizeF() == 15
    font.setPixelSize(20)
    assert scaled_font(font, 0.5).pixelSize() == 10


@pytest.mark.parametrize("name", THEMES)
@pytest.mark.parametrize("kind", [QCheckBox, QRadioButton])
def test_an_empty_box_stands_out_on_its_ground(qapp, name, kind):
    theme = apply_look(qapp, Look(name))
    box = kind("shown")
    box.resize(box.sizeHint())
    picture = box.grab().toImage()
    middle = picture.height() // 2
    letters = box.fontMetrics().height()
    most = max(contrast(picture.pixelColor(x, middle), theme.window) for x in range(letters))
    assert most >= 3


@pytest.mark.parametrize("name", THEMES)
@pytest.mark.parametrize("kind", [QComboBox, QSpinBox, QDoubleSpinBox])
def test_outline_and_arrow_of_a_field_stand_out_on_its_ground(qapp, name, kind):
    theme = apply_look(qapp, Look(name))
    field = kind()
    field.resize(160, field.sizeHint().height())
    picture = field.grab().toImage()
    middle = picture.height() // 2
    assert contrast(picture.pixelColor(0, middle), theme.window) >= 3
    end = [
        picture.pixelColor(x, y)
        for x in range(picture.width() - 18, picture.width() - 2)
        for y in range(4, picture.height() - 4)
    ]
    assert max(contrast(one, theme.raised) for one in end) >= 3
