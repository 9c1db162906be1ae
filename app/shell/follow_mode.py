"""The playhead at the tracker's side, until somebody moves it."""

from __future__ import annotations

import time

from PySide6.QtCore import QObject

from app.core.commands.conditions import edit_waits
from app.core.controller import Controller
from app.core.document.document import Document
from app.core.playback.playback import Playback
from app.features.runs.controller import LiveTracking

_EVERY_S = 0.1
"""Pictures are read for this, which takes time from the tracker: ten a second look fluent."""


class FollowMode(Controller):
    """Shows the frame the tracker at work has come to, as it goes on.

    Whoever moves the playhead or plays looks at something else: the playhead stays with them
    then, and following is begun again by hand.

    `changed`: it is on or off by now.
    """

    def __init__(
        self, document: Document, playback: Playback, live: LiveTracking, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._document, self._playback, self._live = document, playback, live
        self._shown_s = 0.0
        self._was_on = False
        playback.moved.connect(self._look)

    @property
    def on(self) -> bool:
        """Whether the playhead goes with a tracker at work."""
        return self._live.running and self._playback.following

    def begin(self) -> None:
        """Go to where the tracker is, and with it from there."""
        if self._live.running:
            self._go()

    def toggle(self) -> None:
        """Follow, or stay here: with an edit that waits, which is of the tracks in view."""
        if self.on:
            self._playback.stay()
        elif self._document.flow is not None:
            self.said.emit(edit_waits())
        else:
            self.begin()

    def take(self) -> None:
        """The tracker is further."""
        if self.on and time.monotonic() - self._shown_s > _EVERY_S:
            self._go()

    def end(self) -> None:
        """The tracker is done: what it found last is shown."""
        if self._playback.following:
            self._go()
            self._playback.stay()

    def _look(self) -> None:
        before, self._was_on = self._was_on, self.on
        if before is not self._was_on:
            self.changed.emit()

    def _go(self) -> None:
        self._shown_s = time.monotonic()
        self._playback.follow(max(self._document.tracked_until - 1, self._live.first))
