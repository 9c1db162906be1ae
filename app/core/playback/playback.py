"""Playing an open recording: the clock driven by wall time, frames fetched as they are due."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from app.core.playback.clock import LEAD_S, PlaybackClock
from app.core.playback.frames import FrameReader
from tracking.recording import Recording, StereoFrame

CACHE_BYTES = 400 * 2**20
_TICK_MS = 8
_LOOK_MS = 250


class Playback(QObject):
    """The clock of one recording and the frame that is shown.

    `frame` is what all views show: both cameras of one instant. While the reader is busy it may
    stand behind `clock.frame`, the playhead. Signals: `shown()`, another frame is there; `moved()`,
    the playhead, the speed, playing or what is at hand changed; `failed(error)`, a frame cannot be
    read.

    Attributes:
        following: the playhead goes where `follow` puts it, until it is moved in any other way.
    """

    shown = Signal()
    moved = Signal()
    failed = Signal(object)

    def __init__(self, recording: Recording, parent: QObject) -> None:
        super().__init__(parent)
        self.clock = PlaybackClock(recording.frame_count, recording.fps)
        self.frame: StereoFrame | None = None
        self.loaded: tuple[tuple[int, int], ...] = ()
        self.wait_at: Callable[[], int | None] = lambda: None
        self.following = False
        self._ticket = 0
        self._asked = -1
        self._reader = FrameReader(recording, CACHE_BYTES, self)
        self._reader.ready.connect(self._take, Qt.ConnectionType.QueuedConnection)
        self._reader.failed.connect(self._tell_failure, Qt.ConnectionType.QueuedConnection)
        self._ticked_s = 0.0
        self._timer = QTimer(self, interval=_TICK_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._looking = QTimer(self, interval=_LOOK_MS)
        self._looking.timeout.connect(self._look_what_is_loaded)

    @property
    def number(self) -> int:
        """The frame shown; the playhead's while none is."""
        return self.clock.frame if self.frame is None else self.frame.number

    def at_hand(self, frame: int) -> StereoFrame | None:
        """A frame where it need not be read first; may be asked from any thread."""
        return self._reader.get_cached(frame)

    def go(self, frame: int) -> None:
        """Go to a frame; playing goes on from there."""
        self.clock.seek(frame)
        self._moved_by_hand()

    def follow(self, frame: int) -> None:
        """Go to a frame, paused, as more than one to come: see `following`."""
        self.following = True
        self.clock.pause()
        self.clock.seek(frame)
        self._changed()

    def stay(self) -> None:
        """Follow no further; the playhead stays where it is."""
        self._moved_by_hand()

    def step(self, frames: int) -> None:
        """Pause and go some frames on or back."""
        self.clock.step(frames)
        self._moved_by_hand()

    def toggle(self) -> None:
        """Play or pause."""
        self.clock.toggle()
        self._moved_by_hand()

    def pause(self) -> None:
        """Stay here."""
        self.clock.pause()
        self._moved_by_hand()

    def shuttle(self, direction: int) -> None:
        """J (-1), K (0), L (1)."""
        self.clock.shuttle(direction)
        self._moved_by_hand()

    def set_speed(self, speed: float) -> None:
        """Choose a speed."""
        self.clock.set_speed(speed)
        self._changed()

    def change_speed(self, steps: int) -> None:
        """Faster (1) or slower (-1)."""
        self.clock.change_speed(steps)
        self._changed()

    def set_loop(self, frames: tuple[int, int] | None) -> None:
        """Play a half-open range again and again, or all once; a loop begins to play."""
        self.clock.loop = frames
        if frames is not None and not self.clock.playing:
            self.clock.play()
        self._moved_by_hand()

    def set_event(self, frame: int | None) -> None:
        """Play slowly around a frame, beginning a moment before it; None: nowhere any more."""
        self.clock.event = frame
        if frame is not None:
            self.clock.seek(frame - round(LEAD_S * self.clock.fps))
            self.clock.play()
        self._moved_by_hand()

    def close(self) -> None:
        """Stop the timer and the reader's thread."""
        self._timer.stop()
        self._looking.stop()
        self._reader.close()

    def _moved_by_hand(self) -> None:
        self.following = False
        self._changed()

    def _changed(self) -> None:
        if self.clock.playing and not self._timer.isActive():
            self._ticked_s = time.perf_counter()
            self._timer.start()
        elif not self.clock.playing:
            self._timer.stop()
        self._fetch()
        self.moved.emit()

    def _tick(self) -> None:
        before_s, self._ticked_s = self._ticked_s, time.perf_counter()
        elapsed_s = self._ticked_s - before_s  # whole milliseconds would play a twentieth too slow
        if self.clock.advance(elapsed_s, self.wait_at()):
            self._fetch()
            self.moved.emit()
        if not self.clock.playing:
            self._changed()

    def _fetch(self) -> None:
        """Show the frame that is due, at once where it is at hand; have the next ones read."""
        due = self.clock.frame
        if self.frame is not None and self.frame.number == due == self._asked:
            return  # were another one asked for, that would be shown once it is read
        if not self._looking.isActive():
            self._looking.start()
        at_hand = self._reader.get_cached(due)
        self._asked = due
        self._ticket = self._reader.request(due, 1 if self.clock.rate >= 0 else -1)
        if at_hand is not None:
            self._show(at_hand)

    def _look_what_is_loaded(self) -> None:
        """Tell which frames are at hand, now and then while more are being read."""
        before, self.loaded = self.loaded, tuple(self._reader.kept)
        if before != self.loaded:
            self.moved.emit()
        elif not self.clock.playing:
            self._looking.stop()

    def _take(self, ticket: int, frame: StereoFrame) -> None:
        """Show a frame that was read, also one asked for a moment ago while more is coming."""
        if ticket == self._ticket or self.clock.playing:
            self._show(frame)

    def _show(self, frame: StereoFrame) -> None:
        shown = self.frame
        if shown is None or (shown.number, shown.right_lag) != (frame.number, frame.right_lag):
            self.frame = frame
            self.shown.emit()

    def _tell_failure(self, _frame: int, error: Exception) -> None:
        self.clock.pause()
        self._changed()
        self.failed.emit(error)
