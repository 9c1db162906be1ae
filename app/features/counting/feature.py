"""Counting as a feature of the window: its commands, panel and controller."""

from __future__ import annotations

from typing import Final

from app.core.commands.conditions import floor
from app.core.commands.view_state import panel_command, view_command
from app.core.feature import Feature
from app.features.counting.controller import CountController
from app.features.counting.panel import CountingPanel

_COMMANDS: Final = (
    view_command("counts", "Counts at lines and regions", "View/Counting", ("Shift+U",)),
    panel_command(
        "counting", "Counting over time", "View/Counting", ("Shift+C",), also="graph plot curves"
    ),
    view_command("flow_map", "Flow map on the floor", "View/Counting", ("Shift+F",), floor),
)
FEATURE: Final = Feature("counting", CountController, CountingPanel, commands=_COMMANDS)
