"""The commands of the Labels menu."""

from __future__ import annotations

from typing import Final

from app.core.commands.command import Command
from app.core.commands.enablement import editable, selected, session

COMMANDS: Final = (
    Command("labels.parts", "Labels", "Body parts", ("Alt+1",), editable, True),
    Command("labels.occluders", "Labels", "Occluders in the picture", ("Alt+2",), editable, True),
    Command("labels.lines", "Labels", "Counting lines", ("Alt+3",), editable, True),
    Command("labels.regions", "Labels", "Regions", ("Alt+4",), editable, True),
    Command("labels.reviewed", "Labels", "Reviewed ranges", ("Alt+5",), session, True),
    Command(
        "labels.on", "Labels", "The part is on: say so, go on", ("4",), selected, separated=True
    ),
    Command("labels.off", "Labels", "The part is off: say so, go on", ("5",), selected),
    Command("labels.unsure", "Labels", "Unsure of the part: say so, go on", ("6",), selected),
    Command("labels.head", "Labels", "Choose the head", ("7",), selected, separated=True),
    Command("labels.torso", "Labels", "Choose the torso", ("8",), selected),
    Command("labels.hip_leg", "Labels", "Choose hip and legs", ("9",), selected),
    Command("labels.forget", "Labels", "Take the part's label away", ("Alt+Backspace",), selected),
)
