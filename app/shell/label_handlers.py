"""What the commands of the Labels menu do."""

from __future__ import annotations

from app.core.scenes.labels import Tool
from app.shell.recording_handler import RecordingHandler


def _toggle(tool: Tool) -> RecordingHandler:
    return lambda controller: controller.labelling.toggle(tool)


def _say(on_part: bool | None) -> RecordingHandler:
    return lambda controller: controller.labelling.say(on_part)


def _choose(part: int) -> RecordingHandler:
    return lambda controller: controller.labelling.choose_part(part)


LABELLING: dict[str, RecordingHandler] = {
    **{tool.value: _toggle(tool) for tool in Tool},
    "labels.on": _say(True),
    "labels.off": _say(False),
    "labels.unsure": _say(None),
    "labels.head": _choose(0),
    "labels.torso": _choose(1),
    "labels.hip_leg": _choose(2),
    "labels.forget": lambda controller: controller.labelling.forget(),
}
