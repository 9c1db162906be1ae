"""The commands that select, correct and name people."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import partial
from typing import Final, Protocol

from app.core.commands.command import Command
from app.core.commands.conditions import (
    WindowState,
    drawable,
    editable,
    on_floor,
    pending,
    placing,
    selected,
    session,
    somebody,
)
from app.core.editing.edit_options import EditScope
from app.core.editing.edit_spec import EditSpec
from app.core.editing.edits import EDITS
from app.core.i18n import tr
from app.features.correction.controller import EditController
from app.features.correction.track_panel import TrackPanel


class CorrectionApp(WindowState, Protocol):
    """What they need of the window."""

    @property
    def card(self) -> TrackPanel:
        """The card of the selected track."""


def _undoable(app: CorrectionApp) -> str:
    """There must be an edit to undo."""
    session = app.document.session if app.document is not None else None
    if editable(app) or (session is not None and session.history.next_undo is not None):
        return editable(app)
    return tr("nothing to undo")


def _redoable(app: CorrectionApp) -> str:
    """There must be an edit to redo."""
    session = app.document.session if app.document is not None else None
    if editable(app) or (session is not None and session.history.next_redo is not None):
        return editable(app)
    return tr("nothing to redo")


def _anybody(app: CorrectionApp) -> str:
    """There must be somebody to select."""
    there = app.document is not None and app.document.tracks.ids
    return "" if there else tr("there are no tracks yet")


def _in_view(app: CorrectionApp) -> str:
    """They must be in view still when the playhead is moved."""
    if app.document is None or not app.document.shows_further_run:
        return somebody(app)
    return somebody(app) or tr("move the playhead to show your own tracks, then select one of them")


def _vertical(app: CorrectionApp, down: int, *, far: bool = False, resize: bool = False) -> None:
    """Up or down: moves or resizes a box that waits, else goes on to the next proposal."""
    flow = app.document.flow if app.document is not None else None
    if flow is not None and flow.places:
        app.of(EditController).nudge(0, down, far=far, resize=resize)
    else:
        app.of(EditController).next_proposal(down)


def _begin(app: CorrectionApp, spec: EditSpec, scope: EditScope | None) -> None:
    app.of(EditController).begin(spec, scope)


def _of_edits(specs: Iterable[EditSpec]) -> Iterator[Command[CorrectionApp]]:
    """The commands that begin edits."""
    for spec in specs:
        for one in spec.commands:
            yield Command[CorrectionApp](
                one.id,
                one.title,
                f"Correct/{one.submenu}" if one.submenu else "Correct",
                one.keys,
                on_floor if one.floor else selected,
                partial(_begin, spec=spec, scope=one.scope),
                icon=one.icon,
                separated=one.separated,
                also=one.also,
            )


def _edits() -> Iterator[Command[CorrectionApp]]:
    """Those of all kinds; a box is drawn by commands of its own, as nobody need be selected."""
    for command in _of_edits(EDITS):
        if command.id == "tracks.move_box":
            yield from _DRAWING
        yield command


_BOX, _PENDING = "Correct/Draw and move", "Correct/Change the edit shown"
_DRAWING: Final[tuple[Command[CorrectionApp], ...]] = (
    Command(
        "tracks.draw",
        "Draw or move a box",
        _BOX,
        ("W",),
        drawable,
        lambda app: app.of(EditController).begin_drawing(),
        icon="box",
    ),
    Command(
        "tracks.new",
        "Draw a new person",
        _BOX,
        ("Ins",),
        drawable,
        lambda app: app.of(EditController).begin_drawing(new=True),
        icon="add",
    ),
)
HISTORY: Final[tuple[Command[CorrectionApp], ...]] = (
    Command(
        "edit.undo",
        "Undo",
        "Edit",
        ("Ctrl+Z",),
        _undoable,
        lambda app: app.of(EditController).undo(),
        icon="undo",
    ),
    Command(
        "edit.redo",
        "Redo",
        "Edit",
        ("Ctrl+Shift+Z", "Ctrl+Y"),
        _redoable,
        lambda app: app.of(EditController).redo(),
        icon="redo",
    ),
)
NEXT: Final[tuple[Command[CorrectionApp], ...]] = (
    Command(
        "tracks.next",
        "Select next track",
        "Tracks",
        ("Tab",),
        _anybody,
        lambda app: app.of(EditController).pick_next(1),
        separated=True,
    ),
    Command(
        "tracks.previous",
        "Select previous track",
        "Tracks",
        ("Shift+Tab",),
        _anybody,
        lambda app: app.of(EditController).pick_next(-1),
    ),
)
SELECTED: Final[tuple[Command[CorrectionApp], ...]] = (
    Command(
        "tracks.to_start",
        "Go to where the track begins",
        "Tracks",
        ("Shift+Home",),
        _in_view,
        lambda app: app.of(EditController).go_to_end_of_track(end=False),
        separated=True,
    ),
    Command(
        "tracks.to_end",
        "Go to where the track ends",
        "Tracks",
        ("Shift+End",),
        _in_view,
        lambda app: app.of(EditController).go_to_end_of_track(end=True),
    ),
    Command(
        "tracks.range_start",
        "Start the range here",
        "Tracks",
        ("[",),
        session,
        lambda app: app.of(EditController).mark(end=False),
        separated=True,
    ),
    Command(
        "tracks.range_end",
        "End the range here",
        "Tracks",
        ("]",),
        session,
        lambda app: app.of(EditController).mark(end=True),
    ),
    Command(
        "tracks.no_range",
        "Clear the range",
        "Tracks",
        ("\\",),
        session,
        lambda app: app.of(EditController).unmark(),
    ),
    Command(
        "tracks.rename",
        "Name the person",
        "Tracks",
        ("F2",),
        selected,
        lambda app: app.card.edit_name(),
        separated=True,
    ),
    Command(
        "tracks.attributes",
        "Attributes of the person",
        "Tracks",
        ("Shift+F2",),
        selected,
        lambda app: app.card.edit_attributes(),
    ),
    Command(
        "tracks.notes",
        "Notes on the person",
        "Tracks",
        ("Ctrl+F2",),
        selected,
        lambda app: app.card.edit_notes(),
    ),
)
CONFIRM: Final[tuple[Command[CorrectionApp], ...]] = (
    Command(
        "tracks.confirm",
        "Apply the edit shown",
        "Correct",
        ("Return", "Enter"),
        pending,
        lambda app: app.of(EditController).confirm(),
        separated=True,
    ),
)
CHANGE: Final[tuple[Command[CorrectionApp], ...]] = (
    Command(
        "tracks.way",
        "How the edit is done",
        _PENDING,
        ("C",),
        pending,
        lambda app: app.of(EditController).next_choice(1),
    ),
    Command(
        "tracks.down",
        "Next proposal, or box down",
        _PENDING,
        ("Down",),
        pending,
        lambda app: _vertical(app, 1),
        separated=True,
    ),
    Command(
        "tracks.up",
        "Previous proposal, or box up",
        _PENDING,
        ("Up",),
        pending,
        lambda app: _vertical(app, -1),
    ),
    Command(
        "tracks.far_down",
        "Box far down",
        _PENDING,
        ("Shift+Down",),
        placing,
        lambda app: _vertical(app, 1, far=True),
    ),
    Command(
        "tracks.far_up",
        "Box far up",
        _PENDING,
        ("Shift+Up",),
        placing,
        lambda app: _vertical(app, -1, far=True),
    ),
    Command(
        "tracks.taller",
        "Box taller",
        _PENDING,
        ("Ctrl+Down",),
        placing,
        lambda app: _vertical(app, 1, resize=True),
    ),
    Command(
        "tracks.shorter",
        "Box shorter",
        _PENDING,
        ("Ctrl+Up",),
        placing,
        lambda app: _vertical(app, -1, resize=True),
    ),
)
CORRECT: Final = tuple(_edits())
