"""The commands of the Tracks menu: find people, select them, name them."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command, CommandContext
from app.core.commands.enablement import selected, session, trackable
from app.core.i18n import tr


def _anybody(now: CommandContext) -> str:
    """There must be somebody to select."""
    return "" if now.tracks else tr("there are no tracks yet")


def _chosen(now: CommandContext) -> str:
    """A person must be selected, also while a tracker is at work."""
    return "" if now.selected else tr("select a person first")


def _reachable(now: CommandContext) -> str:
    """They must be in view still when the playhead is moved."""
    shown_again = tr("moving the playhead shows your own tracks again: select one of those")
    return _chosen(now) or (shown_again if now.further else "")


def _to_leave(now: CommandContext) -> str:
    """There must be a selection, an edit or a label to leave."""
    return "" if now.selected or now.editing or now.labelling else tr("nobody is selected")


COMMANDS: Final = (
    Command("tracks.track", "Tracks", "Track...", ("Ctrl+T",), trackable, icon="live"),
    Command(
        "tracks.stop",
        "Tracks",
        "Stop tracking, keep the result",
        ("Ctrl+Shift+T",),
        lambda now: "" if now.live else tr("no tracker is at work"),
    ),
    Command("tracks.runs", "Tracks", "Runs...", ("Ctrl+R",), session),
    Command("tracks.next", "Tracks", "Select next track", ("Tab",), _anybody, separated=True),
    Command("tracks.previous", "Tracks", "Select previous track", ("Shift+Tab",), _anybody),
    Command("tracks.none", "Tracks", "Select nobody, leave the edit", ("Esc",), _to_leave),
    Command(
        "tracks.to_start",
        "Tracks",
        "Go to where the track begins",
        ("Shift+Home",),
        _reachable,
        separated=True,
    ),
    Command("tracks.to_end", "Tracks", "Go to where the track ends", ("Shift+End",), _reachable),
    Command("tracks.range_start", "Tracks", "Range begins here", ("[",), session, separated=True),
    Command("tracks.range_end", "Tracks", "Range ends here", ("]",), session),
    Command("tracks.no_range", "Tracks", "No range", ("\\",), session),
    Command("tracks.rename", "Tracks", "Name the person", ("F2",), selected, separated=True),
    Command("tracks.attributes", "Tracks", "Attributes of the person", ("Shift+F2",), selected),
    Command("tracks.notes", "Tracks", "Notes on the person", ("Ctrl+F2",), selected),
)
