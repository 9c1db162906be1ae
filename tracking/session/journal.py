"""Edits on disk before they are acknowledged: an SQLite journal beside the session."""

from __future__ import annotations

import contextlib
import os
import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from tracking.editing import Entry
from tracking.errors import OutputError, SessionError
from tracking.file_lock import identity
from tracking.owned_files import check_file, open_file
from tracking.session.journal_faults import (
    CANNOT_MAKE,
    CANNOT_OPEN,
    CANNOT_READ,
    CANNOT_WRITE,
    is_damage,
    translate_errors,
)
from tracking.session.journal_limits import (
    FULL_BYTES,
    LONGEST_CELL,
    LONGEST_NAME,
    MOST_BYTES,
    MOST_STEPS,
    SMALL_CELL,
    TimeLimit,
)
from tracking.session.journal_reader import rows_in_order
from tracking.session.journal_rows import Act as Act
from tracking.session.journal_rows import (
    Contents,
    Row,
    first_checksum,
    number_rows,
    row_checksum,
    row_of,
    steps_of,
    text_bytes,
)
from tracking.session.journal_rows import Step as Step
from tracking.session.journal_schema import INSERT, SELECT, open_checked
from tracking.session.step_count import StepCount

ENDINGS = ("-wal", "-shm", "-count", "")
"""Of the names of a journal's files; the one that all others belong to is the last."""
FOREIGN_ENDING = "-journal"
"""A rollback journal: this program never makes one, and SQLite would write what it says."""
_CHECKPOINT_PAGES = 8192
"""Of 4 KiB: an edit that comes upon it waits for the disk once more, so it shall be seldom."""
_PRIVATE = 0o600


