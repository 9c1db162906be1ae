"""Commands that open, close and move panels, and lay the window out for a trade."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from PySide6.QtWidgets import QApplication

from app.core.commands.command import Command
from app.core.commands.conditions import floor, recording
from app.core.i18n import tr
from app.core.keymap import in_brackets
from app.shell.panel_docks import Dock
from app.shell.window_app import WindowApp

_PANELS = "View/Panels and layout"


@dataclass(frozen=True, slots=True)
class Layout:
    """Which panels are open.

    Attributes:
        id, title: of the command. panels: ids of those that are open.
        overhead: whether the overhead view is, where the floor is known.
        also: further words that the search finds it by.
    """

    id: str
    title: str
    panels: frozenset[str]
    overhead: bool = True
    also: str = ""


FIRST: Final = Layout("reset", "Reset layout", frozenset({"review", "card", "history"}))
LAYOUTS: Final = (
    Layout("operator", "Layout for reviewing", frozenset({"review", "card"})),
    Layout("annotator", "Layout for labelling", frozenset({"card", "history"}), overhead=False),
    Layout(
        "engineer",
        "Layout for comparing trackers",
        frozenset({"review", "card", "history", "score"}),
        also="compare scores runs",
    ),
    FIRST,
)


def lay_out(app: WindowApp, layout: Layout) -> None:
    """Open, close and place all panels as a layout says, with the shares of a first start."""
    space = app.window.workspace
    for name in _AT_ANY_TIME:
        space.docks.set_open(name, name in layout.panels)
    space.floor_wanted = layout.overhead
    app.view_options = replace(app.view_options, panels=layout.panels - _AT_ANY_TIME.keys())
    space.reset_layout()


_AT_ANY_TIME: Final = {"review": "Review queue", "card": "Track", "history": "History"}
"""Panels that no feature opens and closes, with their titles."""


def _panel(name: str, title: str) -> Command[WindowApp]:
    def switch(app: WindowApp) -> None:
        docks = app.window.workspace.docks
        docks.set_open(name, not docks.is_open(name))

    return Command(
        f"view.panel_{name}",
        title,
        _PANELS,
        (),
        recording,
        switch,
        checked=lambda app: app.document is not None and app.window.workspace.docks.is_open(name),
    )


def _switch_overhead(app: WindowApp) -> None:
    space = app.window.workspace
    space.floor_wanted = not space.floor_wanted


def _in_use(app: WindowApp) -> str:
    return app.window.workspace.docks.with_keyboard(QApplication.focusWidget())


def _panel_in_use(app: WindowApp) -> str:
    if recording(app) or _in_use(app):
        return recording(app)
    return tr("go to a panel first{key}", key=in_brackets("view.next_pane"))


def _move_to(dock: Dock) -> Callable[[WindowApp], None]:
    return lambda app: app.window.workspace.docks.move(_in_use(app), dock)


def _pane(name: str, title: str, key: str, step: int) -> Command[WindowApp]:
    return Command(
        name,
        title,
        _PANELS,
        (key,),
        recording,
        lambda app: app.window.workspace.pane_keys.go(step),
        also="keyboard focus panel",
        separated=step > 0,
    )


def _layout(layout: Layout) -> Command[WindowApp]:
    return Command(
        f"view.layout_{layout.id}",
        layout.title,
        _PANELS,
        (),
        recording,
        lambda app: lay_out(app, layout),
        separated=layout in (LAYOUTS[0], FIRST),
        also=f"preset panels {layout.id} {layout.also}".rstrip(),
    )


COMMANDS: Final[tuple[Command[WindowApp], ...]] = (
    *(_panel(name, title) for name, title in _AT_ANY_TIME.items()),
    Command(
        "view.panel_overhead",
        "Overhead view",
        _PANELS,
        (),
        floor,
        _switch_overhead,
        checked=lambda app: app.document is not None and app.window.workspace.floor_wanted,
    ),
    _pane("view.next_pane", "Go to the next part of the window", "F6", 1),
    _pane("view.previous_pane", "Go to the previous part of the window", "Shift+F6", -1),
    Command(
        "view.panel_window",
        "Panel in use: in a window of its own",
        _PANELS,
        (),
        _panel_in_use,
        _move_to(Dock.WINDOW),
    ),
    Command(
        "view.panel_side",
        "Panel in use: at the right",
        _PANELS,
        (),
        _panel_in_use,
        _move_to(Dock.SIDE),
    ),
    Command(
        "view.panel_below",
        "Panel in use: below the floor",
        _PANELS,
        (),
        _panel_in_use,
        _move_to(Dock.BELOW),
    ),
    *map(_layout, LAYOUTS),
)
