"""Commands: declared values that menus, keys, palette and the cheat sheet are made from."""

from app.core.commands.command import Command
from app.core.commands.registry import MENUS, CommandRegistry, menu_of

__all__ = ["MENUS", "Command", "CommandRegistry", "menu_of"]
