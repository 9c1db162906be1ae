"""Annotating fast: box after box, copies, ghosts, suggested boxes, boxes moved by keys."""

from __future__ import annotations

import time

from PySide6.QtCore import QObject

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.drawing.surfaces import PictureSurface
from app.core.editing.suggested_boxes import (
    Ghost,
    SuggestedBox,
    find_ghost,
    suggest_boxes,
    suggestion_at,
)
from app.core.i18n import tr
from app.core.keymap import key_or_title
from app.core.playback.playback import Playback
from app.core.scenes.detections import DETECTION
from app.core.scenes.suggested_marks import SuggestedMark
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.core.tracks.recording_geometry import box_of
from app.features.correction.box_search import BoxSearch
from app.features.correction.controller import EditController
from app.features.correction.work_meter import WorkMeter
from tracking.tracks import Box, TrackTable

_FAR_PX = 10.0


class AnnotationController(Controller):
    """Puts boxes by keys, and shows those that can be put.

    `changed`: whose the next box is, or what is switched on, is another.

    Attributes:
        meter: how fast boxes are put. suggested: what is shown in the frame.
    """

    def __init__(
        self,
        document: Document,
        playback: Playback,
        picture: PictureSurface,
        editing: EditController,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._document, self._playback = document, playback
        self._picture, self._editing = picture, editing
        self._search = BoxSearch(document, self)
        self._search.found.connect(self.changed)
        self._search.failed.connect(self.failed)
        self.meter = WorkMeter(time.monotonic)
        document.tell(self.meter)
        self.suggested: tuple[SuggestedBox, ...] = ()
        self._state: FrameState | None = None

    @property
    def busy(self) -> bool:
        """Whether boxes to suggest are being read."""
        return self._search.busy

    def close(self) -> None:
        """End the thread; leave nothing on the picture, which outlives the document."""
        self._search.close()
        self._picture.show_suggested(())

    # what is switched on

    def toggle_drawing(self) -> None:
        """Draw boxes one after the other, or no longer."""
        mode = self._document.correcting.mode
        mode.drawing = not mode.drawing
        if mode.drawing:
            self._playback.pause()
            self._document.correcting.leave()
        self.changed.emit()

    def set_step(self, frames: int) -> None:
        """How far to go on after each box."""
        self._document.correcting.mode.step = frames
        self.changed.emit()

    def toggle_at_once(self) -> None:
        """Edits of one person without a preview, or with one again."""
        mode = self._document.correcting.mode
        mode.at_once = not mode.at_once
        mode.two_at_once = mode.two_at_once and mode.at_once
        self._tell_at_once()

    def toggle_two_at_once(self) -> None:
        """Those of two people, too."""
        mode = self._document.correcting.mode
        mode.two_at_once = not mode.two_at_once
        mode.at_once = mode.at_once or mode.two_at_once
        self._tell_at_once()

    @property
    def at_once_text(self) -> str:
        """That edits are done without a preview; "" where they are not."""
        mode = self._document.correcting.mode
        if mode.two_at_once:
            return tr("Edits without preview, of two people, too")
        return tr("Edits without preview") if mode.at_once else ""

    def _tell_at_once(self) -> None:
        self.said.emit(self.at_once_text or tr("Edits are shown before they are done"))
        self.changed.emit()

    # boxes by keys

    def copy_box(self) -> None:
        """Keep the selected person's box of this frame, to put it elsewhere."""
        box = self._selected_box()
        if box is None:
            self.said.emit(tr("{track} has no box in this frame", track=self._track))
            return
        self._document.correcting.mode.copied = box
        self.said.emit(
            tr(
                "Copied the box of {track}; to put it: {key}",
                track=self._track,
                key=key_or_title("tracks.paste_box"),
            )
        )
        self.changed.emit()

    def paste_box(self) -> None:
        """Put the box that was copied: the selected person's, else a new one's."""
        copied = self._document.correcting.mode.copied
        if copied is not None:
            self._editing.put_box(copied)

    def nudge(self, right: int, down: int, *, far: bool = False, resize: bool = False) -> None:
        """Move or resize the selected person's box by a pixel, or by ten."""
        flow, box = self._document.flow, self._selected_box()
        if flow is not None and flow.places:
            self._editing.nudge(right, down, far=far, resize=resize)
        elif box is None:
            self.said.emit(tr("{track} has no box in this frame", track=self._track))
        else:
            by = _FAR_PX if far else 1.0
            left, top, width, height = box
            x, y = right * by, down * by
            moved = (left + x, top + y, width, height)
            self._editing.put_box((left, top, width + x, height + y) if resize else moved)

    def _selected_box(self) -> Box | None:
        frame = self._playback.clock.frame
        table = self._table()
        row = table.of_track(self._track, frame, frame + 1) if self._track in table else None
        return box_of(row) if row is not None and len(row["frame"]) else None

    # ghosts and suggestions

    def accept_ghost(self) -> None:
        """Put the selected person's last box here, too."""
        ghost = self._ghost(self._playback.clock.frame)
        if ghost is None:
            self.said.emit(tr("Nobody is selected who was here shortly before"))
        else:
            self._editing.put_box(ghost.box)

    def dismiss_ghost(self) -> None:
        """Show no more the last box of who is expected under the mouse, else of who is selected."""
        frame, place = self._playback.clock.frame, self._pointed_place()
        ghosts = {ghost.track: ghost for ghost in self._ghosts(frame)}
        mine = self._ghost(frame)
        expected = [SuggestedBox(ghost.expected, track) for track, ghost in ghosts.items()]
        pointed = suggestion_at(expected, *place) if place is not None else None
        ghost = ghosts[pointed.track] if pointed is not None else mine
        if ghost is None:
            self.said.emit(tr("No last box is shown here"))
            return
        self._document.correcting.mode.dismissed[ghost.track] = ghost.frame
        self.said.emit(
            tr(
                "The last box of {track} is shown no more, until they are drawn again",
                track=ghost.track,
            )
        )
        self.changed.emit()

    def accept_suggestion(self) -> None:
        """Take the suggested box under the mouse, else the one that may be the selected person's.

        One under the mouse is of whom it says, else of whom the next box that is drawn would be.
        """
        suggested = self._suggested_now()
        if suggested is None:
            return
        place = self._pointed_place()
        pointed = suggestion_at(suggested, *place) if place is not None else None
        if pointed is None:
            mine = (one for one in suggested if self._track and one.track == self._track)
            pointed = next(mine, None)
        if pointed is None:
            self.said.emit(tr("No suggested box is near: point at one with the mouse"))
            return
        frame = self._playback.clock.frame
        if pointed.track:
            self._document.selection.choose(pointed.track)
        elif self._document.correcting.next_is_new(frame):
            self._document.selection.choose(0)
        self._editing.put_box(pointed.box)

    def accept_all(self) -> None:
        """Take every suggested box that says whose it may be."""
        suggested = self._suggested_now()
        if suggested is None:
            return
        boxes = {one.track: one.box for one in suggested if one.track}
        if boxes:
            self._editing.put_boxes(boxes)
        elif suggested:
            self.said.emit(tr("No suggested box is near to anybody who was here before"))
        else:
            self.said.emit(tr("There is no suggested box in this frame"))

    def _suggested_now(self) -> tuple[SuggestedBox, ...] | None:
        """What can be accepted in the frame that is shown, drawn as suggested or not.

        None: that is still being read, which is said.
        """
        if not self.suggested and self._state is not None:
            self.suggested = self._suggest(self._state)
            if self._search.busy:
                self.said.emit(tr("Suggested boxes are still being read: press the key again"))
                return None
        return self.suggested

    def _suggest(self, state: FrameState) -> tuple[SuggestedBox, ...]:
        ghosts = {one.track: one for one in self._ghosts(state.frame)}
        if (mine := self._ghost(state.frame)) is not None:
            ghosts[mine.track] = mine
        found = self._search.boxes(state.frame, state.tracks)
        return suggest_boxes(found.boxes, tuple(ghosts.values()), found.alone)

    def _pointed_place(self) -> tuple[float, float] | None:
        """Where the mouse is in the picture, in its pixels."""
        at = self._picture.pointed_at
        place = self._picture.viewport.to_content(at) if at is not None else None
        return (place.x(), place.y()) if place is not None else None

    # drawing

    def draw_frame(self, state: FrameState, options: ViewOptions) -> None:
        """Show a frame's ghosts and suggestions."""
        correcting = self._document.correcting
        shown = correcting.can_place and correcting.flow is None
        drawing = correcting.mode.drawing
        self._state = state if shown else None
        mine = self._ghost(state.frame) if shown else None
        ghosts = self._ghosts(state.frame, drawn_only=True) if shown and drawing else ()
        searched = shown and (options.suggestions or drawing)
        self.suggested = self._suggest(state) if searched else ()
        found = {one.track for one in self.suggested}
        others = (one for one in ghosts if mine is None or one.track != mine.track)
        drawn = [one for one in others if one.track not in found]
        drawn += [] if mine is None else [mine]
        suggestions = (self._mark(one, state) for one in self.suggested)
        self._picture.show_suggested(
            (*suggestions, *(_ghost_mark(one, state, last=one is mine) for one in drawn))
        )

    def _ghosts(self, frame: int, *, drawn_only: bool = False) -> tuple[Ghost, ...]:
        correcting = self._document.correcting
        return correcting.ghosts_before(self._table(), frame, drawn_only=drawn_only)

    def _ghost(self, frame: int) -> Ghost | None:
        ghost = find_ghost(self._table(), self._track, frame, self._document.recording.fps)
        waited = ghost is not None and self._document.correcting.mode.is_waited_for(ghost)
        return ghost if waited else None

    def _table(self) -> TrackTable:
        session = self._document.session
        return session.tracks if session is not None else TrackTable()

    @property
    def _track(self) -> int:
        return self._document.selection.track

    def _mark(self, one: SuggestedBox, state: FrameState) -> SuggestedMark:
        if not one.track:
            return SuggestedMark(one.box, "", DETECTION)
        label = tr("{name}?", name=state.label(one.track))
        return SuggestedMark(one.box, label, state.colours.of(one.track))


def _ghost_mark(ghost: Ghost, state: FrameState, *, last: bool) -> SuggestedMark:
    """Of the selected person their last box, which a key puts here; of others where they may be."""
    name, colour = state.label(ghost.track), state.colours.of(ghost.track)
    if last:
        label = tr("{name} in frame {frame}", name=name, frame=ghost.frame)
        return SuggestedMark(ghost.box, label, colour, ghost=True)
    return SuggestedMark(ghost.expected, tr("{name}?", name=name), colour, ghost=True)
