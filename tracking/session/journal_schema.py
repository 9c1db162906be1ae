"""What an SQLite file must be to be taken for a journal of edits, found out with little trust.

A database can hold more than data: views, triggers, generated columns and checks run when tables
are read or written. So a journal is used only where it holds two plain tables, to the word as this
program or an older one makes them. Until that is known, SQLite may do little, and not for long.
"""

from __future__ import annotations

import re
import sqlite3
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType

from tracking.editing.log.text import LARGEST_TEXT
from tracking.errors import SessionError
from tracking.session.journal_rows import numbered

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
}
"""What a journal that an older program left behind lacks, in this order."""
_COLUMNS: Mapping[str, str] = MappingProxyType({**_STEPS, **_LATER_COLUMNS})

INSERT = f"INSERT INTO steps VALUES ({', '.join('?' * len(_COLUMNS))})"
MOST_STEPS = 100_000
"""In one journal: a person's work of months; each is made again when the session is opened."""
_LONGEST_SCHEMA = 1 << 16
"""Bytes of one line of the schema, and of a statement; ours have under a thousand."""
_LONGEST_ROW = 2 * LARGEST_TEXT + (1 << 20)
"""Bytes of a step: both sides of the largest edit, and its other words."""
FULL_BYTES = 1 << 28
"""A journal's file of this size takes no further step."""
MOST_BYTES = FULL_BYTES + _LONGEST_ROW + (1 << 25)
"""Of a file of a journal: what a last step may make of one that is almost full, with SQLite's own
pages and what its log holds before it is emptied."""
_LONGEST_CELL = LARGEST_TEXT + (1 << 10)
"""Bytes of one value that is read: one side of the largest edit."""
_LONGEST_DAMAGED_CELL = 1 << 20
"""The same where pages are damaged: a value may then claim far more than the file holds."""
_OPS_A_CALL = 50
"""Steps of SQLite's own machine from one look at the clock to the next: a few rows, as each row
may take long."""
_SCHEMA_S, _SOUND_S, _DAMAGED_S = 5.0, 60.0, 5.0
"""The longest a read may take: of the schema, of a journal's whole file from a slow disk, and of
what is left in a damaged one."""
_READING = frozenset({sqlite3.SQLITE_SELECT, sqlite3.SQLITE_READ, sqlite3.SQLITE_PRAGMA})
_WRITING = frozenset(
    {
        *(*_READING, sqlite3.SQLITE_FUNCTION, sqlite3.SQLITE_TRANSACTION),
        *(sqlite3.SQLITE_INSERT, sqlite3.SQLITE_UPDATE, sqlite3.SQLITE_DELETE),
        *(sqlite3.SQLITE_CREATE_TABLE, sqlite3.SQLITE_ALTER_TABLE),
    }
)


def open_checked(base: sqlite3.Connection, path: Path) -> str:
    """See that a database is a journal or empty, and make an empty or older one a present one.

    Returns:
        What is wrong with the file's pages; "" where they are sound.

    Raises:
        SessionError: it is another database, or has more steps than any journal.
        sqlite3.Error: what SQLite says of a file that is damaged or cannot be read or written.
    """
    _restrict(base)
    lines = _schema_lines(base)
    lacking = _lacking(lines, path)
    base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _LONGEST_ROW)
    base.set_authorizer(_allowing(_WRITING))
    with limited_reading(base):
        problem = _pages_checked(base)
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
        if problem:
            raise SessionError(f"{path}: the journal of edits is damaged ({problem})")
        _bring_up_to_date(base, lacking)
    return problem


@contextmanager
def limited_reading(base: sqlite3.Connection, *, damaged: bool = False) -> Iterator[None]:
    """Have SQLite give up what is read inside where it takes too long or a value is too large.

    damaged: the file's pages are, so that its values may claim more than there is.
    """
    longest = _LONGEST_DAMAGED_CELL if damaged else _LONGEST_CELL
    before = base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, longest)
    try:
        with _deadline(base, _DAMAGED_S if damaged else _SOUND_S):
            yield
    finally:
        base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, before)


def _schema_lines(base: sqlite3.Connection) -> list[tuple[object, ...]]:
    with _deadline(base, _SCHEMA_S):
        return base.execute("SELECT type, name, sql FROM sqlite_schema LIMIT 3").fetchall()


def _restrict(base: sqlite3.Connection) -> None:
    # A flipped bit may leave text that is no UTF-8: its checksum tells, not an error.
    base.text_factory = lambda text: text.decode("utf-8", "surrogateescape")
    base.set_authorizer(_allowing(_READING))
    base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _LONGEST_SCHEMA)
    base.setlimit(sqlite3.SQLITE_LIMIT_SQL_LENGTH, _LONGEST_SCHEMA)
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
    raise SessionError(f"{path}: this is no journal of edits (it holds other tables than one)")


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
    for session, save in base.execute("SELECT session, save FROM origin LIMIT 1").fetchall():
        rows = base.execute("SELECT * FROM steps ORDER BY number").fetchall()
        base.execute("DELETE FROM steps")
        try:
            base.executemany(INSERT, numbered(rows, session, save))
        except UnicodeError as why:
            raise SessionError("the journal of edits is damaged (its text is no UTF-8)") from why
    base.execute("COMMIT")


def _check_count(base: sqlite3.Connection, path: Path) -> None:
    further = base.execute("SELECT 1 FROM steps LIMIT 1 OFFSET ?", (MOST_STEPS,)).fetchone()
    if further is not None:
        raise SessionError(
            f"{path}: this is no journal of edits (it has more than {MOST_STEPS} steps)"
        )


def _pages_checked(base: sqlite3.Connection) -> str:
    found = str(base.execute("PRAGMA quick_check(1)").fetchone()[0])
    return "" if found == "ok" else " ".join(found.split())[:200]


@contextmanager
def _deadline(base: sqlite3.Connection, seconds: float) -> Iterator[None]:
    """Have SQLite give up a statement inside that still runs after so long."""
    end_s = time.monotonic() + seconds
    base.set_progress_handler(lambda: int(time.monotonic() > end_s), _OPS_A_CALL)
    try:
        yield
    finally:
        base.set_progress_handler(None, 0)


def _allowing(actions: frozenset[int]) -> Callable[..., int]:
    def decide(action: int, *_: object) -> int:
        return sqlite3.SQLITE_OK if action in actions else sqlite3.SQLITE_DENY

    return decide
