"""The commands of the Tracks menu."""

from __future__ import annotations

from typing import Final

from app.presenters.commands.checks import selected, trackable
from app.presenters.commands.command import Command
from app.presenters.words import tr

COMMANDS: Final = (
    Command("tracks.track", "Tracks", "Track...", ("Ctrl+T",), trackable, icon="live"),
    Command(
        "tracks.stop",
        "Tracks",
        "Stop tracking, keep the result",
        ("Ctrl+Shift+T",),
        lambda now: "" if now.live else tr("no tracker is at work"),
    ),
    Command(
        "tracks.next",
        "Tracks",
        "Select next track",
        ("Tab",),
        lambda now: "" if now.tracks else tr("there are no tracks yet"),
        separated=True,
    ),
    Command(
        "tracks.previous",
        "Tracks",
        "Select previous track",
        ("Shift+Tab",),
        lambda now: "" if now.tracks else tr("there are no tracks yet"),
    ),
    Command(
        "tracks.none",
        "Tracks",
        "Select nobody, leave the edit",
        ("Esc",),
        lambda now: "" if now.selected or now.editing or now.labelling else tr("nobody is selected"),
    ),
    Command(
        "tracks.to_start",
        "Tracks",
        "Go to where the track begins",
        ("Shift+Home",),
        lambda now: "" if now.selected else tr("select a person first"),
    ),
    Command(
        "tracks.to_end",
        "Tracks",
        "Go to where the track ends",
        ("Shift+End",),
        lambda now: "" if now.selected else tr("select a person first"),
    ),
    Command("tracks.swap", "Tracks", "Swap with...", ("X",), selected, separated=True, icon="swap"),
    Command("tracks.split", "Tracks", "Split here", ("S",), selected, icon="split"),
    Command("tracks.merge", "Tracks", "Merge with...", ("M",), selected, icon="merge"),
    Command("tracks.end_here", "Tracks", "Delete from here on", ("Del",), selected, icon="delete"),
    Command(
        "tracks.confirm",
        "Tracks",
        "Do the edit shown",
        ("Return", "Enter"),
        lambda now: "" if now.editing else tr("no edit is waiting"),
    ),
    Command(
        "tracks.scope",
        "Tracks",
        "Next choice of the edit shown",
        ("R",),
        lambda now: "" if now.editing else tr("no edit is waiting"),
    ),
    Command("tracks.rename", "Tracks", "Name the person", ("F2",), selected, separated=True),
)
