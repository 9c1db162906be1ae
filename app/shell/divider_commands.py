"""The commands that divide the pictures between two versions of the tracks."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import recording
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.shell.window_app import WindowApp

_MENU, _STEP = "Tracks/Comparison", 0.05


def _compared(app: WindowApp) -> str:
    """Two versions must be drawn."""
    if app.document is not None and app.files.beside.compares:
        return ""
    return recording(app) or tr(
        "compare two runs{key}, or another session, first", key=in_brackets("tracks.runs")
    )


def _divided(app: WindowApp) -> str:
    """The pictures must be divided."""
    if app.document is None or app.files.beside.share is not None:
        return _compared(app)
    return tr("divide the pictures first")


def _divide(app: WindowApp) -> None:
    app.files.beside.divide(0.5 if app.files.beside.share is None else None)


def _move(app: WindowApp, step: float) -> None:
    app.files.beside.divide((app.files.beside.share or 0.0) + step)


COMMANDS: Final = (
    Command[WindowApp](
        "view.divide",
        "Divide the pictures between two versions",
        _MENU,
        ("Ctrl+Shift+D",),
        _compared,
        _divide,
        checked=lambda app: app.document is not None and app.files.beside.share is not None,
        separated=True,
        also="side by side compare runs split wipe",
    ),
    Command[WindowApp](
        "view.divide_left",
        "Divider to the left",
        _MENU,
        ("Ctrl+,",),
        _divided,
        lambda app: _move(app, -_STEP),
    ),
    Command[WindowApp](
        "view.divide_right",
        "Divider to the right",
        _MENU,
        ("Ctrl+.",),
        _divided,
        lambda app: _move(app, _STEP),
    ),
)
