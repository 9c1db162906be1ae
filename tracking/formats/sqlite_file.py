"""SQLite files from elsewhere: read as they lie there, and nothing in them is run."""

from __future__ import annotations

import sqlite3
from collections.abc import Collection, Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from urllib.parse import quote

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError, explain_unreadable
from tracking.formats.label_text import line
from tracking.formats.read_result import Reading
from tracking.translation import msg

SIGNATURE = b"SQLite format 3\0"
MOST_BYTES = 16 << 30

_ROWS_AT_ONCE = 1 << 16
_LEAST_ROW_BYTES = 4
"""A row of a table takes more; a file whose pages are in a ring has more rows than bytes."""
_LIMITS = {
    sqlite3.SQLITE_LIMIT_LENGTH: 1 << 20,
    sqlite3.SQLITE_LIMIT_SQL_LENGTH: 1 << 16,
    sqlite3.SQLITE_LIMIT_COLUMN: 100,
    sqlite3.SQLITE_LIMIT_EXPR_DEPTH: 20,
    sqlite3.SQLITE_LIMIT_ATTACHED: 0,
    sqlite3.SQLITE_LIMIT_TRIGGER_DEPTH: 1,
    sqlite3.SQLITE_LIMIT_WORKER_THREADS: 0,
}
_DEFENCES = (
    "PRAGMA trusted_schema = OFF",
    "PRAGMA cell_size_check = ON",
    "PRAGMA mmap_size = 0",
    "PRAGMA query_only = ON",
)
_MOST_THINGS = 1000
"""Tables, indexes and so on; a file of tracks has ten."""


@contextmanager
def opened(path: Path, tables: Collection[str]) -> Iterator[sqlite3.Connection]:
    """A file whose given tables can be read, and nothing else done.

    Raises FormatError where the file is missing, too large, none of SQLite's or damaged, also
    while it is read; where a table is missing, or is a view or a virtual table.
    """
    with explain_unreadable(path):
        size = path.stat().st_size
        with path.open("rb") as stream:
            if stream.read(len(SIGNATURE)) != SIGNATURE:
                raise FormatError(
                    "{path} is not an SQLite file; choose one of JuPedSim's", path=path
                )
    if size > MOST_BYTES:
        raise FormatError(
            "{path} is larger than {size} GB; split it first", path=path, size=MOST_BYTES >> 30
        )
    where = f"file:{quote(str(path.resolve()))}?mode=ro&immutable=1"
    try:
        with closing(sqlite3.connect(where, uri=True, isolation_level=None)) as database:
            _defend(database, tables)
            _check_tables(path, database, tables)
            yield database
    except (sqlite3.Error, OverflowError, UnicodeError) as error:
        raise FormatError(
            "{path} is damaged ({line}); export it again", path=path, line=line(error)
        ) from error


def numbers_of(
    database: sqlite3.Connection, reading: Reading, table: str, columns: tuple[str, ...]
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """(n, k) columns of a table, NaN where nothing stands, and (n,) which row each is, from 0.

    A row with something else than numbers is told as bad. Raises FormatError where there are more
    rows than the file can hold, and what `opened` turns into one.
    """
    most = reading.path.stat().st_size // _LEAST_ROW_BYTES
    found = database.execute(f"SELECT {', '.join(columns)} FROM {table} NOT INDEXED")
    parts: list[NDArray[np.float64]] = []
    places: list[NDArray[np.int64]] = []
    count = 0
    while rows := found.fetchmany(_ROWS_AT_ONCE):
        good = _table(rows)
        kept = np.arange(count, count + len(rows))
        if good is None:
            is_good = np.array([_table([row]) is not None for row in rows])
            for row in kept[~is_good].tolist():
                reading.bad(
                    msg("row {row} of {table}", row=row, table=table),
                    msg("a value is not a number"),
                )
            good = _table([row for row, fine in zip(rows, is_good, strict=True) if fine])
            kept = kept[is_good]
        assert good is not None
        parts.append(good.reshape(-1, len(columns)))
        places.append(kept)
        count += len(rows)
        reading.good += len(kept)
        reading.report(min(count, most), most)
        if count > most:
            raise FormatError(
                "{path} is damaged: {table} has no end; export it again",
                path=reading.path,
                table=table,
            )
    if not parts:
        return np.zeros((0, len(columns))), np.zeros(0, np.int64)
    return np.concatenate(parts), np.concatenate(places)


def _table(rows: list[tuple[object, ...]]) -> NDArray[np.float64] | None:
    """The rows as numbers; None where some are none."""
    try:
        return np.array(rows, np.float64)
    except (ValueError, TypeError):
        return None


def _defend(database: sqlite3.Connection, tables: Collection[str]) -> None:
    for limit, most in _LIMITS.items():
        database.setlimit(limit, most)
    for statement in _DEFENCES:
        database.execute(statement).fetchall()
    readable = {*tables, "sqlite_master", "sqlite_schema"}

    def may(action: int, first: str | None, second: str | None, *_: object) -> int:
        if action == sqlite3.SQLITE_SELECT or (action == sqlite3.SQLITE_READ and first in readable):
            return sqlite3.SQLITE_OK
        if action == sqlite3.SQLITE_PRAGMA and first == "table_xinfo" and second in tables:
            return sqlite3.SQLITE_OK
        return sqlite3.SQLITE_DENY

    database.set_authorizer(may)


def _check_tables(path: Path, database: sqlite3.Connection, tables: Collection[str]) -> None:
    things = database.execute("SELECT type, name, sql FROM sqlite_master").fetchmany(_MOST_THINGS)
    for table in tables:
        said = [str(sql) for kind, name, sql in things if (kind, name) == ("table", table)]
        if not said or said[0].upper().lstrip().startswith("CREATE VIRTUAL"):
            raise FormatError(
                "{path} has no table {table}; choose a file of JuPedSim's", path=path, table=table
            )
        columns = database.execute(f"PRAGMA table_xinfo({table})").fetchmany(_MOST_THINGS)
        if any(hidden for *_, hidden in columns):
            raise FormatError(
                "{path} computes columns of {table} when they are read; export anew",
                path=path,
                table=table,
            )
