"""A journal from elsewhere is a database from elsewhere: nothing in it runs, and it is told."""

from __future__ import annotations

import os
import sqlite3
import sys
from pathlib import Path

import pytest
from made_up_sessions import edit, state_of

from tracking.errors import OutputError
from tracking.session import Session, describe
from tracking.session.pending_edits import edits_wait
from tracking.session.session_writer import companions

ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT"
STEPS = """CREATE TABLE steps (
    number INTEGER PRIMARY KEY, act TEXT NOT NULL, edit INTEGER NOT NULL, time TEXT NOT NULL,
    author TEXT NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL, frame INTEGER NOT NULL,
    before TEXT NOT NULL, after TEXT NOT NULL, undoes INTEGER NOT NULL DEFAULT 0,
    scope TEXT NOT NULL DEFAULT ''{more});"""
ORIGIN = "CREATE TABLE origin (session TEXT NOT NULL, save TEXT NOT NULL{more});"
PLAIN = ORIGIN.format(more="") + STEPS.format(more="")
HOSTILE = {
    "a view in a table's place": ORIGIN.format(more="")
    + f"CREATE VIEW steps AS {ENDLESS} i AS number, '' AS act, 1 AS edit FROM n;",
    "an origin that never ends": STEPS.format(more="")
    + f"CREATE VIEW origin AS {ENDLESS} 'a' AS session, 'b' AS save FROM n;",
    "a trigger": PLAIN + "CREATE TRIGGER t AFTER INSERT ON steps BEGIN "
    "INSERT OR IGNORE INTO steps SELECT * FROM steps; END;",
    "a generated column": ORIGIN.format(more="")
    + STEPS.format(more=", fat TEXT AS (hex(zeroblob(100000000))) VIRTUAL"),
    "a check": ORIGIN.format(more="")
    + STEPS.format(more=", CHECK (length(hex(zeroblob(100000000))) > 0)"),
    "an index": PLAIN + "CREATE INDEX i ON steps(text);",
    "an index of an expression": PLAIN + "CREATE INDEX i ON steps(hex(zeroblob(1000)));",
    "a third table": PLAIN + "CREATE TABLE more (a);",
    "a default that is worked out": ORIGIN.format(
        more=", more TEXT NOT NULL DEFAULT (hex(zeroblob(100000000)))"
    )
    + STEPS.format(more=""),
    "a virtual table": PLAIN + "CREATE VIRTUAL TABLE v USING fts5(a);",
    "a table without row numbers": ORIGIN.format(more="")
    + STEPS.format(more="").replace(");", ") WITHOUT ROWID;"),
    "many views": "".join(f"CREATE VIEW v{at} AS SELECT {at};" for at in range(2000)),
}


def laid(path: Path, script: str) -> Path:
    """A journal made by a script, beside the session."""
    companions(path).mkdir(exist_ok=True)
    journal = companions(path) / "journal.sqlite"
    base = sqlite3.connect(journal)
    base.executescript(f"BEGIN; {script} COMMIT;")
    base.close()
    return journal


@pytest.fixture
def path(session: Session) -> Path:
    session.close()
    assert session.path is not None
    return session.path


def is_set_aside(path: Path, why: str) -> None:
    """The session opens, says why its journal does not count and where it is, and goes on."""
    assert edits_wait(path)
    assert describe(path)["edits_waiting_in_journal"] == 0
    again = Session.open(path)
    assert not again.read_only
    assert [why in note and "kept aside" in note for note in again.notes] == [True]
    edit(again)
    again.save()
    state = state_of(again)
    again.close()
    once_more = Session.open(path)
    assert state_of(once_more) == state
    assert [why in note and "was found damaged on" in note for note in once_more.notes] == [True]
    once_more.close()


@pytest.mark.parametrize("name", HOSTILE)
def test_a_database_that_holds_more_than_two_plain_tables_is_set_aside(
    path: Path, name: str
) -> None:
    laid(path, HOSTILE[name])
    is_set_aside(path, "no journal of edits")


def test_a_database_of_more_steps_than_any_journal_is_told_at_once(path: Path) -> None:
    journal = laid(path, PLAIN)
    base = sqlite3.connect(journal)
    base.execute("INSERT INTO origin VALUES ('a', 'b')")
    row = ("apply", 1, "", "", "swap", "", 0, "{}", "{}", 0, "")
    base.executemany(
        "INSERT INTO steps VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        ((number, *row) for number in range(1, 300_001)),
    )
    base.commit()
    base.close()
    is_set_aside(path, "more than 100000 steps")


@pytest.mark.parametrize("ending", ["", "-wal", "-shm"])
def test_a_journal_larger_than_any_is_not_read(path: Path, ending: str) -> None:
    journal = laid(path, PLAIN)
    with journal.with_name(f"{journal.name}{ending}").open("ab") as file:
        file.truncate(50 << 30)  # without a byte on the disk
    session = Session.open(path)
    assert "at most" in session.notes[0]
    assert "kept aside" in session.notes[0]
    edit(session)
    session.close(discard=True)


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
@pytest.mark.parametrize("ending", ["", "-wal", "-shm", "-journal"])
@pytest.mark.parametrize("kind", ["link", "dangling link", "pipe", "hard link"])
def test_what_is_no_file_of_its_own_is_neither_read_nor_written(
    path: Path, tmp_path: Path, ending: str, kind: str
) -> None:
    journal = laid(path, PLAIN)
    place = journal.with_name(f"{journal.name}{ending}")
    place.unlink(missing_ok=True)
    other = tmp_path / "other"
    if kind == "pipe":
        os.mkfifo(place)
    elif kind == "dangling link":
        place.symlink_to(other)
    else:
        other.write_bytes(b"somebody's own")
        place.symlink_to(other) if kind == "link" else place.hardlink_to(other)
    session = Session.open(path)
    assert "kept aside" in session.notes[0]
    edit(session)
    session.close()
    assert (
        not other.exists()
        if kind in ("pipe", "dangling link")
        else (other.read_bytes() == b"somebody's own")
    )


def test_a_rollback_journal_of_another_program_is_not_played_back(path: Path) -> None:
    journal = laid(path, PLAIN)
    journal.with_name("journal.sqlite-journal").write_bytes(
        b"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7" * 99
    )
    session = Session.open(path)
    assert "another program" in session.notes[0]
    session.close()


def test_an_edit_beyond_the_most_steps_is_refused_and_saving_makes_room(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tracking.session.journal.MOST_STEPS", 3)
    edit(session, swaps=3)
    state = state_of(session)
    with pytest.raises(OutputError, match="full; save the session"):
        edit(session)
    assert state_of(session) == state
    session.save()
    edit(session)
