"""Reading frames off the GUI thread: the newest request wins, then what comes next is fetched."""

from __future__ import annotations

import threading
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from tracking.errors import TrackwrightError
from tracking.recording import FrameCache, Recording, StereoFrame

PREFETCH_FRAMES = 24


@dataclass(frozen=True, slots=True)
class _Request:
    ticket: int
    frame: int
    direction: int


class FrameReader(QObject):
    """Reads frames of one recording in a thread.

    `ready(ticket, frame)` carries a `StereoFrame`: both eyes of one instant. Requests that were
    overtaken before their turn are never read. `failed(frame, error)` says which frame could not
    be read; later requests go on.
    """

    ready = Signal(int, object)
    failed = Signal(int, object)

    def __init__(self, recording: Recording, cache_bytes: int, parent: QObject) -> None:
        super().__init__(parent)
        self._frame_count = recording.frame_count
        self._cache = FrameCache(recording, cache_bytes)
        self._ticket = 0
        self._wanted: _Request | None = None
        self._closed = False
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._run, name="frame reader", daemon=True)
        self._thread.start()

    def cached(self, frame: int) -> StereoFrame | None:
        """The frame if it is at hand, without waiting."""
        return self._cache.get(frame)

    def request(self, frame: int, direction: int = 1) -> int:
        """Ask for a frame; it replaces what was asked before. `direction` leads the prefetch."""
        with self._changed:
            self._ticket += 1
            self._wanted = _Request(self._ticket, frame, direction)
            self._changed.notify()
            return self._ticket

    def close(self) -> None:
        """End the thread and wait for it."""
        with self._changed:
            self._closed = True
            self._changed.notify()
        self._thread.join()

    def _run(self) -> None:
        served: _Request | None = None
        ahead = 0
        while True:
            with self._changed:
                while not self._closed and self._wanted is served and ahead <= 0:
                    self._changed.wait()
                if self._closed:
                    return
                request = self._wanted
            if request is not None and request is not served:
                self._serve(request)
                served, ahead = request, PREFETCH_FRAMES
            elif served is not None:
                ahead = self._fetch_ahead(served, ahead)

    def _serve(self, request: _Request) -> None:
        try:
            frame = self._cache.read(request.frame)
        except TrackwrightError as error:
            self.failed.emit(request.frame, error)
        else:
            self.ready.emit(request.ticket, frame)

    def _fetch_ahead(self, served: _Request, ahead: int) -> int:
        """Read one more frame in the play direction; what is left to fetch."""
        step = PREFETCH_FRAMES - ahead + 1
        frame = served.frame + step * (1 if served.direction >= 0 else -1)
        if not 0 <= frame < self._frame_count:
            return 0
        try:
            self._cache.read(frame)
        except TrackwrightError:
            return 0  # told when somebody asks for this very frame
        return ahead - 1
