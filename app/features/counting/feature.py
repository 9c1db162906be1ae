"""Counting as a feature of the window."""

from __future__ import annotations

from typing import Final

from app.core.feature import Feature
from app.features.counting.commands import COMMANDS
from app.features.counting.controller import CountController
from app.features.counting.panel import CountingPanel

FEATURE: Final = Feature("counting", CountController, CountingPanel, commands=COMMANDS)
