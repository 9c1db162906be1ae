"""What the commands of the Detector menu do on the open desk."""

from __future__ import annotations

from dataclasses import replace

from app.views.desk.recording_controller import RecordingController
from app.views.window.command_handlers.on_desk import OnDesk


def _jump(step: int) -> OnDesk:
    """From failure to failure; parts that were switched off come back, to be seen."""

    def jump(desk: RecordingController) -> None:
        if desk.parts.jump(step) and not desk.pictured.parts:
            desk.set_pictured(replace(desk.pictured, parts=True))

    return jump


DETECTING: dict[str, OnDesk] = {
    "detector.next": _jump(1),
    "detector.previous": _jump(-1),
    "detector.suggest": lambda desk: desk.labelling.suggest(),
}
