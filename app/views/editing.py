"""Correcting in the open recording: from the first key to Enter, undo and redo, labels."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from app.presenters.document import Document
from app.presenters.edit_flow import EditFlow, EditKind
from app.presenters.words import tr
from app.views.playback import Playback
from tracking.editing import (
    Change,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
)
from tracking.errors import TrackwrightError


class Editing(QObject):
    """Turns gestures into edits of a document.

    Signals: `changed()`, the tracks, the labels or the waiting edit are others than before;
    `failed(error)`, an edit does not apply; `said(text)`, what was done.
    """

    changed = Signal()
    failed = Signal(object)
    said = Signal(str)

    def __init__(self, document: Document, playback: Playback, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._playback = playback

    # an edit on its way

    def begin(self, kind: EditKind) -> None:
        """X, S, M or Del: begin an edit of the selected track at the playhead."""
        self._playback.pause()
        self._document.begin_edit(kind, self._playback.clock.frame)
        self.changed.emit()

    def pick(self, track: int) -> None:
        """A person was clicked in some view."""
        self._picked(lambda: self._document.pick(track))

    def pick_next(self, step: int) -> None:
        """Tab or Shift+Tab."""
        self._picked(lambda: self._document.pick_next(self._playback.number, step))

    def pick_typed(self, track: int) -> None:
        """The other person's id was typed."""
        self._picked(lambda: self._document.pick_typed(track))

    def _picked(self, pick: Callable[[], None]) -> None:
        before = self._document.flow
        pick()
        flow = self._document.flow
        if flow is not None and flow is not before and flow.has_cut:
            self._playback.go(flow.cut)
        self.changed.emit()

    def move_cut(self, frames: int) -> None:
        """Left / Right: move the cut, and the playhead with it."""
        self._put(lambda flow: flow.moved(frames, self._document.recording.frame_count))

    def put_cut(self, frame: int) -> None:
        """Put the cut at a frame."""
        flow = self._document.flow
        if flow is not None:
            self.move_cut(frame - flow.cut)

    def move_end(self, frames: int) -> None:
        """Ctrl+Left / Right: move the end of the range."""
        count = self._document.recording.frame_count
        self._put(lambda flow: flow.with_end_moved(frames, count))

    def next_choice(self) -> None:
        """R: from here on, this range, this frame, and around again; of a merge whom to keep."""
        self._put(lambda flow: flow.with_choice(flow.choice + 1))

    def choose(self, number: int) -> None:
        """One of the edit's choices was clicked."""
        self._put(lambda flow: flow.with_choice(number))

    def _put(self, step: Callable[[EditFlow], EditFlow]) -> None:
        flow = self._document.flow
        if flow is None:
            return
        self._document.change_edit(step(flow))
        if self._document.flow is not None and flow.has_cut:
            self._playback.go(self._document.flow.cut)
        self.changed.emit()

    def confirm(self) -> None:
        """Enter: do the edit."""
        self._do(self._document.confirm_edit, tr("Done: {text}"))

    def leave(self) -> None:
        """Esc: leave the edit, or let the selected person go."""
        if self._document.flow is not None:
            self._document.leave_edit()
        else:
            self._document.selection.choose(0)
        self.changed.emit()

    # history

    def undo(self) -> bool:
        """Take the last edit back and go where it was; whether that was done."""
        self._document.leave_edit()
        return self._do(self._document.undo, tr("Undone: {text}"))

    def redo(self) -> bool:
        """Do the edit again that was taken back and go where it was; whether that was done."""
        self._document.leave_edit()
        return self._do(self._document.redo, tr("Done again: {text}"))

    def go_to_edit(self, edit: int) -> None:
        """Undo or redo until this edit is the last one in force."""
        session = self._document.session
        if session is None:
            return
        undone = {entry.id: entry.undone for entry in session.history}.get(edit, False)
        while undone and (entry := session.history.next_redo) and entry.id <= edit:
            if not self.redo():
                return
        while not undone and (entry := session.history.next_undo) and entry.id > edit:
            if not self.undo():
                return

    # labels

    def rename(self, track: int, name: str) -> None:
        """Name a track."""
        self._label(lambda table, labels: plan_rename(table, labels, track, name))

    def write_notes(self, track: int, notes: str) -> None:
        """Write a track's notes."""
        self._label(lambda table, labels: plan_set_notes(table, labels, track, notes))

    def set_attributes(self, track: int, pairs: tuple[tuple[str, str], ...]) -> None:
        """Set a track's own fields to these, one edit a field that differs."""
        before, after = dict(self._document.label(track).attributes), dict(pairs)
        for key in sorted(before.keys() | after.keys()):
            value = after.get(key)
            if key and before.get(key) != value:
                self._label(
                    lambda table, labels, key=key, value=value: plan_set_attribute(
                        table, labels, track, key, value
                    )
                )

    def _label(self, plan: Callable[..., Change]) -> None:
        session = self._document.session
        if session is None:
            return

        def apply() -> Change:
            change = plan(session.tracks, session.labels)
            self._document.apply(change)
            return change

        self._do(apply, tr("Done: {text}"), go=False)

    def _do(self, step: Callable[[], Change | None], said: str, go: bool = True) -> bool:
        """Do something to the document; say it, go to its frame, or tell why not.

        Gives whether something was done.
        """
        try:
            change = step()
        except TrackwrightError as error:
            self.changed.emit()
            self.failed.emit(error)
            return False
        if change is not None:
            if go:
                self._playback.pause()
                self._playback.go(change.frame)
            self.said.emit(said.format(text=change.text))
        self.changed.emit()
        return change is not None
