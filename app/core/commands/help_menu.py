"""The commands of the Help menu."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command

COMMANDS: Final = (
    Command("help.keys", "Help", "All shortcuts", ("F1",)),
    Command("help.about", "Help", "About trackwright"),
)
