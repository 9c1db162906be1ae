"""Edits on disk before they are acknowledged: an SQLite journal beside the session."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from tracking.editing import Entry, Scope
from tracking.errors import EditError, OutputError, SessionError
from tracking.session.lock import identity

Act = Literal["apply", "undo", "redo"]
_TABLES = """
BEGIN;
CREATE TABLE IF NOT EXISTS origin (session TEXT NOT NULL, save TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS steps (
    number INTEGER PRIMARY KEY, act TEXT NOT NULL, edit INTEGER NOT NULL, time TEXT NOT NULL,
    author TEXT NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL, frame INTEGER NOT NULL,
    before TEXT NOT NULL, after TEXT NOT NULL, undoes INTEGER NOT NULL DEFAULT 0,
    scope TEXT NOT NULL DEFAULT '');
COMMIT;
"""
_CHECKPOINT_PAGES = 8192
"""Of 4 KiB: an edit that comes upon it waits for the disk once more, so it shall be seldom."""
_LATER_COLUMNS = {"undoes": "INTEGER NOT NULL DEFAULT 0", "scope": "TEXT NOT NULL DEFAULT ''"}
"""What a journal that an older program left behind lacks, in this order."""
_STEP_TYPES = (int, str, int, str, str, str, str, int, str, str, int, str)


@dataclass(frozen=True, slots=True)
class Step:
    """One line of the journal.

    Attributes:
        number: from 1, counted since the save the journal builds on.
        act: what was done: an edit applied, or one undone or redone.
        entry: the edit; for undo and redo only its id counts.
    """

    number: int
    act: Act
    entry: Entry


class Journal:
    """The steps since the save it builds on, in order. One connection, one program."""

    def __init__(self, path: Path) -> None:
        """Open or make it. Raises OutputError where that fails, SessionError where it is none."""
        self._path = path
        with _telling(path, "opened"):
            self._base = sqlite3.connect(path, isolation_level=None, check_same_thread=False)
            self._base.execute("PRAGMA journal_mode=WAL")
            self._base.execute("PRAGMA synchronous=FULL")
            self._base.execute(f"PRAGMA wal_autocheckpoint={_CHECKPOINT_PAGES}")
            self._base.executescript(_TABLES)
            self._bring_up_to_date()
            last = self._base.execute("SELECT max(number) FROM steps").fetchone()[0]
            origin = self._base.execute("SELECT session, save FROM origin").fetchone()
            self._file = identity(path)
        self._last = int(last or 0)
        self._origin = None if origin is None else (str(origin[0]), str(origin[1]))

    def _bring_up_to_date(self) -> None:
        known = [row[1] for row in self._base.execute("PRAGMA table_info(steps)")]
        for name, kind in _LATER_COLUMNS.items():
            if name not in known:
                self._base.execute(f"ALTER TABLE steps ADD COLUMN {name} {kind}")

    @classmethod
    def begun(cls, path: Path, session: str, save: str) -> Journal:
        """A new one that builds on this save, ready to be written to. Raises as opening does."""
        journal = cls(path)
        try:
            journal.start_over(session, save)
        except (OutputError, SessionError):
            journal.close()
            raise
        return journal

    @property
    def last(self) -> int:
        """The number of the last step; 0 where there is none."""
        return self._last

    @property
    def origin(self) -> tuple[str, str] | None:
        """The session and the save it builds on; None for a new journal."""
        return self._origin

    @property
    def is_in_place(self) -> bool:
        """Whether the file it writes to still is the one at its path."""
        return identity(self._path) == self._file

    def continues(self, other: Journal) -> bool:
        """Whether this is the other one's file opened anew, with all steps it said it wrote.

        A further step, of which the other said that it failed, is taken out.
        """
        if self._origin != other._origin or not other._last <= self._last <= other._last + 1:
            return False
        with _telling(self._path, "written"):
            self._base.execute("DELETE FROM steps WHERE number > ?", (other._last,))
        self._last = other._last
        return True

    def steps(self) -> Iterator[Step]:
        """All steps in order. Raises SessionError where a line is not what it should be."""
        with _telling(self._path, "read"):
            rows = self._base.execute("SELECT * FROM steps ORDER BY number").fetchall()
        for row in rows:
            number, act, *said, undoes, scope = row
            types = tuple(type(value) for value in row)
            if types != _STEP_TYPES or act not in ("apply", "undo", "redo"):
                raise SessionError(f"{self._path}: a step of the journal is damaged")
            entry = replace(Entry(*said), undoes=undoes, scope=self._scope(scope))
            yield Step(number, act, entry)

    def _scope(self, text: str) -> Scope | None:
        try:
            return Scope.of_text(text)
        except EditError as why:
            raise SessionError(f"{self._path}: a step of the journal is damaged: {why}") from why

    def append(self, act: Act, entry: Entry) -> None:
        """Write a step; it is on disk when this returns. Raises OutputError where it is not."""
        applied = act == "apply"
        row = (
            *(self._last + 1, act, entry.id, entry.time, entry.author, entry.kind),
            *(entry.text, entry.frame),
            *((entry.before, entry.after) if applied else ("", "")),
            *(entry.undoes, entry.scope.as_text if entry.scope else ""),
        )
        marks = ", ".join("?" * len(row))
        with _telling(self._path, "written"):
            # Replace: a step that failed may be on disk all the same; it was never acknowledged.
            self._base.execute(f"INSERT OR REPLACE INTO steps VALUES ({marks})", row)
        self._last += 1

    def start_over(self, session: str, save: str, included: int = 0) -> None:
        """Build on another save, which has taken in the steps up to this number."""
        with _telling(self._path, "written"):
            with self._base:  # commits, or rolls back where a line fails
                self._base.execute("BEGIN IMMEDIATE")
                self._base.execute("DELETE FROM steps WHERE number <= ?", (included,))
                self._base.execute("UPDATE steps SET number = number - ?", (included,))
                self._base.execute("DELETE FROM origin")
                self._base.execute("INSERT INTO origin VALUES (?, ?)", (session, save))
            self._base.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        self._last, self._origin = max(0, self._last - included), (session, save)

    def close(self) -> None:
        """Let go of the file."""
        with contextlib.suppress(sqlite3.Error):  # its disk may be gone; what it holds, it holds
            self._base.close()


@contextmanager
def _telling(path: Path, what: str) -> Iterator[None]:
    try:
        yield
    except (sqlite3.OperationalError, OSError) as why:
        raise OutputError(
            f"{path}: the journal of edits cannot be {what} ({why}); "
            "make room or choose a folder you may write to"
        ) from why
    except sqlite3.DatabaseError as why:
        raise SessionError(f"{path}: this is no journal of edits ({why})") from why