class Journal:
    """The steps since the save it builds on, in order. One connection, one program."""

    def __init__(self, path: Path, mode: int = _PRIVATE) -> None:
        """Open the one that is there, in a folder that was checked.

        mode: the permissions of new files beside it.
        Raises OutputError where that fails, SessionError where it is none.
        """
        self._path = path
        with translate_errors(path, CANNOT_OPEN):
            _check_files(path)
            self._base = sqlite3.connect(path, isolation_level=None, check_same_thread=False)
        self._count = StepCount(path.with_name(f"{path.name}-count"), mode)
        try:
            with translate_errors(path, CANNOT_OPEN):
                self._open()
        except BaseException:
            self.close()
            raise

    def _open(self) -> None:
        self._limit = TimeLimit()
        self._problem = open_checked(self._base, self._path, self._limit)
        self._base.execute(f"PRAGMA wal_autocheckpoint={_CHECKPOINT_PAGES}")
        self._failed: tuple[int, str] | None = None  # number and checksum of a step
        self._attempted: tuple[tuple[str, str], list[str]] | None = None  # origin and checksums
        with self._limited(LONGEST_NAME):
            origins = self._base.execute("SELECT session, save FROM origin LIMIT 2").fetchall()
        if len(origins) > 1 or any(not isinstance(said, str) for row in origins for said in row):
            raise SessionError(
                "{path}: this is no journal of edits (its origin is damaged)", path=self._path
            )
        self._origin: tuple[str, str] | None = origins[0] if origins else None
        self._bytes = self._used_bytes()
        self._read_numbers()
        self._file = identity(self._path)

    def _limited(self, longest: int) -> AbstractContextManager[None]:
        """What opening and reading may take in all; longest: of a value, in bytes."""
        return self._limit.enforce(self._base, longest, damaged=bool(self._problem))

    def _read_numbers(self) -> None:
        """Read the steps' numbers and checksums; of a damaged file nobody needs them."""
        self._last, self._checksums = 0, []
        if self._problem:
            return
        try:
            with self._limited(LONGEST_NAME), contextlib.closing(self._base.cursor()) as rows:
                for number, checksum in rows.execute(
                    "SELECT number, checksum FROM steps ORDER BY number"
                ):
                    self._last = int(number)
                    self._checksums.append(str(checksum))
        except sqlite3.Error as why:
            if not is_damage(why):
                raise
            self._problem = str(why)

    @property
    def _checksum(self) -> str:
        """Of the last step, which the next one follows on."""
        return self._checksums[-1] if self._checksums else self._first_checksum()

    def _first_checksum(self) -> str:
        return "" if self._origin is None else first_checksum(*self._origin)

    @classmethod
    def begun(
        cls,
        path: Path,
        session: str,
        save: str,
        mode: int = _PRIVATE,
        steps: Sequence[Step] = (),
    ) -> Journal:
        """A new one that builds on this save, with these steps, or nothing.

        Raises as opening does, and SessionError where a file has the name already.
        """
        with translate_errors(path, CANNOT_MAKE):
            _make_file(path, mode)
        journal: Journal | None = None
        try:
            journal = cls(path, mode)
            journal.start_over(session, save)
            journal._put_all(steps)
        except BaseException:
            if journal is not None:
                journal.close()
            with contextlib.suppress(OSError):  # an empty one is nothing to anybody
                for ending in ENDINGS:
                    path.with_name(f"{path.name}{ending}").unlink(missing_ok=True)
            raise
        return journal

    @property
    def last(self) -> int:
        """The number of the last step; 0 where there is none."""
        return self._last

    @property
    def may_have_steps(self) -> bool:
        """Whether it has any, or is damaged, so that only reading it can tell."""
        return bool(self._last or self._problem)

    @property
    def origin(self) -> tuple[str, str] | None:
        """The session and the save it builds on; None for a new journal."""
        return self._origin

    @property
    def is_in_place(self) -> bool:
        """Whether the file it writes to still is the one at its path."""
        return identity(self._path) == self._file

    @property
    def is_empty(self) -> bool:
        """Whether it is sound and has no step, nor ever had one on the save it builds on."""
        had = self._count.read(*self._origin) if self._origin is not None else 0
        return not (self._last or self._problem or had)

    @property
    def is_as_written(self) -> bool:
        """Whether it holds what this program wrote to it and nothing else."""
        try:
            return self._tail() in (self._expected(), self._expected(self._failed))
        except (sqlite3.Error, OSError, MemoryError):  # closed, or its disk is gone
            return False

    def continues(self, other: Journal) -> bool:
        """Whether this is the other one's file opened anew, with the steps it wrote and no others.

        It may have started over, too, where the other one could not know that it succeeded.
        A further step is taken out where it is, to the letter, the one of which the other said
        that it could not be written. False where anything else is there: another program's step.
        """
        if self._problem:
            return False
        if (self._origin, self._checksums) == other._attempted:
            return True
        if self._origin != other._origin:
            return False
        failed = other._failed
        last = other._last if failed is None else failed[0] - 1
        before = other._checksums[last - 1] if last else other._first_checksum()
        if failed is not None and self._last == last + 1:
            return self._take_out(failed, before)
        return (self._last, self._checksum) == (last, before)

    def _take_out(self, failed: tuple[int, str], before: str) -> bool:
        with translate_errors(self._path, CANNOT_WRITE), self._transaction():
            rows = self._rows_from(self._last - 1)
            kept = rows[0][-1] if len(rows) > 1 else self._first_checksum()
            if row_checksum(kept, rows[-1][:-1]) != failed[1] or kept != before:
                return False
            self._base.execute("DELETE FROM steps WHERE number = ?", (self._last,))
        self._last -= 1
        self._checksums.pop()
        self.say_count()
        return True

    def _rows_from(self, number: int) -> list[Row]:
        select = f"{SELECT} WHERE number >= ? ORDER BY number"
        with TimeLimit().enforce(self._base, LONGEST_CELL):
            return self._base.execute(select, (number,)).fetchall()

    def has_others(self, other: Journal | None) -> bool:
        """Whether it has steps that the other one, which was written to, has not; None: none was.

        True, too, where it is damaged, so that nobody can tell.
        """
        known = other is not None and self._origin == other._origin
        own = other._checksums[: len(self._checksums)] if other is not None and known else []
        return bool(self._problem) or self._checksums != own

    def contents(self) -> Contents:
        """All steps in order, up to the first that is damaged. Raises OutputError."""
        steps: list[Step] = []
        problem = ""
        try:
            with translate_errors(self._path, CANNOT_READ), self._limited(SMALL_CELL):
                first, damaged = self._first_checksum(), bool(self._problem)
                used, limit = self._used_bytes(), self._limit
                rows = rows_in_order(self._base, first, used, limit, damaged=damaged)
                steps.extend(steps_of(rows, first))
        except (ValueError, SessionError) as why:
            problem = str(why)
        return Contents(tuple(steps), problem or self._problem)

    def say_count(self) -> None:
        """Say beside it how many steps it has, as where none of them is missing."""
        if self._origin is not None:
            self._count.write(*self._origin, self._last)

    def count_acknowledged(self, session: str, save: str) -> int:
        """How many steps were written that build on this save, as the count beside it says.

        0 where it does not say.
        """
        return self._count.read(session, save)

    def append(self, act: Act, entry: Entry) -> None:
        """Write a step; it is on disk when this returns.

        Raises OutputError where it is not, SessionError where another program wrote into the file.
        """
        if self._origin is None:
            raise SessionError("{path}: this journal of edits builds on no save", path=self._path)
        if self._last >= MOST_STEPS or self._bytes > FULL_BYTES:
            raise OutputError(
                "{path}: the journal of edits is full; save the session, then go on",
                path=self._path,
            )
        row = row_of(Step(self._last + 1, act, entry), self._checksum)
        used = text_bytes(row)
        self._failed = (row[0], row[-1])  # whatever ends this before its last line
        with translate_errors(self._path, CANNOT_WRITE), self._transaction():
            self._check_tail()
            self._base.execute(INSERT, row)
        self._bytes += used
        self._count.write(*self._origin, row[0])
        self._checksums.append(row[-1])
        self._last = row[0]
        self._failed = None

    def take_back(self, last: int) -> bool:
        """Let the step after that one, which was the last, count as one that was not written.

        What was done came to nothing after all; see `continues`. False: no step was written.
        """
        if self._failed is None and self._last == last + 1:
            self._failed = (self._last, self._checksum)
        return self._failed is not None

    def start_over(self, session: str, save: str, included: int = 0) -> None:
        """Build on another save, which has taken in the steps up to this number.

        Raises OutputError where that fails, SessionError where another program wrote into the file.
        """
        if not included and self._origin == (session, save):
            return
        with translate_errors(self._path, CANNOT_WRITE), self._transaction():
            self._check_tail()
            rows = list(number_rows(self._rows_from(included + 1), session, save))
            self._attempted = (session, save), [row[-1] for row in rows]
            self._base.execute("DELETE FROM origin")
            self._base.execute("INSERT INTO origin VALUES (?, ?)", (session, save))
            self._base.execute("DELETE FROM steps")
            self._base.executemany(INSERT, rows)
        with translate_errors(self._path, CANNOT_READ):
            self._started(session, save)
        self._attempted = None

    def _put_all(self, steps: Sequence[Step]) -> None:
        """Write steps into a journal that has none, all of them or none."""
        if steps and self._origin is not None:
            rows = number_rows((row_of(step, "") for step in steps), *self._origin)
            with translate_errors(self._path, CANNOT_WRITE), self._transaction():
                self._base.executemany(INSERT, rows)
            self._started(*self._origin)

    def _started(self, session: str, save: str) -> None:
        self._origin = (session, save)
        self._limit = TimeLimit()
        self._read_numbers()
        self._count.write(session, save, self._last)
        self._bytes = self._used_bytes()
        with contextlib.suppress(sqlite3.Error):  # it only makes room
            self._base.execute("PRAGMA wal_checkpoint(TRUNCATE)")

    def _check_tail(self) -> None:
        """Raise SessionError where the file holds other steps than this program put there."""
        if self._tail() != self._expected():
            raise SessionError(
                "{path}: another program wrote into the journal of edits; nothing was changed: "
                "try again",
                path=self._path,
            )

    def _tail(self) -> tuple[object, object]:
        """What the file says it builds on, and its last step's number and checksum."""
        last = "SELECT number, checksum FROM steps ORDER BY number DESC LIMIT 1"
        with TimeLimit().enforce(self._base, LONGEST_NAME):
            origin = self._base.execute("SELECT session, save FROM origin").fetchone()
            return origin, self._base.execute(last).fetchone()

    def _expected(self, failed: tuple[int, str] | None = None) -> tuple[object, object]:
        """The tail as this program left it; failed: a step of which it cannot know."""
        if failed is not None:
            return self._origin, failed
        return self._origin, (self._last, self._checksum) if self._last else None

    @contextmanager
    def _transaction(self) -> Iterator[None]:
        self._base.execute("BEGIN IMMEDIATE")
        try:
            yield
            self._base.execute("COMMIT")
        except BaseException:
            with contextlib.suppress(sqlite3.Error):  # what failed may have ended it already
                self._base.execute("ROLLBACK")
            raise

    def _used_bytes(self) -> int:
        """How much of the file is in use, without pages that were given back."""
        names = ("page_count", "freelist_count", "page_size")
        pages, free, size = (self._base.execute(f"PRAGMA {name}").fetchone()[0] for name in names)
        return int((pages - free) * size)

    def close(self) -> None:
        """Let go of the file."""
        with contextlib.suppress(sqlite3.Error):  # its disk may be gone; what it holds, it holds
            self._base.close()
        self._count.close()


def _check_files(path: Path) -> None:
    """Refuse files that are not the user's own, or too large, and a log without what it is of."""
    log, _ = (check_file(path.with_name(f"{path.name}{e}"), MOST_BYTES) for e in ("-wal", "-shm"))
    foreign = path.with_name(f"{path.name}{FOREIGN_ENDING}")
    if check_file(foreign) is not None:
        raise SessionError(
            "{foreign}: this is of another program; it is not a journal of edits", foreign=foreign
        )
    state = check_file(path, MOST_BYTES)
    if state is None or (not state.st_size and log is not None and log.st_size):
        # SQLite would begin a new one, and take the log away.
        raise SessionError(
            "{path}: the journal of edits is gone; its log or count is still there", path=path
        )


def _make_file(path: Path, mode: int) -> None:
    """Make an empty file, and nothing where one has the name."""
    try:
        os.close(open_file(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, mode))
    except FileExistsError as why:
        raise SessionError(
            "{path}: another program has begun a journal of edits; nothing was changed: try again",
            path=path,
        ) from why
