"""A track's colour as it is shown: on a background that would swallow it, another one."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files
from typing import Final

from app.core.colours.palette import LIGHT_COLOURS, colour_of_code
from app.core.scenes import Colour

THEMES: Final = ("dark", "light")
GROUNDS: Final = ("window", "surface", "raised", "sunken", "hover", "selection")
"""What the colours of people stand on: panels, lanes, the floor, rows under the mouse or chosen."""
LEAST_CONTRAST: Final = 3.0
"""Of a line or a bar against any of them [WCAG 2.1, 1.4.11]."""
_STEP, _MOST_STEPS = 0.05, 16


@cache
def theme_table(theme_name: str) -> dict[str, str]:
    """The colours of `dark` or `light` as they stand in the resources, by what they are for."""
    text = (files("resources") / "themes" / f"{theme_name}.toml").read_text(encoding="utf-8")
    colours: dict[str, str] = tomllib.loads(text)["colours"]
    return colours


def theme_colour(theme_name: str, use: str) -> Colour:
    """A colour of `dark` or `light` by what it is for."""
    return colour_of_code(theme_table(theme_name)[use])


@cache
def readable_colour(theme_name: str, colour: Colour) -> Colour:
    """The colour, moved towards the text's until it stands out; for people's the one found."""
    if theme_name == "light" and colour in LIGHT_COLOURS:
        return LIGHT_COLOURS[colour]
    grounds = [theme_colour(theme_name, use) for use in GROUNDS]
    text = theme_colour(theme_name, "text")
    for step in range(_MOST_STEPS + 1):
        moved = _mixed(colour, text, step * _STEP)
        if min(contrast(moved, one) for one in grounds) >= LEAST_CONTRAST:
            return moved
    return text


def contrast(one: Colour, other: Colour) -> float:
    """How well two colours are told apart, 1 to 21 [WCAG 2.1, contrast ratio]."""
    low, high = sorted((_luminance(one), _luminance(other)))
    return (high + 0.05) / (low + 0.05)


def _luminance(colour: Colour) -> float:
    linear = [
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4
        for part in (value / 255 for value in colour)
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def _mixed(one: Colour, other: Colour, share: float) -> Colour:
    red, green, blue = (round(a + share * (b - a)) for a, b in zip(one, other, strict=True))
    return red, green, blue
