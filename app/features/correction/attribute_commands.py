"""The commands for attributes: which people have, and the keys that set one of them."""

from __future__ import annotations

from functools import partial
from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import editable, selected, session
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.features.correction.attribute_controller import MOST_KEYS, AttributeController
from app.features.correction.commands import CorrectionApp

_MENU = "Tracks/Attributes"


def _with_options(app: CorrectionApp) -> str:
    """The schema must have an attribute that digit keys can set."""
    if editable(app) or session(app):
        return editable(app) or session(app)
    if any(one.options for one in app.of(AttributeController).schema):
        return ""
    return tr("define a choice or a yes or no first{key}", key=in_brackets("tracks.schema"))


def _has_option(app: CorrectionApp, number: int) -> str:
    """Somebody must be selected, and the active attribute must have so many options."""
    if selected(app):
        return selected(app)
    active = app.of(AttributeController).active
    if active is None:
        key = in_brackets("tracks.next_attribute")
        return tr("choose first which attribute the digit keys set{key}", key=key)
    few = number > len(active.options)
    return tr("{name} has fewer options", name=active.name) if few else ""


def _choose(app: CorrectionApp, number: int) -> None:
    app.of(AttributeController).choose(number)


COMMANDS: Final[tuple[Command[CorrectionApp], ...]] = (
    Command(
        "tracks.schema",
        "Which attributes people have...",
        _MENU,
        ("Ctrl+Shift+F2",),
        lambda app: editable(app) or session(app),
        lambda app: app.of(AttributeController).ask_schema(),
    ),
    Command(
        "tracks.next_attribute",
        "Digit keys set the next attribute",
        _MENU,
        ("Shift+M",),
        _with_options,
        lambda app: app.of(AttributeController).next_active(),
    ),
    *(
        Command[CorrectionApp](
            f"tracks.value{number}",
            f"Option {number}",
            _MENU,
            (f"Ctrl+{number}",),
            partial(_has_option, number=number),
            partial(_choose, number=number),
            separated=number == 1,
        )
        for number in range(1, MOST_KEYS + 1)
    ),
)
