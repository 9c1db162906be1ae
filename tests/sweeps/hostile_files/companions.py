"""Folders beside a session, and journals in them, that came with it from elsewhere."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

from tests.sweeps.hostile_files.case import (
    EITHER,
    EXPORT,
    HIDDEN,
    RESTORE,
    Case,
    Make,
    cases,
    fresh,
    linked,
    no_files,
    piped,
    text,
)

_JOURNAL, _OLDER = f"{HIDDEN}/journal.sqlite", f"{HIDDEN}/s.1.h5"
_COLUMNS = (
    "number, act, edit, time, author, kind, text, frame, before, after, undoes, scope, checksum"
)
_ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)"


def _up_to(count: int, first: int = 1) -> str:
    step = f"SELECT i + 1 FROM n WHERE i < {count}"
    return f"WITH RECURSIVE n(i) AS (SELECT {first} UNION ALL {step})"


def _sql(*statements: str, whole: bool = True) -> Make:
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


def _fill(folder: str, count: int) -> Make:
    def make(work: Path) -> None:
        for number in range(count):
            (work / folder / f"s.{number + 2}.h5").touch()

    return make


def _damaged_goes_to_a_link(work: Path) -> None:
    text("s.h5", "no session")(work)
    linked(f"{HIDDEN}/damaged-1.h5", "E/victim.txt")(work)


_FOLDERS = (
    *no_files("lock", "waiting", f"{HIDDEN}/lock", EXPORT, EITHER),
    *no_files("journal", "waiting", _JOURNAL, EXPORT, EITHER),
    *no_files("wal", "waiting", f"{_JOURNAL}-wal", EXPORT, EITHER),
    *no_files("shm", "waiting", f"{_JOURNAL}-shm", EXPORT, EITHER),
    *no_files("rollback", "waiting", f"{_JOURNAL}-journal", EXPORT, EITHER),
    *no_files("leftover", "older", f"{HIDDEN}/saving-a.h5", EXPORT, EITHER),
    *no_files("older save", "older", _OLDER, RESTORE),
    *cases(
        "session",
        EXPORT,
        {
            "companions: a link to a folder": linked(HIDDEN, "E/folder"),
            "companions: a link to /": linked(HIDDEN, "/"),
            "companions: a link to nothing": linked(HIDDEN, "E/made"),
            "companions: a file": text(HIDDEN, "x"),
            "companions: a pipe": piped(HIDDEN),
        },
        EITHER,
    ),
    *cases(
        "older",
        RESTORE,
        {
            "older saves: 3,000 empty ones": _fill(HIDDEN, 3000),
            "what is damaged goes to a link": _damaged_goes_to_a_link,
        },
        EITHER,
    ),
)
_JOURNALS = {
    "steps: an endless view": _sql(
        "DROP TABLE steps", f"CREATE VIEW steps AS {_ENDLESS} SELECT i FROM n"
    ),
    "steps: an endless view of all columns": _sql(
        "DROP TABLE steps",
        f"CREATE VIEW steps({_COLUMNS}) AS {_ENDLESS} "
        "SELECT i, 'apply', i, '', '', '', '', 0, '', '', 0, '', '' FROM n",
    ),
    "a trigger that fills the disk": _sql(
        "CREATE TABLE junk(x)",
        "CREATE TRIGGER t AFTER DELETE ON origin BEGIN INSERT INTO junk "
        f"{_up_to(300)} SELECT randomblob(1000000) FROM n; END",
    ),
    "a trigger that takes steps away": _sql(
        "CREATE TRIGGER t AFTER DELETE ON origin BEGIN DELETE FROM steps; END"
    ),
    "a generated column": _sql(
        "ALTER TABLE steps ADD COLUMN g AS (length(zeroblob(900000000)) + number)"
    ),
    "a column more": _sql("ALTER TABLE steps ADD COLUMN more TEXT"),
    "steps: a search index": _sql(
        "DROP TABLE steps", f"CREATE VIRTUAL TABLE steps USING fts5({_COLUMNS})"
    ),
    "an index on what is costly": _sql("CREATE INDEX i ON steps(length(hex(text)))"),
    "300,000 junk steps": _sql(
        f"{_up_to(300_000, 9)} INSERT INTO steps "
        "SELECT i, 'apply', i, '', '', 'x', 'x', 0, '{}', '{}', 0, '', '', '' FROM n"
    ),
    "a step of 200 MB": _sql("UPDATE steps SET after = hex(zeroblob(100000000))"),
    "a step nested endlessly": _sql(f"UPDATE steps SET after = '{'[' * 100_000}'"),
    "a step of no act": _sql("UPDATE steps SET act = 'run'"),
    "a step of a far frame": _sql("UPDATE steps SET frame = 9223372036854775807"),
    "steps from below zero": _sql("UPDATE steps SET number = -number"),
    "steps in UTF-16": _sql("PRAGMA encoding='UTF-16'", "CREATE TABLE steps(a)", whole=False),
    "a schema that is rubbish": _sql(
        "PRAGMA writable_schema=ON", "UPDATE sqlite_master SET sql = 'CREATE TABLE steps(x'"
    ),
    "a million origins": _sql(f"{_up_to(1_000_000)} INSERT INTO origin SELECT 'a', 'b' FROM n"),
    "10,000 tables": _sql(*(f"CREATE TABLE t{n}(a)" for n in range(10_000))),
    "text that begins as SQLite": text(_JOURNAL, b"SQLite format 3\0" + b"\xff" * 5000),
}
_ESCAPES = "UPDATE steps SET text = char(27) || '[31m' || char(10) || 'x', author = char(7)"
CASES: tuple[Case, ...] = (
    *_FOLDERS,
    *cases("waiting", EXPORT, _JOURNALS, EITHER),
    Case("escapes in a step", "waiting", _sql(_ESCAPES), ("log", "W/s.h5"), EITHER),
)
