"""How large what a journal holds may be, and how long it may be read: nothing in it is trusted."""

from __future__ import annotations

import errno
import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager

from tracking.editing.log.text import LARGEST_TEXT

MOST_STEPS = 100_000
"""In one journal: a person's work of months; each is made again when the session is opened."""
LONGEST_SCHEMA = 1 << 16
"""Bytes of one line of the schema, and of a statement; ours have under a thousand."""
LONGEST_ROW = 2 * LARGEST_TEXT + (1 << 20)
"""Bytes of a step: both sides of the largest edit, and its other words."""
FULL_BYTES = 1 << 28
"""A journal's file of this size takes no further step."""
MOST_BYTES = FULL_BYTES + LONGEST_ROW + (1 << 25)
"""Of a file of a journal: what a last step may make of one that is almost full, with SQLite's own
pages and what its log holds before it is emptied."""
MOST_COUNT_BYTES = 4096
"""Of the file that says how many steps there are: one line."""
LONGEST_NAME = 1 << 12
"""Bytes of what names a save, and of a step's checksum."""
LONGEST_CELL = LARGEST_TEXT + (1 << 10)
"""Bytes of one value that is read: one side of the largest edit."""
SMALL_CELL = 1 << 20
"""The same before anything is known of a step, and where pages are damaged, so that a value may
claim far more than the file holds."""
LONGEST_OLD_CELL = 1 << 25
"""The same in a journal of an older program, whose steps have no checksums."""
_OPS_A_CALL = 50
"""Steps of SQLite's own machine from one look at the clock to the next: a few rows, as each row
may take long."""
PROCESSOR_S, DISK_S = 5.0, 60.0
"""The longest it takes to find a journal sound, and from one sound step to the next: of a
processor's time, on which what it holds decides, and by the clock, on which its disk does."""


class TimeLimit:
    """How long a journal may be read in all, one statement after the other."""

    def __init__(self) -> None:
        """The whole time is left."""
        self._processor_s, self._disk_s = PROCESSOR_S, DISK_S  # left; until when, while it runs

    @contextmanager
    def enforce(
        self, base: sqlite3.Connection, longest: int = LONGEST_CELL, *, damaged: bool = False
    ) -> Iterator[None]:
        """Have SQLite give up what is done inside where it takes too long or a value is too large.

        Args:
            base: the database.
            longest: of a value, in bytes.
            damaged: the file is known to be: what takes too long is the damage, then.

        Raises:
            TimeoutError: it took too long, which is no damage.
        """
        before = base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, longest)
        self._add(time.thread_time(), time.monotonic())
        base.set_progress_handler(self._is_over, _OPS_A_CALL)
        try:
            yield
        except sqlite3.Error as why:
            if _is_interrupted(why) and (self._is_slow() or not damaged):
                raise TimeoutError(errno.ETIMEDOUT, "it takes too long") from why
            raise
        finally:
            base.set_progress_handler(None, 0)
            base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, before)
            self._add(-time.thread_time(), -time.monotonic())

    def renew(self) -> None:
        """While it runs: something sound was found, and the whole time is left for what follows."""
        self._processor_s, self._disk_s = PROCESSOR_S, DISK_S
        self._add(time.thread_time(), time.monotonic())

    def check(self) -> None:
        """While it runs: raise TimeoutError where it is over, as amid one large value."""
        if self._is_over():
            raise TimeoutError(errno.ETIMEDOUT, "it takes too long")

    def _add(self, processor_s: float, disk_s: float) -> None:
        self._processor_s += processor_s
        self._disk_s += disk_s

    def _is_slow(self) -> bool:
        return time.monotonic() > self._disk_s

    def _is_over(self) -> int:
        return int(self._is_slow() or time.thread_time() > self._processor_s)


def _is_interrupted(why: sqlite3.Error) -> bool:
    return getattr(why, "sqlite_errorcode", 0) == sqlite3.SQLITE_INTERRUPT
