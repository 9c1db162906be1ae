"""Reading frames off the GUI thread: the newest request wins, then what comes next is fetched."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from app.core.playback.late_camera import LagSearch
from tracking.recording import FrameCache, Instants, Recording, StereoFrame


@dataclass(frozen=True, slots=True)
class _Request:
    ticket: int
    frame: int


class FrameReader(QObject):
    """Reads frames of one recording in a thread.

    `ready(ticket, frame)` carries a `StereoFrame`: both cameras of one instant. Whether a camera is
    late is looked for from the first one on (`LagSearch`); if it is, the frame asked for last comes
    once more, with the right picture of its instant. Requests that were overtaken before their turn
    are never read. `failed(frame, error)` says which frame could not be read; later requests go on.
    Without `close`, which waits for its threads, these end once their reader is destroyed.
    """

    ready = Signal(int, object)
    failed = Signal(int, object)

    def __init__(self, recording: Recording, cache_bytes: int, parent: QObject) -> None:
        super().__init__(parent)
        self._instants = Instants(recording, recording.right_lag or 0)
        self._cache = FrameCache(self._instants, cache_bytes)
        self._search = LagSearch(recording, self._take_lag)
        self._lag = self._instants.lag  # as it is known; the thread takes it between two frames
        self._ticket = 0
        self._wanted: _Request | None = None
        self._closing, self._changed = threading.Event(), threading.Condition()
        self.destroyed.connect(_ending(self._closing, self._changed, self._search))
        self._thread = threading.Thread(target=self._run, name="frame reader", daemon=True)
        self._thread.start()

    @property
    def kept(self) -> list[tuple[int, int]]:
        """The frames at hand, as half-open ranges."""
        return self._cache.kept_ranges()

    def get_cached(self, frame: int) -> StereoFrame | None:
        """The frame if it is at hand, without waiting."""
        return self._cache.get(frame)

    def request(self, frame: int, direction: int = 1) -> int:
        """Ask for a frame; it replaces what was asked before. `direction` leads the prefetch."""
        with self._changed:
            self._ticket += 1
            self._cache.point_at(frame, direction)
            self._wanted = _Request(self._ticket, frame)
            self._changed.notify()
            return self._ticket

    def close(self) -> None:
        """End the thread and wait for it."""
        _ending(self._closing, self._changed, self._search)()
        self._thread.join()
        self._search.wait()

    def _run(self) -> None:
        served: _Request | None = None
        more = False
        while True:
            with self._changed:
                while not (more or self._has_news(served)):
                    self._changed.wait()
                if self._closing.is_set():
                    return
                request = self._wanted
                if self._lag != self._instants.lag:
                    self._instants.lag = self._lag
                    self._cache.clear()  # of pictures that were paired wrongly
                    served = None
            if request is not None and request is not served:
                self._serve(request)
                self._search.start(request.frame)
                served, more = request, True
            else:
                more = self._fetch_ahead()

    def _has_news(self, served: _Request | None) -> bool:
        """Whether there is more to do than to fetch ahead."""
        asked = self._wanted is not served or self._lag != self._instants.lag
        return asked or self._closing.is_set()

    def _serve(self, request: _Request) -> None:
        frame: StereoFrame | None = None
        try:
            frame = self._cache.read(request.frame)
        except Exception as error:  # a bug too: the window says so, later requests go on
            problem = error
        try:
            if frame is None:
                self.failed.emit(request.frame, problem)
            else:
                self.ready.emit(request.ticket, frame)
        except RuntimeError:  # the reader was destroyed while it read: nobody is there to tell
            if not self._closing.is_set():
                raise

    def _take_lag(self, lag: int) -> None:
        """Told in the thread of the search."""
        with self._changed:
            self._lag = lag
            self._changed.notify()

    def _fetch_ahead(self) -> bool:
        """Read one more frame in the play direction; whether there may be more to fetch."""
        try:
            return self._cache.prefetch()
        except Exception:
            return False  # told when somebody asks for this very frame


def _ending(
    closing: threading.Event, changed: threading.Condition, search: LagSearch
) -> Callable[[], None]:
    """Has the threads of a reader end.

    Asks nothing of Qt: the reader may be gone as a `QObject`, while the search still holds it.
    """

    def end() -> None:
        search.cancel()
        closing.set()
        with changed:
            changed.notify()

    return end
