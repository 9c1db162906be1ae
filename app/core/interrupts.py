"""Interrupts while the program starts and nothing can be lost yet."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager

INTERRUPTED = 130
_NUMBERS = (signal.SIGINT, signal.SIGTERM)
STOPPED = "interrupted; nothing half-done was kept"


@contextmanager
def ending_at_once() -> Iterator[None]:
    """SIGINT and SIGTERM end the process at once, with one line and the status of an interrupt.

    For imports: a KeyboardInterrupt within a compiled module becomes some other error, or a crash.
    """
    before = [(number, signal.getsignal(number)) for number in _NUMBERS]
    end_at_once()
    try:
        yield
    finally:
        for number, handler in before:
            signal.signal(number, handler)


def end_at_once() -> None:
    """The same from now on: at the end of the program."""
    for number in _NUMBERS:
        signal.signal(number, _end)


def _end(*_: object) -> None:
    try:
        if sys.__stderr__ is not None:  # else its number may be that of a file
            os.write(sys.__stderr__.fileno(), f"trackwright: {STOPPED}\n".encode())
    except (OSError, ValueError):  # nobody reads it any more
        pass
    finally:
        os._exit(INTERRUPTED)
