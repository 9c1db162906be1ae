"""What the commands of the Labels menu do."""

from __future__ import annotations

from app.presenters.labelling.labelling_scene import Tool
from app.views.window.command_handlers.on_desk import OnDesk


def _toggle(tool: Tool) -> OnDesk:
    return lambda desk: desk.labelling.toggle(tool)


def _say(on_part: bool | None) -> OnDesk:
    return lambda desk: desk.labelling.say(on_part)


def _choose(part: int) -> OnDesk:
    return lambda desk: desk.labelling.choose_part(part)


LABELLING: dict[str, OnDesk] = {
    **{tool.value: _toggle(tool) for tool in Tool},
    "labels.on": _say(True),
    "labels.off": _say(False),
    "labels.unsure": _say(None),
    "labels.head": _choose(0),
    "labels.torso": _choose(1),
    "labels.hip_leg": _choose(2),
    "labels.forget": lambda desk: desk.labelling.forget(),
}
