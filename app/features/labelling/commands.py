"""The commands of the Labels menu."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from app.core.commands.command import Command
from app.core.commands.conditions import WindowState, editable, selected, session
from app.core.commands.view_state import view_command
from app.core.scenes.labels import Tool
from app.features.labelling.controller import LabelController


def _tool(
    tool: Tool, title: str, key: str, enabled: Callable[[WindowState], str] = editable
) -> Command[WindowState]:
    return Command(
        tool.value,
        title,
        "Labels",
        (key,),
        enabled,
        lambda app: app.of(LabelController).toggle(tool),
        checked=lambda app: app.document is not None and app.of(LabelController).tool is tool,
    )


def _say(name: str, title: str, key: str, on_part: bool | None) -> Command[WindowState]:
    return Command(
        f"labels.{name}",
        title,
        "Labels",
        (key,),
        selected,
        lambda app: app.of(LabelController).say(on_part),
        separated=on_part is True,
    )


def _choose(name: str, title: str, key: str, part: int) -> Command[WindowState]:
    return Command(
        f"labels.{name}",
        title,
        "Labels",
        (key,),
        selected,
        lambda app: app.of(LabelController).choose_part(part),
        separated=part == 0,
    )


VIEWS: Final = (view_command("labels", "Labels on the image", "View", ("U",)),)
COMMANDS: Final = (
    _tool(Tool.PARTS, "Body parts", "Alt+1"),
    _tool(Tool.OCCLUDERS, "Occluders in the image", "Alt+2"),
    _tool(Tool.LINES, "Counting lines", "Alt+3"),
    _tool(Tool.REGIONS, "Regions", "Alt+4"),
    _tool(Tool.REVIEWED, "Reviewed ranges", "Alt+5", session),
    _say("on", "The part is on: say so, go on", "4", True),
    _say("off", "The part is off: say so, go on", "5", False),
    _say("unsure", "Unsure of the part: say so, go on", "6", None),
    _choose("head", "Choose the head", "7", 0),
    _choose("torso", "Choose the torso", "8", 1),
    _choose("hip_leg", "Choose hip and legs", "9", 2),
    Command[WindowState](
        "labels.forget",
        "Delete the part's label",
        "Labels",
        ("Alt+Backspace",),
        selected,
        lambda app: app.of(LabelController).forget(),
    ),
)
