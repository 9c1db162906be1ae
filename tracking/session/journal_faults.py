"""What goes wrong with a journal: its disk fails, or it is damaged. Only damage is kept aside."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tracking.errors import OutputError, SessionError
from tracking.translation import Message, msg

CANNOT_OPEN = msg("the journal of edits cannot be opened")
CANNOT_MAKE = msg("the journal of edits cannot be made")
CANNOT_READ = msg("the journal of edits cannot be read")
CANNOT_WRITE = msg("the journal of edits cannot be written")
_OF_THE_DISK = frozenset(
    {
        *(sqlite3.SQLITE_IOERR, sqlite3.SQLITE_FULL, sqlite3.SQLITE_CANTOPEN, sqlite3.SQLITE_PERM),
        *(sqlite3.SQLITE_READONLY, sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED),
        *(sqlite3.SQLITE_PROTOCOL, sqlite3.SQLITE_NOLFS, sqlite3.SQLITE_NOMEM),
    }
)
"""What SQLite says of disks, rights and memory; all else it says is about what the file holds."""


def is_of_the_disk(code: int) -> bool:
    """Whether SQLite's number of an error tells nothing about what the file holds."""
    return code & 0xFF in _OF_THE_DISK  # the lower byte is the kind, the others say more about it


def is_damage(why: Exception) -> bool:
    """Whether an error says that the file holds something else than a journal."""
    code = getattr(why, "sqlite_errorcode", 0)
    return isinstance(why, sqlite3.Error) and not is_of_the_disk(code)


@contextmanager
def translate_errors(path: Path, failed: Message) -> Iterator[None]:
    """Turn what SQLite and the system say about a journal into one line that begins with `failed`.

    Raises OutputError where the disk, rights, memory or time do not suffice, SessionError for
    damage.
    """
    try:
        yield
    except (sqlite3.Error, OSError, MemoryError) as why:
        if is_damage(why):
            raise SessionError(
                "{path}: this is no journal of edits ({why})", path=path, why=why
            ) from why
        said = msg("there is not enough memory") if isinstance(why, MemoryError) else why
        raise OutputError(
            "{path}: {failed} ({said}); make room or choose a folder you may write to",
            path=path,
            failed=failed,
            said=said,
        ) from why
