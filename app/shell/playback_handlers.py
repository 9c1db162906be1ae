"""What the commands of the Playback menu do."""

from __future__ import annotations

from app.shell.recording_controller import RecordingController
from app.shell.recording_handler import RecordingHandler


def _step(frames: int) -> RecordingHandler:
    """A frame or ten: moves a box or the cut of an edit that waits, else the playhead."""

    def step(controller: RecordingController) -> None:
        flow = controller.document.flow
        if flow is not None and flow.places:
            controller.editing.nudge(1 if frames > 0 else -1, 0, far=abs(frames) > 1)
        elif flow is not None and flow.has_cut and not flow.needs_other:
            controller.editing.move_cut(frames)
        else:
            controller.playback.step(frames)

    return step


def _second(direction: int) -> RecordingHandler:
    """A second; of a box that waits the width, of an edit over a range its end by a frame."""

    def step(controller: RecordingController) -> None:
        flow = controller.document.flow
        if flow is not None and flow.places:
            controller.editing.nudge(direction, 0, resize=True)
        elif flow is not None and flow.has_end:
            controller.editing.move_end(direction)
        else:
            controller.playback.step(direction * max(1, round(controller.playback.clock.fps)))

    return step


PLAYING: dict[str, RecordingHandler] = {
    "play.toggle": RecordingController.toggle,
    "play.next": _step(1),
    "play.previous": _step(-1),
    "play.next10": _step(10),
    "play.previous10": _step(-10),
    "play.next_second": _second(1),
    "play.previous_second": _second(-1),
    "play.start": lambda controller: controller.playback.go(0),
    "play.end": lambda controller: controller.playback.go(controller.playback.clock.last_frame),
    "play.back": lambda controller: controller.shuttle(-1),
    "play.stop": lambda controller: controller.shuttle(0),
    "play.forward": lambda controller: controller.shuttle(1),
    "play.follow": lambda controller: controller.tracking.following.toggle(),
    "play.slower": lambda controller: controller.playback.change_speed(-1),
    "play.faster": lambda controller: controller.playback.change_speed(1),
}
