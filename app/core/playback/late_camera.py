"""Looking, off the GUI thread and beside playing, by how much a camera is late."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Generator

from tracking.people import lag_looks
from tracking.recording import Recording, StereoFrame

_log = logging.getLogger(__name__)


class LagSearch:
    """Finds the lag of a recording in a thread of its own, once.

    It reads with decoders of its own: those that play stay where they are.

    Args:
        recording: where the pictures come from; nothing is looked for in one of a single camera.
        found: is told by how many frames the right camera is late, where that is known; in the
            thread.
    """

    def __init__(self, recording: Recording, found: Callable[[int], None]) -> None:
        self._recording = recording
        self._found = found
        self._closed = threading.Event()
        self._thread: threading.Thread | None = None

    def start(self, frame: int) -> None:
        """Begin, unless that was done or it was cancelled; `frame` matters most."""
        begun = self._thread is not None or self._closed.is_set()
        if self._recording.is_stereo and not begun:
            self._thread = threading.Thread(
                target=self._run, args=(frame,), name="late camera", daemon=True
            )
            self._thread.start()

    def cancel(self) -> None:
        """Look no further than the frame in work."""
        self._closed.set()

    def wait(self) -> None:
        """Wait for the thread."""
        if self._thread is not None:
            self._thread.join()

    def _run(self, start: int) -> None:
        try:
            lag = self._look(start)
        except Exception:  # who asks for the frame that cannot be read is told
            _log.warning("whether a camera is late is not known", exc_info=True)
        else:
            if lag is not None:
                self._found(lag)

    def _look(self, start: int) -> int | None:
        """The lag; None where nothing tells, or it was cancelled."""
        looks, frames = lag_looks(self._recording, start), _InOrder(self._recording)
        try:
            wanted = next(looks)
            while not self._closed.is_set():
                wanted = looks.send(frames.read(wanted))
        except StopIteration as told:
            lag: int | None = told.value
            return lag
        finally:
            frames.close()
        return None


class _InOrder:
    """Frames by number, with a decoder that goes on where they follow one another."""

    def __init__(self, recording: Recording) -> None:
        self._recording = recording
        self._next = 0
        self._frames: Generator[StereoFrame] | None = None

    def read(self, number: int) -> StereoFrame:
        """One frame."""
        if self._frames is None or number != self._next:
            self.close()
            self._frames = self._recording.frames(number)
        self._next = number + 1
        return next(self._frames)

    def close(self) -> None:
        """Let go of the decoder."""
        if self._frames is not None:
            self._frames.close()
