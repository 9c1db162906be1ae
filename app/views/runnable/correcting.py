"""What the commands that select and correct tracks do."""

from __future__ import annotations

from app.presenters.edit_flow import EditKind
from app.views.desk import Desk
from app.views.runnable.on_desk import OnDesk


def _to_track(end: bool) -> OnDesk:
    def go(desk: Desk) -> None:
        card = desk.document.card()
        if card is not None:
            desk.playback.go(card.last_frame if end else card.first_frame)

    return go


CORRECTING: dict[str, OnDesk] = {
    "edit.undo": lambda desk: desk.editing.undo(),
    "edit.redo": lambda desk: desk.editing.redo(),
    "tracks.stop": lambda desk: desk.live.stop(),
    "tracks.next": lambda desk: desk.editing.pick_next(1),
    "tracks.previous": lambda desk: desk.editing.pick_next(-1),
    "tracks.none": lambda desk: desk.leave(),
    "tracks.to_start": _to_track(end=False),
    "tracks.to_end": _to_track(end=True),
    "tracks.swap": lambda desk: desk.editing.begin(EditKind.SWAP),
    "tracks.split": lambda desk: desk.editing.begin(EditKind.SPLIT),
    "tracks.merge": lambda desk: desk.editing.begin(EditKind.MERGE),
    "tracks.end_here": lambda desk: desk.editing.begin(EditKind.DELETE),
    "tracks.confirm": lambda desk: desk.editing.confirm(),
    "tracks.scope": lambda desk: desk.editing.next_choice(),
}
