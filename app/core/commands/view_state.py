"""Commands that switch something of the views on and off."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any, Protocol

from app.core.commands.command import Command
from app.core.commands.conditions import WindowState, recording
from app.core.tracks.frame_state import ViewOptions


class ViewState(WindowState, Protocol):
    """What commands that switch views depend on."""

    view_options: ViewOptions
    """What is laid over the pictures, and plotted; setting it draws anew."""

    def say(self, text: str) -> None:
        """A passing word for the user."""


def toggle(now: ViewState, name: str) -> bool:
    """Switch one of the view options; whether it is on by now."""
    on = not getattr(now.view_options, name)
    switched: dict[str, Any] = {name: on}
    now.view_options = replace(now.view_options, **switched)
    return on


def view_command(
    name: str,
    title: str,
    menu: str,
    keys: tuple[str, ...] = (),
    enabled: Callable[[WindowState], str] = recording,
    run: Callable[[Any], object] | None = None,
    **more: Any,
) -> Command[Any]:
    """A command "view.NAME" that switches the view option of that name.

    Args:
        name: of the field of `ViewOptions`. title, menu, keys, enabled: see `Command`.
        run: does it in another way than by switching that alone.
        more: further fields of the command.
    """
    return Command(
        f"view.{name}",
        title,
        menu,
        keys,
        enabled,
        run or (lambda now: toggle(now, name)),
        checked=lambda now: now.document is not None and getattr(now.view_options, name),
        **more,
    )


def _toggle_panel(now: ViewState, name: str) -> None:
    now.view_options = replace(now.view_options, panels=now.view_options.panels ^ {name})


def panel_command(
    name: str,
    title: str,
    menu: str,
    keys: tuple[str, ...] = (),
    run: Callable[[Any], object] | None = None,
    **more: Any,
) -> Command[Any]:
    """A command "view.NAME" that opens and closes the panel of that id; see `view_command`."""
    return Command(
        f"view.{name}",
        title,
        menu,
        keys,
        recording,
        run or (lambda now: _toggle_panel(now, name)),
        checked=lambda now: now.document is not None and name in now.view_options.panels,
        **more,
    )
