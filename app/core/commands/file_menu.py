"""The commands of the File menu."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.enablement import (
    drawable,
    recording,
    replaceable,
    reportable,
    savable,
    session,
)

COMMANDS: Final = (
    Command("file.open", "File", "Open...", ("Ctrl+O",), icon="open"),
    Command("file.open_folder", "File", "Open folder...", ("Ctrl+Shift+O",)),
    Command("file.demo", "File", "Try the demo", icon="demo"),
    Command("file.save", "File", "Save", ("Ctrl+S",), savable, separated=True, icon="save"),
    Command("file.save_as", "File", "Save as...", ("Ctrl+Shift+S",), savable),
    Command("file.restore", "File", "Restore a backup...", (), replaceable),
    Command(
        "file.import",
        "File",
        "Import tracks...",
        ("Ctrl+Shift+I",),
        drawable,
        separated=True,
    ),
    Command("file.export", "File", "Export tracks...", ("Ctrl+E",), session, icon="export"),
    Command("file.export_report", "File", "Export a score report...", (), reportable),
    Command("file.export_counts", "File", "Export counts...", (), session),
    Command("file.export_log", "File", "Export the log of edits...", (), session),
    Command("file.compare", "File", "Compare with another session...", (), session),
    Command("file.author", "File", "Your name in the history...", (), separated=True),
    Command("file.close", "File", "Close recording", ("Ctrl+W",), recording, separated=True),
    Command("file.quit", "File", "Quit", ("Ctrl+Q",)),
)
