"""All commands of a window: menus, keys, palette and the cheat sheet are made from here."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, Generic, TypeVar

from app.core import keymap
from app.core.commands.command import Command
from app.core.commands.conditions import WindowState
from app.core.i18n import tr
from app.core.scenes import CommandItem

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

AppT = TypeVar("AppT", bound=WindowState)


class CommandRegistry(Generic[AppT]):
    """The commands of one application.

    Attributes:
        commands: in the order of the menus.
    """

    def __init__(self, commands: Iterable[Command[AppT]], app: AppT) -> None:
        self.commands = tuple(sorted(commands, key=lambda one: MENUS.index(menu_of(one)[0])))
        keymap.declare(self.commands)
        self._app = app
        self._by_id = {command.id: command for command in self.commands}

    def items(self) -> tuple[CommandItem, ...]:
        """All commands as the views show them now."""
        return tuple(self._item(command) for command in self.commands)

    def item(self, command_id: str) -> CommandItem:
        """One of them. Raises KeyError where there is none of this id."""
        return self._item(self._by_id[command_id])

    def run(self, command_id: str) -> None:
        """Do a command, which must be enabled."""
        self._by_id[command_id].run(self._app)

    def _item(self, command: Command[AppT]) -> CommandItem:
        app, document = self._app, self._app.document
        why_not, note = command.enabled(app), command.note(app)
        one_camera = document is not None and not document.recording.is_stereo
        english = (one_camera and command.title_one_camera) or command.title
        title = tr(english)
        menu, submenu = menu_of(command)
        return CommandItem(
            command=command.id,
            menu=f"{tr(menu)} \u203a {tr(submenu)}" if submenu else tr(menu),
            title=f"{title} ({note})" if note else title,
            keys=keymap.keys_of(command.id),
            enabled=not why_not,
            why_not=why_not,
            checked=command.checked(app) if command.checked is not None else None,
            also=tr(command.also) if command.also else "",
            english=english,
        )


def menu_of(command: Command[AppT]) -> tuple[str, str]:
    """The menu and the submenu a command stands in; "" for the menu itself."""
    menu, _, submenu = command.menu.partition("/")
    return menu, submenu
