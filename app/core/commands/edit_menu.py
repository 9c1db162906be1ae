"""The commands of the Edit menu."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.enablement import editable
from app.core.i18n import tr

COMMANDS: Final = (
    Command(
        "edit.undo",
        "Edit",
        "Undo",
        ("Ctrl+Z",),
        lambda now: editable(now) or ("" if now.can_undo else tr("nothing to undo")),
        icon="undo",
    ),
    Command(
        "edit.redo",
        "Edit",
        "Redo",
        ("Ctrl+Shift+Z", "Ctrl+Y"),
        lambda now: editable(now) or ("" if now.can_redo else tr("nothing to redo")),
        icon="redo",
    ),
    Command("edit.undo_alone", "Edit", "Undo the chosen edit alone", ("Ctrl+Alt+Z",), editable),
    Command(
        "edit.commands", "Edit", "Search commands...", ("Ctrl+K",), separated=True, icon="search"
    ),
)
