"""What the commands of the Playback menu do."""

from __future__ import annotations

from app.views.desk.recording_controller import RecordingController
from app.views.window.command_handlers.on_desk import OnDesk


def _step(frames: int) -> OnDesk:
    """A frame or ten: moves a box or the cut of an edit that waits, else the playhead."""

    def step(desk: RecordingController) -> None:
        flow = desk.document.flow
        if flow is not None and flow.places:
            desk.editing.nudge(1 if frames > 0 else -1, 0, far=abs(frames) > 1)
        elif flow is not None and flow.has_cut and not flow.needs_other:
            desk.editing.move_cut(frames)
        else:
            desk.playback.step(frames)

    return step


def _second(direction: int) -> OnDesk:
    """A second; of a box that waits the width, of an edit over a range its end by a frame."""

    def step(desk: RecordingController) -> None:
        flow = desk.document.flow
        if flow is not None and flow.places:
            desk.editing.nudge(direction, 0, resize=True)
        elif flow is not None and flow.has_end:
            desk.editing.move_end(direction)
        else:
            desk.playback.step(direction * max(1, round(desk.playback.clock.fps)))

    return step


PLAYING: dict[str, OnDesk] = {
    "play.toggle": RecordingController.toggle,
    "play.next": _step(1),
    "play.previous": _step(-1),
    "play.next10": _step(10),
    "play.previous10": _step(-10),
    "play.next_second": _second(1),
    "play.previous_second": _second(-1),
    "play.start": lambda desk: desk.playback.go(0),
    "play.end": lambda desk: desk.playback.go(desk.playback.clock.last_frame),
    "play.back": lambda desk: desk.shuttle(-1),
    "play.stop": lambda desk: desk.shuttle(0),
    "play.forward": lambda desk: desk.shuttle(1),
    "play.follow": lambda desk: desk.tracking.following.toggle(),
    "play.slower": lambda desk: desk.playback.change_speed(-1),
    "play.faster": lambda desk: desk.playback.change_speed(1),
}
