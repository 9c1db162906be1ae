"""What the history panel asks for: go to an edit, back to it, undo it alone."""

from __future__ import annotations

import time

from PySide6.QtCore import QTimer

from app.core.document.undo_frame import is_seen_at
from app.core.feature import FeatureContext, FeatureController
from app.core.i18n import tr
from app.features.history.panel import HistoryPanel
from tracking.errors import TrackwrightError

_SLICE_S = 0.012


class HistoryWalk(FeatureController):
    """Goes through the history of a document.

    Signals: `changed()`, the tracks or who is selected are others than before.
    """

    def __init__(self, context: FeatureContext, panel: HistoryPanel) -> None:
        super().__init__(context.parent)
        self._document, self._playback = context.document, context.playback
        self._panel = panel
        self._goal = 0
        self._steps = QTimer(self, interval=0)
        self._steps.timeout.connect(self._walk)
        walk = self
        panel.edit_sought.connect(walk.go_to)
        panel.goto_asked.connect(walk.go_back_to)
        panel.alone_asked.connect(walk.undo_alone)
        panel.menu_opening.connect(walk.tell_why_not)

    def draw(self) -> None:
        """List the edits."""
        self._panel.show_scene(self._document.history())

    def go_to(self, edit: int) -> None:
        """Show what an edit changed: its frame, with its tracks selected."""
        session = self._document.session
        if session is None:
            return
        entry = session.history.entry(edit)
        self._playback.pause()
        self._playback.go(entry.frame)  # first: it may show the session's tracks again
        selection = self._document.selection
        there = [track for track in entry.change.tracks if track in session.tracks]
        if there and self._document.flow is None:
            selection.choose(there[0])
            for track in there[1:]:
                selection.add(track)
        self.changed.emit()

    def undo_alone(self, edit: int = 0) -> None:
        """Take an edit back and leave what was done after it; 0: the one chosen in the panel."""
        number = edit or self._panel.current_edit
        if not number:
            self.said.emit(tr("Choose an edit in the history first"))
            return
        self._document.correcting.leave()
        try:
            change = self._document.undo_alone(number)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        if not is_seen_at(change, self._playback.clock.frame, self._document.tracks):
            self._playback.pause()
            self._playback.go(change.frame)
        self.said.emit(tr("Done: {what}", what=change.text))
        self.changed.emit()

    def tell_why_not(self, edit: int) -> None:
        """Say in the menu that opens why an edit cannot be undone alone."""
        self._panel.say_why_not_alone(tr(self._document.why_not_alone(edit)))

    def go_back_to(self, edit: int) -> None:
        """Undo or redo until this edit is the last one in force; thousands of them in slices."""
        self._document.correcting.leave()
        self._goal = edit
        self._walk()

    def _walk(self) -> None:
        """Steps for a moment, so that the window stays alive; then the rest, or the end."""
        until = time.monotonic() + _SLICE_S
        try:
            while self._step():
                if time.monotonic() >= until:
                    self._steps.start()
                    self.said.emit(tr("Going back to edit {n}...", n=self._goal))
                    return
        except TrackwrightError as error:
            self.failed.emit(error)
        self._end()

    def _step(self) -> bool:
        """One edit taken back or done again; False where the goal is reached."""
        session = self._document.session
        if session is None or not self._goal:
            return False
        done, undone = session.history.next_undo, session.history.next_redo
        if done is not None and done.id > self._goal:
            return self._document.undo() is not None
        if undone is not None and undone.id <= self._goal:
            return self._document.redo() is not None
        return False

    def _end(self) -> None:
        self._steps.stop()
        session, goal, self._goal = self._document.session, self._goal, 0
        if session is not None and goal:
            entry = session.history.entry(goal)
            self._playback.pause()
            self._playback.go(entry.frame)
            self.said.emit(tr("Back at: {what}", what=entry.text))
        self.changed.emit()
