"""What the commands that select and correct tracks do."""

from __future__ import annotations

from app.presenters.correcting import EditKind, EditScope
from app.presenters.labelling.labelling_scene import Tool
from app.views.desk.recording_controller import RecordingController
from app.views.window.command_handlers.on_desk import OnDesk


def _to_track(end: bool) -> OnDesk:
    def go(desk: RecordingController) -> None:
        card = desk.document.card()
        if card is not None:
            desk.playback.go(card.last_frame if end else card.first_frame)

    return go


def _begin(kind: EditKind, scope: EditScope | None = None) -> OnDesk:
    return lambda desk: desk.editing.begin(kind, scope)


def _vertical(down: int, *, far: bool = False, resize: bool = False) -> OnDesk:
    """Up or down: moves or resizes a box that waits, else goes on to the next proposal."""

    def go(desk: RecordingController) -> None:
        flow = desk.document.flow
        if flow is not None and flow.places:
            desk.editing.nudge(0, down, far=far, resize=resize)
        else:
            desk.editing.next_proposal(down)

    return go


def _next_scope(desk: RecordingController) -> None:
    """R: how far the edit that waits goes, else an answer about a body part."""
    if desk.document.flow is None and desk.labelling.tool is Tool.PARTS:
        desk.labelling.next_scope()
    else:
        desk.editing.next_choice(0)


CORRECTING: dict[str, OnDesk] = {
    "edit.undo": lambda desk: desk.editing.undo(),
    "edit.redo": lambda desk: desk.editing.redo(),
    "edit.undo_alone": lambda desk: desk.walk.undo_alone(),
    "tracks.stop": lambda desk: desk.live.stop(),
    "tracks.next": lambda desk: desk.editing.pick_next(1),
    "tracks.previous": lambda desk: desk.editing.pick_next(-1),
    "tracks.none": lambda desk: desk.leave(),
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
    "tracks.draw": lambda desk: desk.editing.begin_drawing(),
    "tracks.new": lambda desk: desk.editing.begin_drawing(new=True),
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
    "tracks.range_start": lambda desk: desk.editing.mark(end=False),
    "tracks.range_end": lambda desk: desk.editing.mark(end=True),
    "tracks.no_range": lambda desk: desk.editing.unmark(),
    "tracks.confirm": lambda desk: desk.editing.confirm(),
    "tracks.scope": _next_scope,
    "tracks.way": lambda desk: desk.editing.next_choice(1),
    "tracks.down": _vertical(1),
    "tracks.up": _vertical(-1),
    "tracks.far_down": _vertical(1, far=True),
    "tracks.far_up": _vertical(-1, far=True),
    "tracks.taller": _vertical(1, resize=True),
    "tracks.shorter": _vertical(-1, resize=True),
}
