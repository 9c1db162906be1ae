"""The catalogue of commands: menus, keys, palette and the list of shortcuts share it."""

from __future__ import annotations

from typing import Final

from app.core.commands import (
    correct_menu,
    detector_menu,
    edit_menu,
    file_menu,
    help_menu,
    labels_menu,
    playback_menu,
    review_menu,
    tracks_menu,
    view_menu,
)
from app.core.commands.command import Command, CommandContext
from app.core.i18n import tr
from app.core.scenes import CommandItem

__all__ = ["COMMANDS", "MENUS", "Command", "CommandContext", "command_items"]

MENUS: Final = (
    "File",
    "Edit",
    "View",
    "Playback",
    "Tracks",
    "Correct",
    "Labels",
    "Review",
    "Detector",
    "Help",
)
COMMANDS: Final[tuple[Command, ...]] = (
    *file_menu.COMMANDS,
    *edit_menu.COMMANDS,
    *view_menu.COMMANDS,
    *playback_menu.COMMANDS,
    *tracks_menu.COMMANDS,
    *correct_menu.COMMANDS,
    *labels_menu.COMMANDS,
    *review_menu.COMMANDS,
    *detector_menu.COMMANDS,
    *help_menu.COMMANDS,
)


def command_items(now: CommandContext, checked: frozenset[str]) -> tuple[CommandItem, ...]:
    """All commands as the views show them now; `checked` holds those that are on."""
    return tuple(_item(command, now, checked) for command in COMMANDS)


def _item(command: Command, now: CommandContext, checked: frozenset[str]) -> CommandItem:
    why_not, in_brackets = command.check(now), command.now(now)
    one_camera = now.recording and not now.stereo
    title = tr(command.alone if one_camera and command.alone else command.title)
    return CommandItem(
        command=command.name,
        menu=_standing(command),
        title=f"{title} ({in_brackets})" if in_brackets else title,
        keys=command.keys,
        enabled=not why_not,
        why_not=why_not,
        checked=command.name in checked if command.checkable else None,
        also=tr(command.also) if command.also else "",
    )


def _standing(command: Command) -> str:
    """The menu it stands in, e.g. "Correct", "Correct > Delete"."""
    menu = tr(command.menu)
    return f"{menu} \u203a {tr(command.submenu)}" if command.submenu else menu
