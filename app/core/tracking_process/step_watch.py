"""Whoever takes too long for a frame is ended: a watch over what plug-ins do."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

_LOOK_EVERY_S = 0.5
_START_S = 60.0
"""So long may a new interpreter take on a machine that is busy, before what it runs is timed."""


class StepWatch:
    """Calls `on_overdue` once where an answer that is waited for takes longer than the limit.

    Attributes:
        is_overdue: it did.
    """

    def __init__(self, limit_s: float, on_overdue: Callable[[], None]) -> None:
        self.is_overdue = False
        self._limit_s, self._on_overdue = limit_s, on_overdue
        self._start_s = _START_S
        self._waiting_since_s: float | None = None
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._look, name="step watch", daemon=True)
        self._thread.start()

    def begin(self) -> None:
        """An answer is waited for from now on; the first one comes once Python has started."""
        self._waiting_since_s = time.monotonic() + self._start_s
        self._start_s = 0.0

    def pause(self) -> None:
        """It has come."""
        self._waiting_since_s = None

    def end(self) -> None:
        """Nothing is waited for any more."""
        self._ended.set()
        self._thread.join()

    def _look(self) -> None:
        while not self._ended.wait(min(_LOOK_EVERY_S, self._limit_s)):
            since_s = self._waiting_since_s
            if since_s is not None and time.monotonic() - since_s > self._limit_s:
                self.is_overdue = True
                self._on_overdue()
                return
