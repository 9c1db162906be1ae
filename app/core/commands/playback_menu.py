"""The commands of the Playback menu."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.enablement import live, recording

COMMANDS: Final = (
    Command("play.toggle", "Playback", "Play or pause", ("Space",), recording, icon="play"),
    Command("play.next", "Playback", "Next frame", ("Right",), recording, separated=True),
    Command("play.previous", "Playback", "Previous frame", ("Left",), recording),
    Command("play.next10", "Playback", "Ten frames on", ("Shift+Right",), recording),
    Command("play.previous10", "Playback", "Ten frames back", ("Shift+Left",), recording),
    Command("play.next_second", "Playback", "A second on", ("Ctrl+Right",), recording),
    Command("play.previous_second", "Playback", "A second back", ("Ctrl+Left",), recording),
    Command("play.start", "Playback", "To the start", ("Home",), recording),
    Command("play.end", "Playback", "To the end", ("End",), recording),
    Command("play.goto", "Playback", "Go to frame...", ("G",), recording),
    Command(
        "play.back", "Playback", "Shuttle back (again: faster)", ("J",), recording, separated=True
    ),
    Command("play.stop", "Playback", "Shuttle stop", ("K",), recording),
    Command("play.forward", "Playback", "Shuttle on (again: faster)", ("L",), recording),
    Command(
        "play.follow",
        "Playback",
        "Follow the tracker at work",
        ("Shift+L",),
        live,
        checkable=True,
        separated=True,
    ),
    Command("play.slower", "Playback", "Slower", (",",), recording),
    Command("play.faster", "Playback", "Faster", (".",), recording),
)
