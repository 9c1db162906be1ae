"""Boxes and people dragged with the mouse: shown while they move, done when they are let go."""

from __future__ import annotations

from PySide6.QtCore import QObject

from app.core.document.document import Document
from app.core.editing import edits
from app.core.playback.playback import Playback
from app.features.correction.controller import EditController
from tracking.tracks import Box


class DragController(QObject):
    """Turns drags into edits; Esc while the button is held leaves everything as it was."""

    def __init__(self, document: Document, playback: Playback, editing: EditController) -> None:
        super().__init__(editing)
        self._document = document
        self._playback = playback
        self._editing = editing

    @property
    def _frame(self) -> int:
        """The frame that is seen, which is the one that is meant."""
        return self._playback.number

    def grab_box(self, track: int = 0) -> None:
        """Somebody's box is taken hold of; 0: the selected person's, or one that is drawn."""
        self._playback.pause()
        self._playback.go(self._frame)
        if track:
            self._document.correcting.leave()
            self._document.selection.choose(track)
        flow = self._document.flow
        if flow is None and not track and self._document.correcting.mode.drawing:
            self._editing.begin_next_box()
        elif flow is None or not flow.places or flow.spec is edits.FLOOR:
            self._editing.begin(edits.MOVE)

    def drag_box(self, box: Box) -> None:
        """It is there by now."""
        if self._document.flow is not None:
            self._document.correcting.put_box(box, self._frame)
            self._editing.previewed.emit()

    def grab_person(self, track: int) -> None:
        """Somebody in the overhead view is taken hold of."""
        self._playback.pause()
        self._playback.go(self._frame)
        self._document.correcting.leave()
        self._document.selection.choose(track)
        self._editing.begin(edits.FLOOR)

    def drag_person(self, x_m: float, y_m: float) -> None:
        """They stand there by now."""
        if self._document.flow is not None:
            self._document.correcting.put_place((x_m, y_m), self._frame)
            self._editing.previewed.emit()

    def drop(self) -> None:
        """They are let go: that is done, unless Esc was pressed meanwhile."""
        if self._document.flow is not None:
            self._editing.confirm()
