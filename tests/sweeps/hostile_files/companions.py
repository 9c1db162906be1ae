"""Folders beside a session, and journals in them, that came with it from elsewhere."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

from tests.sweeps.hostile_files.case import (
    EXPORT,
    HIDDEN,
    RESTORE,
    Case,
    foldered,
    fresh,
    hard_linked,
    linked,
    piped,
    sparse,
    text,
)

_LOCK, _JOURNAL, _OLDER = f"{HIDDEN}/lock", f"{HIDDEN}/journal.sqlite", f"{HIDDEN}/s.1.h5"
_ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i FROM n"
_COLUMNS = (
    "number, act, edit, time, author, kind, text, frame, before, after, undoes, scope, checksum"
)


def _replaced(file: str, target: str) -> Callable[[Path], None]:
    """The whole companion folder becomes a link."""
    return linked(file, target)


def _sql(*statements: str, whole: bool = True) -> Callable[[Path], None]:
    """Statements done to the journal; not whole: to an empty one."""

    def make(work: Path) -> None:
        for ending in ("-wal", "-shm") if not whole else ():
            (work / f"{_JOURNAL}{ending}").unlink(missing_ok=True)
        if not whole:
            fresh(work / _JOURNAL)
        with closing(sqlite3.connect(work / _JOURNAL, isolation_level=None)) as base:
            base.execute("PRAGMA synchronous=OFF")
            for statement in statements:
                base.execute(statement)

    return make


def _many(count: int) -> str:
    numbers = f"WITH RECURSIVE n(i) AS (SELECT 9 UNION ALL SELECT i + 1 FROM n WHERE i < {count})"
    values = "SELECT i, 'apply', i, '', '', 'x', 'x', 0, '{}', '{}', 0, '', '' FROM n"
    return f"{numbers} INSERT INTO steps {values}"


def _fill(folder: str, count: int) -> Callable[[Path], None]:
    def make(work: Path) -> None:
        for number in range(count):
            (work / folder / f"s.{number + 2}.h5").touch()

    return make


FOLDERS = (
    Case(
        "lock: a link to a file elsewhere", "waiting", linked(_LOCK, "E/victim.txt"), EXPORT, None
    ),
    Case("lock: a link to a file to be made", "waiting", linked(_LOCK, "E/made.txt"), EXPORT, None),
    Case("lock: a pipe", "waiting", piped(_LOCK), EXPORT, None),
    Case("lock: a folder", "waiting", foldered(_LOCK), EXPORT, None),
    Case("lock: a second name", "waiting", hard_linked(_LOCK, "victim.txt"), EXPORT, None),
    Case("lock: a device", "waiting", linked(_LOCK, "/dev/zero"), EXPORT, None),
    Case("lock: a gibibyte of nothing", "waiting", sparse(_LOCK, 1 << 30), EXPORT, None),
    Case("journal: a link", "waiting", linked(_JOURNAL, "E/victim.sqlite"), EXPORT, None),
    Case("journal: a device", "waiting", linked(_JOURNAL, "/dev/zero"), EXPORT, None),
    Case("journal: a pipe", "waiting", piped(_JOURNAL), EXPORT, None),
    Case("journal: a second name", "waiting", hard_linked(_JOURNAL, "victim.sqlite"), EXPORT, None),
    Case("journal: a folder", "waiting", foldered(_JOURNAL), EXPORT, None),
    Case("journal: 20 GiB of nothing", "waiting", sparse(_JOURNAL, 20 << 30), EXPORT, None),
    Case("wal: a link", "waiting", linked(f"{_JOURNAL}-wal", "E/victim.txt"), EXPORT, None),
    Case("wal: a pipe", "waiting", piped(f"{_JOURNAL}-wal"), EXPORT, None),
    Case("wal: 20 GiB of nothing", "waiting", sparse(f"{_JOURNAL}-wal", 20 << 30), EXPORT, None),
    Case("shm: a link", "waiting", linked(f"{_JOURNAL}-shm", "E/victim.txt"), EXPORT, None),
    Case(
        "rollback: a link", "waiting", linked(f"{_JOURNAL}-journal", "E/victim.txt"), EXPORT, None
    ),
    Case("companions: a link to a folder", "session", _replaced(HIDDEN, "E/folder"), EXPORT, None),
    Case("companions: a link to /", "session", _replaced(HIDDEN, "/"), EXPORT, None),
    Case("companions: a link to nothing", "session", _replaced(HIDDEN, "E/made"), EXPORT, None),
    Case("companions: a file", "session", text(HIDDEN, "x"), EXPORT, None),
    Case("companions: a pipe", "session", piped(HIDDEN), EXPORT, None),
    Case(
        "leftover: a link", "older", linked(f"{HIDDEN}/saving-a.h5", "E/victim.txt"), EXPORT, None
    ),
    Case("leftover: a folder", "older", foldered(f"{HIDDEN}/saving-a.h5"), EXPORT, None),
    Case("older save: a link", "older", linked(_OLDER, "E/victim.txt"), RESTORE, 1),
    Case("older save: a device", "older", linked(_OLDER, "/dev/zero"), RESTORE, 1),
    Case("older save: a pipe", "older", piped(_OLDER), RESTORE, 1),
    Case("older save: a folder", "older", foldered(_OLDER), RESTORE, 1),
    Case("older saves: 3,000 empty ones", "older", _fill(HIDDEN, 3000), RESTORE, None),
    Case(
        "what is damaged goes to a link",
        "older",
        lambda work: [
            text("s.h5", "no session")(work),
            linked(f"{HIDDEN}/damaged-1.h5", "E/victim.txt")(work),
        ],
        RESTORE,
        None,
    ),
)

JOURNALS = (
    Case(
        "steps: an endless view",
        "waiting",
        _sql("DROP TABLE steps", f"CREATE VIEW steps AS {_ENDLESS}"),
        EXPORT,
        None,
    ),
    Case(
        "steps: an endless view of all columns",
        "waiting",
        _sql(
            "DROP TABLE steps",
            f"CREATE VIEW steps({_COLUMNS}) AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL "
            "SELECT i + 1 FROM n) "
            "SELECT i, 'apply', i, '', '', '', '', 0, '', '', 0, '', '' FROM n",
        ),
        EXPORT,
        None,
    ),
    Case(
        "a trigger that fills the disk",
        "waiting",
        _sql(
            "CREATE TABLE junk(x)",
            "CREATE TRIGGER t AFTER DELETE ON origin BEGIN INSERT INTO junk "
            "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 300) "
            "SELECT randomblob(1000000) FROM n; END",
        ),
        EXPORT,
        None,
    ),
    Case(
        "a trigger that takes steps away",
        "waiting",
        _sql("CREATE TRIGGER t AFTER DELETE ON origin BEGIN DELETE FROM steps; END"),
        EXPORT,
        None,
    ),
    Case(
        "a generated column",
        "waiting",
        _sql("ALTER TABLE steps ADD COLUMN g AS (length(zeroblob(900000000)) + number)"),
        EXPORT,
        None,
    ),
    Case("a column more", "waiting", _sql("ALTER TABLE steps ADD COLUMN more TEXT"), EXPORT, None),
    Case(
        "steps: a search index",
        "waiting",
        _sql("DROP TABLE steps", f"CREATE VIRTUAL TABLE steps USING fts5({_COLUMNS})"),
        EXPORT,
        None,
    ),
    Case(
        "an index on what is costly",
        "waiting",
        _sql("CREATE INDEX i ON steps(length(hex(text)))"),
        EXPORT,
        None,
    ),
    Case("300,000 junk steps", "waiting", _sql(_many(300_000)), EXPORT, None),
    Case(
        "a step of 200 MB",
        "waiting",
        _sql("UPDATE steps SET after = hex(zeroblob(100000000))"),
        EXPORT,
        None,
    ),
    Case(
        "a step nested endlessly",
        "waiting",
        _sql(f"UPDATE steps SET after = '{'[' * 100_000}'"),
        EXPORT,
        None,
    ),
    Case("a step of no act", "waiting", _sql("UPDATE steps SET act = 'run'"), EXPORT, None),
    Case(
        "a step of a far frame",
        "waiting",
        _sql("UPDATE steps SET frame = 9223372036854775807"),
        EXPORT,
        None,
    ),
    Case(
        "steps from below zero", "waiting", _sql("UPDATE steps SET number = -number"), EXPORT, None
    ),
    Case(
        "steps in UTF-16",
        "waiting",
        _sql("PRAGMA encoding='UTF-16'", "CREATE TABLE steps(a)", whole=False),
        EXPORT,
        None,
    ),
    Case(
        "a schema that is rubbish",
        "waiting",
        _sql("PRAGMA writable_schema=ON", "UPDATE sqlite_master SET sql = 'CREATE TABLE steps(x'"),
        EXPORT,
        None,
    ),
    Case(
        "a million origins",
        "waiting",
        _sql(
            "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000000) "
            "INSERT INTO origin SELECT 'a', 'b' FROM n"
        ),
        EXPORT,
        None,
    ),
    Case(
        "10,000 tables",
        "waiting",
        _sql(*(f"CREATE TABLE t{n}(a)" for n in range(10_000))),
        EXPORT,
        None,
    ),
    Case(
        "escapes in a step",
        "waiting",
        _sql("UPDATE steps SET text = char(27) || '[31m' || char(10) || 'x', author = char(7)"),
        ("log", "W/s.h5"),
        None,
    ),
    Case(
        "text that begins as SQLite",
        "waiting",
        text(_JOURNAL, b"SQLite format 3\0" + b"\xff" * 5000),
        EXPORT,
        None,
    ),
)
CASES = (*FOLDERS, *JOURNALS)
