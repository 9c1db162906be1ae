"""Detections of another program as a feature of the window, and the command that shows them."""

from __future__ import annotations

from typing import Final

from app.core.commands.view_state import view_command
from app.core.feature import Feature
from app.features.detections.controller import DetectionsController

_COMMANDS: Final = (
    view_command(
        "detections", "Detections of another program on the image", "View/What the tracker sees"
    ),
)
FEATURE: Final = Feature("detections", DetectionsController, commands=_COMMANDS)
