"""Plays a stretch of the recording and stops at its end."""

from __future__ import annotations

from PySide6.QtCore import QObject

from app.core.playback.playback import Playback


class StretchPlayback(QObject):
    """Plays a stretch once, unless the user pauses first or a loop holds its end."""

    def __init__(self, playback: Playback, parent: QObject) -> None:
        super().__init__(parent)
        self._playback = playback
        self._end: int | None = None
        playback.moved.connect(self._stop_at_the_end)

    def play(self, start: int, end: int) -> None:
        """Go to the first frame of a half-open range and play it."""
        self._playback.go(start)
        if not self._playback.clock.playing:
            self._playback.toggle()
        self._end = end

    def forget(self) -> None:
        """Stop at no end any more."""
        self._end = None

    def _stop_at_the_end(self) -> None:
        clock, end = self._playback.clock, self._end
        if end is None:
            return
        if not clock.playing:
            self._end = None
        elif clock.frame >= end - 1 and not self._loops_over(end):
            self._end = None
            self._playback.pause()

    def _loops_over(self, end: int) -> bool:
        """Whether the end of a stretch is where a loop begins again."""
        loop = self._playback.clock.loop
        return loop is not None and loop[0] < end <= loop[1]
