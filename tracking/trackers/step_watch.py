"""Whoever runs a tracker of a plug-in does not wait for it for ever."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TypeVar

from tracking.plugins.time_limit import overdue
from tracking.trackers.catalogue import TRACKERS, tracker_named

T = TypeVar("T")
_AGAIN_S = 1.0
"""Code that swallows the first error gets another one so soon."""


@contextmanager
def limited_steps(tracker: str) -> Iterator[Callable[[Callable[[], T]], T]]:
    """What calls each step of a tracker, and ends one of a plug-in that takes too long.

    Such a step raises PluginError. Nothing is watched of what is built in, outside of the main
    thread, and where the system has no such timer.
    """
    offer = TRACKERS.offer(tracker)
    main = threading.current_thread() is threading.main_thread()
    if offer is None or offer.built_in or not main or not hasattr(signal, "setitimer"):
        yield lambda step: step()
        return
    limit_s = tracker_named(tracker).step_limit_s

    def ring(_number: int, _frame: FrameType | None) -> None:
        raise overdue(offer, limit_s)

    def call(step: Callable[[], T]) -> T:
        signal.setitimer(signal.ITIMER_REAL, limit_s, _AGAIN_S)
        try:
            return step()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)

    before = signal.signal(signal.SIGALRM, ring)
    try:
        yield call
    finally:
        signal.signal(signal.SIGALRM, before)
