"""What the commands that select and correct tracks do."""

from __future__ import annotations

from app.core.editing import EditKind, EditScope
from app.core.scenes.labels import Tool
from app.shell.recording_controller import RecordingController
from app.shell.recording_handler import RecordingHandler


def _to_track(end: bool) -> RecordingHandler:
    def go(controller: RecordingController) -> None:
        card = controller.document.card()
        if card is not None:
            controller.playback.go(card.last_frame if end else card.first_frame)

    return go


def _begin(kind: EditKind, scope: EditScope | None = None) -> RecordingHandler:
    return lambda controller: controller.editing.begin(kind, scope)


def _vertical(down: int, *, far: bool = False, resize: bool = False) -> RecordingHandler:
    """Up or down: moves or resizes a box that waits, else goes on to the next proposal."""

    def go(controller: RecordingController) -> None:
        flow = controller.document.flow
        if flow is not None and flow.places:
            controller.editing.nudge(0, down, far=far, resize=resize)
        else:
            controller.editing.next_proposal(down)

    return go


def _next_scope(controller: RecordingController) -> None:
    """R: how far the edit that waits goes, else an answer about a body part."""
    if controller.document.flow is None and controller.labelling.tool is Tool.PARTS:
        controller.labelling.next_scope()
    else:
        controller.editing.next_choice(0)


CORRECTING: dict[str, RecordingHandler] = {
    "edit.undo": lambda controller: controller.editing.undo(),
    "edit.redo": lambda controller: controller.editing.redo(),
    "edit.undo_alone": lambda controller: controller.walk.undo_alone(),
    "tracks.stop": lambda controller: controller.live.stop(),
    "tracks.next": lambda controller: controller.editing.pick_next(1),
    "tracks.previous": lambda controller: controller.editing.pick_next(-1),
    "tracks.none": lambda controller: controller.leave(),
    "tracks.to_start": _to_track(end=False),
    "tracks.to_end": _to_track(end=True),
    "tracks.swap": _begin(EditKind.SWAP),
    "tracks.split": _begin(EditKind.SPLIT),
    "tracks.merge": _begin(EditKind.MERGE),
    "tracks.reassign": _begin(EditKind.REASSIGN),
    "tracks.end_here": _begin(EditKind.DELETE, EditScope.ON),
    "tracks.delete_frame": _begin(EditKind.DELETE, EditScope.FRAME),
    "tracks.delete_range": _begin(EditKind.DELETE, EditScope.RANGE),
    "tracks.delete_track": _begin(EditKind.DELETE, EditScope.WHOLE),
    "tracks.draw": lambda controller: controller.editing.begin_drawing(),
    "tracks.new": lambda controller: controller.editing.begin_drawing(new=True),
    "tracks.move_box": _begin(EditKind.MOVE),
    "tracks.move_floor": _begin(EditKind.FLOOR),
    "tracks.keyframe": _begin(EditKind.KEYFRAME),
    "tracks.no_keyframe": _begin(EditKind.NO_KEYFRAME),
    "tracks.interpolate": _begin(EditKind.INTERPOLATE),
    "tracks.fill_gap": _begin(EditKind.FILL),
    "tracks.fill_gaps": _begin(EditKind.FILL_ALL),
    "tracks.thin": _begin(EditKind.THIN),
    "tracks.occluded": _begin(EditKind.OCCLUDE),
    "tracks.visible": _begin(EditKind.SHOW),
    "tracks.reviewed": _begin(EditKind.REVIEW),
    "tracks.range_start": lambda controller: controller.editing.mark(end=False),
    "tracks.range_end": lambda controller: controller.editing.mark(end=True),
    "tracks.no_range": lambda controller: controller.editing.unmark(),
    "tracks.confirm": lambda controller: controller.editing.confirm(),
    "tracks.scope": _next_scope,
    "tracks.way": lambda controller: controller.editing.next_choice(1),
    "tracks.down": _vertical(1),
    "tracks.up": _vertical(-1),
    "tracks.far_down": _vertical(1, far=True),
    "tracks.far_up": _vertical(-1, far=True),
    "tracks.taller": _vertical(1, resize=True),
    "tracks.shorter": _vertical(-1, resize=True),
}
