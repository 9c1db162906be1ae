"""What the commands of the Detector menu do to the open recording."""

from __future__ import annotations

from dataclasses import replace

from app.shell.recording_controller import RecordingController
from app.shell.recording_handler import RecordingHandler


def _jump(step: int) -> RecordingHandler:
    """From failure to failure; parts that were switched off come back, to be seen."""

    def jump(controller: RecordingController) -> None:
        if controller.parts.jump(step) and not controller.view_options.parts:
            controller.set_view_options(replace(controller.view_options, parts=True))

    return jump


DETECTING: dict[str, RecordingHandler] = {
    "detector.next": _jump(1),
    "detector.previous": _jump(-1),
    "detector.suggest": lambda controller: controller.labelling.suggest(),
}
