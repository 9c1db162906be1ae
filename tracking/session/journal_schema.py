"""What an SQLite file must be to be taken for a journal of edits, found out with little trust.

A database can hold more than data: views, triggers, generated columns and checks run when tables
are read or written. So a journal is used only where it holds two plain tables, to the word as this
program or an older one makes them. Until that is known, SQLite may do little, and not for long.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import sqlite3
import sys
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from tracking.errors import SessionError
from tracking.owned_files import open_file
from tracking.session.journal_faults import is_of_the_disk
from tracking.session.journal_limits import (
    LONGEST_OLD_CELL,
    LONGEST_ROW,
    LONGEST_SCHEMA,
    MOST_BYTES,
    MOST_STEPS,
    PROCESSOR_S,
    TimeLimit,
)
from tracking.session.journal_rows import COLUMNS, first_checksum, row_checksum

_ORIGIN = {"session": "TEXT NOT NULL", "save": "TEXT NOT NULL"}
_STEPS = {
    "number": "INTEGER PRIMARY KEY",
    "act": "TEXT NOT NULL",
    "edit": "INTEGER NOT NULL",
    "time": "TEXT NOT NULL",
    "author": "TEXT NOT NULL",
    "kind": "TEXT NOT NULL",
    "text": "TEXT NOT NULL",
    "frame": "INTEGER NOT NULL",
    "before": "TEXT NOT NULL",
    "after": "TEXT NOT NULL",
}
_LATER_COLUMNS = {
    "undoes": "INTEGER NOT NULL DEFAULT 0",
    "scope": "TEXT NOT NULL DEFAULT ''",
    "checksum": "TEXT NOT NULL DEFAULT ''",
    "message": "TEXT NOT NULL DEFAULT ''",
}
"""What a journal that an older program left behind lacks, in this order."""
_COLUMNS: Mapping[str, str] = MappingProxyType({**_STEPS, **_LATER_COLUMNS})

SELECT = f"SELECT {', '.join(COLUMNS)} FROM steps"
INSERT = f"INSERT INTO steps ({', '.join(COLUMNS)}) VALUES ({', '.join('?' * len(COLUMNS))})"
_READ_BYTES = 1 << 20
_READING = frozenset({sqlite3.SQLITE_SELECT, sqlite3.SQLITE_READ, sqlite3.SQLITE_PRAGMA})
_WRITING = frozenset(
    {
        *(*_READING, sqlite3.SQLITE_FUNCTION, sqlite3.SQLITE_TRANSACTION),
        *(sqlite3.SQLITE_INSERT, sqlite3.SQLITE_UPDATE, sqlite3.SQLITE_DELETE),
        *(sqlite3.SQLITE_CREATE_TABLE, sqlite3.SQLITE_ALTER_TABLE),
    }
)


def open_checked(base: sqlite3.Connection, path: Path, limit: TimeLimit) -> str:
    """See that a database is a journal or empty, and make an empty or older one a present one.

    limit: how long reading it may take in all.

    Returns:
        What is wrong with the file's pages; "" where they are sound.

    Raises:
        SessionError: it is another database, or has more steps than any journal.
        sqlite3.Error: what SQLite says of a file that is damaged or cannot be read or written.
        OSError: the disk fails, or reading takes too long.
    """
    lines, lacking = check_schema(base, path, limit)
    base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LONGEST_ROW)
    base.set_authorizer(_allowing(_WRITING))
    with limit.enforce(base):
        problem = _pages_checked(base, path)
        if lines and not problem:  # what is left of a damaged one is read up to its limits
            _check_count(base, path)
    if not lines:
        # Otherwise SQLite would write a rollback journal beside the file, for nothing.
        base.execute("PRAGMA journal_mode=MEMORY")
    base.execute("PRAGMA journal_mode=WAL")
    base.execute("PRAGMA synchronous=FULL")
    if not lines:
        _make_tables(base)
    elif lacking:
        if problem and "checksum" in lacking:
            raise SessionError(
                "{path}: the journal of edits is damaged ({problem})", path=path, problem=problem
            )
        with limit.enforce(base, LONGEST_OLD_CELL):
            _bring_up_to_date(base, lacking)
    return problem


def check_schema(
    base: sqlite3.Connection, path: Path, limit: TimeLimit
) -> tuple[list[tuple[object, ...]], list[str]]:
    """The lines of a database's schema, and the columns that it lacks as a journal of now.

    From here on SQLite may only read. Raises as `open_checked`.
    """
    _restrict(base)
    with limit.enforce(base, LONGEST_SCHEMA, damaged=True):
        lines = base.execute("SELECT type, name, sql FROM sqlite_schema LIMIT 3").fetchall()
    return lines, _lacking(lines, path)


def _restrict(base: sqlite3.Connection) -> None:
    # A flipped bit may leave text that is no UTF-8: its checksum tells, not an error.
    base.text_factory = lambda text: text.decode("utf-8", "surrogateescape")
    base.set_authorizer(_allowing(_READING))
    base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LONGEST_SCHEMA)
    base.setlimit(sqlite3.SQLITE_LIMIT_SQL_LENGTH, LONGEST_SCHEMA)
    base.setlimit(sqlite3.SQLITE_LIMIT_ATTACHED, 0)
    base.setlimit(sqlite3.SQLITE_LIMIT_TRIGGER_DEPTH, 1)
    if sys.version_info >= (3, 12):
        base.setconfig(sqlite3.SQLITE_DBCONFIG_DEFENSIVE, True)
        base.setconfig(sqlite3.SQLITE_DBCONFIG_ENABLE_TRIGGER, False)
        base.setconfig(sqlite3.SQLITE_DBCONFIG_ENABLE_VIEW, False)
    base.execute("PRAGMA trusted_schema=OFF")
    base.execute("PRAGMA cell_size_check=ON")
    base.execute("PRAGMA mmap_size=0")


def _lacking(lines: list[tuple[object, ...]], path: Path) -> list[str]:
    """The columns that steps lack. Raises SessionError for any schema that no journal ever had."""
    if not lines:
        return []
    said = {
        (kind, name): _plain(sql) if isinstance(sql, str) else None for kind, name, sql in lines
    }
    steps = said.get(("table", "steps"))
    names = list(_LATER_COLUMNS)
    for known in range(len(names) + 1):
        columns = {**_STEPS, **{name: _LATER_COLUMNS[name] for name in names[:known]}}
        expected = {
            ("table", "origin"): _definition("origin", _ORIGIN),
            ("table", "steps"): _definition("steps", columns),
        }
        if said == expected and len(lines) == len(expected) and steps is not None:
            return names[known:]
    raise SessionError(
        "{path}: this is no journal of edits (it holds other tables than one)", path=path
    )


def _definition(table: str, columns: Mapping[str, str]) -> str:
    return _plain(
        f"CREATE TABLE {table}({', '.join(f'{name} {kind}' for name, kind in columns.items())})"
    )


def _plain(sql: str) -> str:
    """The statement without blanks that say nothing."""
    return re.sub(r" ?([(),]) ?", r"\1", " ".join(sql.split()))


def _make_tables(base: sqlite3.Connection) -> None:
    base.execute("BEGIN IMMEDIATE")
    base.execute(_definition("origin", _ORIGIN))
    base.execute(_definition("steps", _COLUMNS))
    base.execute("COMMIT")


def _bring_up_to_date(base: sqlite3.Connection, lacking: list[str]) -> None:
    """Add columns to steps an older program wrote; what they say now is what counts."""
    base.execute("BEGIN IMMEDIATE")
    for name in lacking:
        base.execute(f"ALTER TABLE steps ADD COLUMN {name} {_LATER_COLUMNS[name]}")
    if "checksum" in lacking:
        for session, save in base.execute("SELECT session, save FROM origin LIMIT 1").fetchall():
            _give_checksums(base, session, save)
    base.execute("COMMIT")


def _give_checksums(base: sqlite3.Connection, session: str, save: str) -> None:
    """Number all steps from 1 and give them checksums, one after the other."""
    before = first_checksum(session, save)
    numbers = base.execute("SELECT number FROM steps ORDER BY number").fetchall()
    update = "UPDATE steps SET number = ?, checksum = ? WHERE number = ?"
    for new, old in enumerate(numbers, 1):
        row = base.execute(f"{SELECT} WHERE number = ?", old).fetchone()
        before = row_checksum(before, (new, *row[1:-1]))
        base.execute(update, (new, before, *old))


def _check_count(base: sqlite3.Connection, path: Path) -> None:
    further = base.execute("SELECT 1 FROM steps LIMIT 1 OFFSET ?", (MOST_STEPS,)).fetchone()
    if further is not None:
        raise SessionError(
            "{path}: this is no journal of edits (it has more than {most} steps)",
            path=path,
            most=MOST_STEPS,
        )


def _pages_checked(base: sqlite3.Connection, path: Path) -> str:
    """What is wrong with the file's pages. Raises OSError where it is the disk that fails."""
    found = _quick_check(base)
    if found == "ok":
        return ""
    # SQLite says of a page that the disk did not give, too, that it is damaged.
    code = re.search(r"error code=(\d+)", found)
    if code is not None and is_of_the_disk(int(code[1])):
        raise OSError(errno.EIO, "its disk fails")
    if "failed to get page" in found:
        for file in (path, path.with_name(f"{path.name}-wal")):
            with contextlib.suppress(FileNotFoundError):
                _read_through(file)
    if _quick_check(base) == "ok":
        raise OSError(errno.EIO, "its disk failed while it was read")
    return " ".join(found.split())[:200]


def _quick_check(base: sqlite3.Connection) -> str:
    return str(base.execute("PRAGMA quick_check(1)").fetchone()[0])


def _read_through(file: Path) -> None:
    """Raise OSError where not all of a file can be read, in the time that reading may take."""
    end_s = time.monotonic() + PROCESSOR_S
    handle = open_file(file, most_bytes=MOST_BYTES)
    with os.fdopen(handle, "rb", buffering=0) as data:
        while data.read(_READ_BYTES):
            if time.monotonic() > end_s:
                raise TimeoutError(errno.ETIMEDOUT, "it takes too long")


def _allowing(actions: frozenset[int]) -> Callable[..., int]:
    def decide(action: int, *_: object) -> int:
        return sqlite3.SQLITE_OK if action in actions else sqlite3.SQLITE_DENY

    return decide
