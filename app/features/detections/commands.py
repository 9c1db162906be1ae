"""The command that shows detections of another program."""

from __future__ import annotations

from typing import Final

from app.core.commands.view_state import view_command

COMMANDS: Final = (
    view_command(
        "detections", "Detections of another program on the image", "View/What the tracker sees"
    ),
)
