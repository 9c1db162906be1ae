"""The other end of a reader: a file that ends or holds up its process is told as unreadable."""

from __future__ import annotations

import subprocess
import threading
from typing import Self

from tracking import child_program
from tracking.project.facts import RecordingFacts, SessionFacts
from tracking.project.readings import ReadFacts, Reading, unreadable
from tracking.translation import msg
from tracking.untrusted.pipe import receive_bytes, receive_head, send

PATIENCE_S = 300.0
"""Of one file, by the clock: a long session with ground truth takes a minute on a busy machine."""
_MOST_IMAGE_BYTES = 4 << 20


class ReaderProcess:
    """Reads facts in a child process, which is started when it is needed and after it died.

    `read` belongs to one thread; `close` may be called from any.
    """

    def __init__(self, patience_s: float = PATIENCE_S) -> None:
        self._patience_s = patience_s
        self._child: subprocess.Popen[bytes] | None = None
        self._lock = threading.Lock()
        self._is_closed = False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def read(self, reading: Reading) -> ReadFacts:
        """What a file tells; one that its process does not survive tells that."""
        overdue = threading.Event()

        def end() -> None:
            overdue.set()
            self._kill()

        child = self._begin()
        if child is None:
            return unreadable(reading.of_session, msg("stopped"))
        timer = threading.Timer(self._patience_s, end)
        timer.daemon = True
        timer.start()
        try:
            return self._answer(child, reading)
        except (OSError, ValueError, KeyError, TypeError):
            self._end()
            if overdue.is_set():
                why = msg("reading it took longer than {n:g} s", n=self._patience_s)
            else:
                why = msg("it is damaged: it cannot be read safely")
            return unreadable(reading.of_session, why)
        finally:
            timer.cancel()

    def close(self) -> None:
        """End the child; nothing is read any more."""
        with self._lock:
            self._is_closed = True
        self._end()

    @property
    def is_closed(self) -> bool:
        """Whether nothing is read any more."""
        return self._is_closed

    def _answer(self, child: subprocess.Popen[bytes], reading: Reading) -> ReadFacts:
        """Raises OSError or ValueError where there is none."""
        assert child.stdin is not None
        assert child.stdout is not None
        recording = "" if reading.recording is None else str(reading.recording)
        asked = {"path": str(reading.path), "of_session": reading.of_session}
        send(child.stdin, {**asked, "recording": recording})
        said = receive_head(child.stdout)
        if said is None or not 0 <= int(said["bytes"]) <= _MOST_IMAGE_BYTES:
            raise ValueError("no answer")
        image = receive_bytes(child.stdout, int(said["bytes"]))
        kind = SessionFacts if reading.of_session else RecordingFacts
        return ReadFacts(kind.from_text(str(said["facts"])), image)

    def _begin(self) -> subprocess.Popen[bytes] | None:
        with self._lock:
            if self._is_closed:
                return None
            if self._child is None or self._child.poll() is not None:
                self._child = _started()
            return self._child

    def _kill(self) -> None:
        with self._lock:
            if self._child is not None:
                self._child.kill()

    def _end(self) -> None:
        self._kill()
        with self._lock:
            child, self._child = self._child, None
        if child is not None:
            child_program.end(child)


def _started() -> subprocess.Popen[bytes]:
    return child_program.begin(
        *("-m", "tracking.project.reader"),
        more=child_program.ONE_THREAD,
        stderr=subprocess.DEVNULL,
    )
