"""Detections of another program as a feature of the window."""

from __future__ import annotations

from typing import Final

from app.core.feature import Feature
from app.features.detections.commands import COMMANDS
from app.features.detections.controller import DetectionsController

FEATURE: Final = Feature("detections", DetectionsController, commands=COMMANDS)
