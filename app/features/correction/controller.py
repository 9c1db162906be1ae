"""Correcting in the open recording: from the first key to Enter, undo and redo, labels."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, Signal

from app.core.controller import Controller
from app.core.document import document_loader
from app.core.document.document import Document
from app.core.document.undo_frame import is_seen_at
from app.core.editing import EditFlow, EditScope, EditSpec, edits
from app.core.editing.annotation_mode import NextBox
from app.core.i18n import tr
from app.core.playback.playback import Playback
from tracking.editing import (
    Change,
    plan_rename,
    plan_set_attribute,
    plan_set_notes,
)
from tracking.errors import TrackwrightError
from tracking.tracks import Box


class EditController(Controller):
    """Turns gestures into edits of a document.

    `changed`: the tracks, the labels or the pending edit are others than before. Signals:
    `previewed()`, only what the pending edit would do is.
    """

    previewed = Signal()

    def __init__(self, document: Document, playback: Playback, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._playback = playback

    # an edit on its way

    def begin(self, spec: EditSpec, scope: EditScope | None = None, other: int = 0) -> None:
        """Begin an edit of who is selected at the playhead, perhaps with the second person."""
        self._begun(lambda frame: self._document.correcting.begin(spec, frame, scope, other))

    def begin_drawing(self, new: bool = False) -> None:
        """W: draw a box of who is selected, or (Ins) the first one of somebody new.

        While boxes are drawn one after the other, this says whose the next one is.
        """
        mode = self._document.correcting.mode
        if mode.drawing and self._document.flow is None:
            mode.next_box = NextBox.NEW if new else NextBox.SELECTED
            self.changed.emit()
            return
        self._begun(lambda frame: self._document.correcting.begin_drawing(frame, new))

    def begin_next_box(self) -> None:
        """A box is dragged while boxes are drawn one after the other."""
        self._begun(self._document.correcting.begin_next_box)

    def put_box(self, box: Box) -> None:
        """Put a box of who is selected, or of somebody new, in this frame at once."""
        correcting = self._document.correcting
        if correcting.flow is not None:
            correcting.leave()
        self._begun(lambda frame: correcting.begin(edits.PUT, frame, box=box))

    def put_boxes(self, boxes: Mapping[int, Box]) -> None:
        """Put boxes of several tracks in this frame at once."""
        self._begun(lambda frame: self._document.correcting.begin_boxes(frame, boxes))

    def _begun(self, begin: Callable[[int], None]) -> None:
        self._playback.pause()
        begin(self._playback.clock.frame)
        flow = self._document.flow
        if flow is not None and flow.leads and flow.cut != self._playback.clock.frame:
            self._playback.go(flow.cut)
        self._finish_at_once()
        self.changed.emit()

    def _finish_at_once(self) -> None:
        """Do an edit that is to be done without a preview; what cannot be done is told."""
        correcting = self._document.correcting
        flow, planned = correcting.flow, correcting.planned
        if correcting.finishes_at_once:
            self.confirm()
        elif flow is not None and flow.spec.at_once and planned is not None:
            correcting.leave()
            self.said.emit(" ".join(planned.scene.details))

    def pick(self, track: int) -> None:
        """A person was clicked in some view."""
        self._picked(lambda: self._document.correcting.pick(track))
        self._draw_picked()

    def _draw_picked(self) -> None:
        """Whoever was picked between two boxes is drawn next."""
        mode = self._document.correcting.mode
        if mode.drawing and self._document.flow is None:
            picked = bool(self._document.selection)
            mode.next_box = NextBox.SELECTED if picked else NextBox.AUTO
            self.changed.emit()

    def add(self, track: int) -> None:
        """A person was clicked with Shift: they are selected too."""
        self._picked(lambda: self._document.correcting.add(track))

    def pick_next(self, step: int) -> None:
        """Tab or Shift+Tab."""
        here = self._document.people_at(self._playback.number)
        self._picked(lambda: self._document.correcting.pick_next(here, step), final=False)
        self._draw_picked()

    def pick_typed(self, track: int) -> None:
        """The other person's id was typed or chosen among those that may be meant."""
        self._picked(lambda: self._document.correcting.pick_typed(track))

    def consider(self, track: int) -> None:
        """The other person's id was typed so far; 0: nothing of it is left."""
        self._picked(lambda: self._document.correcting.consider(track), final=False)

    def next_proposal(self, step: int) -> None:
        """Up or Down: another of the frames, or of the people, that were found."""
        flow = self._document.flow
        if flow is not None and not flow.needs_other and len(flow.cuts) == 1:
            self.said.emit(tr("No other frame was found: Left / Right move this one"))
            return
        self._picked(lambda: self._document.correcting.next_proposal(step), final=False)

    def put_proposed_cut(self, number: int) -> None:
        """One of the frames that were found was clicked."""
        self._put(lambda flow: flow.at_cut(number))

    def _picked(self, pick: Callable[[], None], final: bool = True) -> None:
        """Pick somebody or something; final: not one of several that are gone through."""
        before = self._document.flow
        pick()
        flow = self._document.flow
        if flow is not None and flow is not before and flow.leads:
            self._playback.go(flow.cut)
        if final and flow is not before:
            self._finish_at_once()
        self.changed.emit()

    def go_to_end_of_track(self, *, end: bool) -> None:
        """Go to the first frame of the selected track, or to its last one."""
        card = self._document.card()
        if card is not None:
            self._playback.go(card.last_frame if end else card.first_frame)

    def move_cut(self, frames: int) -> None:
        """Left / Right: move the cut, and the playhead with it."""
        count = self._document.recording.frame_count
        self._put(lambda flow: flow.moved(frames, count), moves=True)

    def put_cut(self, frame: int) -> None:
        """Put the cut at a frame."""
        flow = self._document.flow
        if flow is not None:
            self.move_cut(frame - flow.cut)

    def move_end(self, frames: int) -> None:
        """Ctrl+Left / Right: move the end of the range, and the playhead to its last frame."""
        count = self._document.recording.frame_count
        self._put(lambda flow: flow.with_end_moved(frames, count), moves=True, at_end=True)

    def next_choice(self, row: int = 0) -> None:
        """R: from here on, this range, this frame, and around again; C: how it is done."""
        self._put(lambda flow: flow.with_choice(row, flow.chosen(row) + 1))

    def choose(self, row: int, number: int) -> None:
        """One of the edit's choices was clicked."""
        self._put(lambda flow: flow.with_choice(row, number))

    def nudge(self, right: int, down: int, *, far: bool = False, resize: bool = False) -> None:
        """An arrow key moves or resizes the box that waits."""
        self._document.correcting.nudge(right, down, far=far, resize=resize)
        self.previewed.emit()

    def mark(self, *, end: bool) -> None:
        """[ or ]: the range begins, or ends, with the frame at the playhead."""
        frame, correcting = self._playback.clock.frame, self._document.correcting
        if end:
            correcting.mark(stop=frame + 1)
        else:
            correcting.mark(start=frame)
        self.changed.emit()
        if correcting.marked is not None:
            first, stop = correcting.marked
            self.said.emit(tr("Range: frames {first} to {last}", first=first, last=stop - 1))

    def unmark(self) -> None:
        """No range any more."""
        self._document.correcting.unmark()
        self.changed.emit()

    def _put(
        self, step: Callable[[EditFlow], EditFlow], *, moves: bool = False, at_end: bool = False
    ) -> None:
        """Change the edit; the playhead goes along where that moves an end, or the edit leads."""
        before = self._document.flow
        if before is None:
            return
        self._document.correcting.change(step(before))
        flow = self._document.flow
        if flow is not None and flow.has_cut and (moves or flow.leads):
            self._playback.go(flow.end - 1 if at_end else flow.cut)
        self.changed.emit()

    def confirm(self) -> None:
        """Enter: do the edit; the playhead stays, unless boxes are drawn one after the other."""
        flow, mode = self._document.flow, self._document.correcting.mode
        done = self._do(self._confirm, tr("Done: {text}"))
        if not done or flow is None or not flow.places or not mode.drawing:
            return
        if flow.track and not flow.boxes and flow.track != self._document.selection.track:
            self._document.selection.choose(flow.track)  # who was found by where the box is
            self.changed.emit()
        if mode.step:
            clock = self._playback.clock
            self._playback.go(min(clock.frame + mode.step, clock.last_frame))

    def _confirm(self) -> Change | None:
        """Do it; the first box anybody draws makes the session it is kept in."""
        document = self._document
        ready = document.planned is not None and document.planned.change is not None
        if ready and document.session is None:
            document.take_session(document_loader.session_by_hand(document.recording))
        return document.confirm_edit()

    def leave(self) -> None:
        """Esc: leave the edit and go back to where it was begun; else end drawing, or let go."""
        correcting = self._document.correcting
        begun_at = correcting.begun_at
        if correcting.flow is not None:
            correcting.leave()
            if begun_at is not None and begun_at != self._playback.clock.frame:
                self._playback.go(begun_at)
        elif correcting.mode.drawing:
            correcting.mode.drawing = False
        else:
            self._document.selection.choose(0)
        self.changed.emit()

    # history

    def undo(self) -> bool:
        """Take the last edit back and go where it was; whether that was done."""
        self._document.correcting.leave()
        return self._do(self._document.undo, tr("Undone: {text}"), go=True)

    def redo(self) -> bool:
        """Do the edit again that was taken back and go where it was; whether that was done."""
        self._document.correcting.leave()
        return self._do(self._document.redo, tr("Redone: {text}"), go=True)

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

    def set_attribute(self, track: int, key: str, value: str | None) -> None:
        """Set one attribute of a track; None takes it away."""
        self._label(lambda table, labels: plan_set_attribute(table, labels, track, key, value))

    def change_labels(self, plan: Callable[..., Change]) -> None:
        """Do an edit of labels that is planned on the corrected tracks and labels."""
        self._label(plan)

    def _label(self, plan: Callable[..., Change]) -> None:
        session = self._document.session
        if session is None:
            return

        def apply() -> Change:
            change = plan(session.tracks, session.labels)
            self._document.apply(change)
            return change

        self._do(apply, tr("Done: {text}"))

    def _do(self, step: Callable[[], Change | None], said: str, go: bool = False) -> bool:
        """Do something to the document and say it, or tell why not; whether it was done.

        go: go where it can be seen, unless it is seen from here.
        """
        try:
            change = step()
        except TrackwrightError as error:
            self.changed.emit()
            self.failed.emit(error)
            return False
        if change is not None:
            if go and not self._is_seen(change):
                self._playback.pause()
                self._playback.go(change.frame)
            self.said.emit(said.format(text=tr(change.text)))
        self.changed.emit()
        return change is not None

    def _is_seen(self, change: Change) -> bool:
        return is_seen_at(change, self._playback.clock.frame, self._document.tracks)
