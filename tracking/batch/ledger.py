"""The ledger of an output folder: what became of each recording, in an SQLite file.

One program at a time writes it. It is synced before anything in it is told, so it never says less
than was told, and it says "done" only of results that are in place. It stays readable for others
while it is written (no write-ahead log, whose shared memory network disks do not have).
"""

from __future__ import annotations

import contextlib
import json
import sqlite3
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from tracking.batch.ledger_files import check_ledger_files
from tracking.batch.outcome import Outcome
from tracking.batch.recordings import is_name
from tracking.errors import OutputError
from tracking.owned_files import check_file
from tracking.stamps import now, software
from tracking.translation import msg

NAME = "batch.sqlite"
FORMAT, VERSION = "trackwright-batch", 1
_APPLICATION = 0x74776261  # "twba"
_LOCKED_MS = 60_000
_PREPARE = (
    "PRAGMA trusted_schema = OFF",
    "PRAGMA cell_size_check = ON",
    "PRAGMA mmap_size = 0",
    "PRAGMA temp_store = MEMORY",
    f"PRAGMA busy_timeout = {_LOCKED_MS}",
)
_SCHEMA = (
    "CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT",
    """CREATE TABLE recordings (
        name TEXT PRIMARY KEY,
        path TEXT NOT NULL,
        state TEXT NOT NULL,
        why TEXT NOT NULL,
        asked TEXT NOT NULL,
        signature TEXT NOT NULL,
        limits TEXT NOT NULL,
        outcome TEXT NOT NULL,
        thumbnail BLOB,
        updated TEXT NOT NULL
    ) STRICT""",
    """CREATE TABLE attempts (
        id INTEGER PRIMARY KEY,
        name TEXT NOT NULL,
        run TEXT NOT NULL,
        token TEXT NOT NULL,
        worker TEXT NOT NULL,
        began TEXT NOT NULL,
        ended TEXT NOT NULL DEFAULT '',
        result TEXT NOT NULL DEFAULT '',
        tracked INTEGER NOT NULL DEFAULT 0,
        why TEXT NOT NULL DEFAULT ''
    ) STRICT""",
)
_TABLES = frozenset({"about", "recordings", "attempts"})
_OF_ATTEMPT = "name, run, token, worker, began, ended, result, tracked, why"
_COLUMNS = "name, path, asked, signature, limits, outcome"


@dataclass(frozen=True, slots=True)
class Row:
    """What the ledger knows of a recording.

    Attributes:
        name, path: see `Entry`.
        asked: digest of what was asked for. signature: of its files before the work on it began.
        limits: what it was done within, as JSON.
        outcome: what became of it.
    """

    name: str
    path: Path
    asked: str
    signature: str
    limits: str
    outcome: Outcome


@dataclass(frozen=True, slots=True)
class Attempt:
    """One go at a recording, as the ledger keeps it; `result` is "" while it is not known."""

    name: str
    run: str
    token: str
    worker: str
    began: str
    ended: str
    result: str
    tracked: bool
    why: str


class Ledger:
    """The ledger, open for writing; changes are on disk when `commit` returns."""

    def __init__(self, path: Path) -> None:
        """Open or make it.

        Raises:
            OutputError: it is damaged, of a newer program or of another one, or cannot be written.
        """
        self.path = path
        with _told(path):
            check_ledger_files(path)
            self._base = sqlite3.connect(path, isolation_level=None, check_same_thread=False)
            try:
                self._open()
            except BaseException:
                self._base.close()
                raise

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Let go of the file; what was not committed is lost."""
        with contextlib.suppress(sqlite3.Error):
            self._base.execute("PRAGMA journal_mode = DELETE")  # leaves nothing beside the file
        self._base.close()

    def commit(self) -> None:
        """Put all changes on disk. Raises OutputError."""
        with _told(self.path):
            if self._base.in_transaction:
                self._base.execute("COMMIT")

    def rows(self) -> Iterator[Row]:
        """All recordings, by name."""
        with _told(self.path):
            yield from map(
                _row, self._base.execute(f"SELECT {_COLUMNS} FROM recordings ORDER BY name")
            )

    def put(self, row: Row, thumbnail: bytes | None = None) -> None:
        """Write what became of a recording, in place of what was known of it.

        thumbnail: a JPEG image; None: the one that is there stays.
        """
        with self._writing():
            outcome = row.outcome
            self._base.execute(
                "INSERT INTO recordings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
                "ON CONFLICT (name) DO UPDATE SET path=excluded.path, state=excluded.state, "
                "why=excluded.why, asked=excluded.asked, signature=excluded.signature, "
                "limits=excluded.limits, outcome=excluded.outcome, updated=excluded.updated, "
                "thumbnail=coalesce(excluded.thumbnail, thumbnail)",
                (
                    *(row.name, _text(row.path), str(outcome.state), _text(outcome.why)),
                    *(row.asked, row.signature, row.limits, outcome.as_text(), thumbnail, now()),
                ),
            )

    def begin_attempt(self, name: str, run: str, token: str, worker: str) -> int:
        """Note that a worker begins with a recording; the number of the attempt."""
        with self._writing():
            found = self._base.execute(
                "INSERT INTO attempts (name, run, token, worker, began) VALUES (?, ?, ?, ?, ?)",
                (name, run, token, worker, now()),
            )
            return found.lastrowid or 0

    def end_attempt(self, number: int, outcome: Outcome) -> None:
        """Note how an attempt ended."""
        with self._writing():
            self._base.execute(
                "UPDATE attempts SET ended = ?, result = ?, tracked = ?, why = ? WHERE id = ?",
                (
                    *(now(), str(outcome.state), int(outcome.tracked)),
                    *(_text(outcome.why), number),
                ),
            )

    def end_attempt_of(self, token: str, outcome: Outcome) -> None:
        """The same of an attempt whose end nobody saw, by the token of its task."""
        with self._writing():
            found = self._base.execute(
                "SELECT id FROM attempts WHERE token = ?", (token,)
            ).fetchone()
            if found is not None:
                self.end_attempt(found[0], outcome)

    def end_open_attempts(self) -> None:
        """Note of attempts whose end nobody saw that they came to nothing."""
        with self._writing():
            self._base.execute(
                "UPDATE attempts SET ended = ?, result = 'lost' WHERE result = ''", (now(),)
            )

    def attempts(self) -> list[Attempt]:
        """All attempts, in order."""
        asked = f"SELECT {_OF_ATTEMPT} FROM attempts"
        with _told(self.path):
            found = self._base.execute(f"{asked} ORDER BY id").fetchall()
        return [_attempt(*each) for each in found]

    def thumbnails(self, names: Iterable[str]) -> dict[str, bytes]:
        """JPEG images of recordings that have one."""
        asked = "SELECT thumbnail FROM recordings WHERE name = ?"
        with _told(self.path):
            found = {name: self._base.execute(asked, (name,)).fetchone() for name in names}
        return {name: row[0] for name, row in found.items() if row is not None and row[0]}

    def take_over(self, other: Ledger) -> None:
        """Take over what another ledger knows, where that was found out later."""
        with self._writing():
            known = dict(self._base.execute("SELECT name, updated FROM recordings"))
            with _told(other.path):
                rows = other._base.execute("SELECT * FROM recordings").fetchall()
                for row in rows:
                    _check_name(row[0])
            for row in rows:
                if known.get(row[0], "") < row[-1]:
                    self._base.execute("DELETE FROM recordings WHERE name = ?", (row[0],))
                    self._base.execute(
                        "INSERT INTO recordings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", row
                    )
            there = {token for (token,) in self._base.execute("SELECT token FROM attempts")}
            for attempt in other._base.execute(f"SELECT {_OF_ATTEMPT} FROM attempts"):
                if attempt[2] not in there:
                    self._base.execute(
                        f"INSERT INTO attempts ({_OF_ATTEMPT}) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
                        attempt,
                    )

    @contextmanager
    def _writing(self) -> Iterator[None]:
        """Run a block within a transaction. Raises OutputError, as where the disk is full."""
        with _told(self.path):
            if not self._base.in_transaction:
                self._base.execute("BEGIN IMMEDIATE")
            yield

    def _open(self) -> None:
        for line in _PREPARE:
            self._base.execute(line)
        held = self._base.execute("SELECT type, name, sql FROM sqlite_schema").fetchall()
        if not held:
            self._make()
        else:
            self._check(held)
        self._base.execute("PRAGMA journal_mode = TRUNCATE")
        self._base.execute("PRAGMA synchronous = FULL")

    def _make(self) -> None:
        self._base.execute("BEGIN EXCLUSIVE")
        self._base.execute(f"PRAGMA application_id = {_APPLICATION}")
        for line in _SCHEMA:
            self._base.execute(line)
        about = {"format": FORMAT, "format_version": str(VERSION), "software": software()}
        self._base.executemany("INSERT INTO about VALUES (?, ?)", about.items())
        self._base.execute("COMMIT")

    def _check(self, held: Sequence[tuple[str, str, str]]) -> None:
        """Refuse a file that holds more than a ledger's tables, or those of a newer program."""
        own = {name: kind for kind, name, _ in held if not name.startswith("sqlite_autoindex_")}
        if own != dict.fromkeys(_TABLES, "table"):
            raise OutputError(
                "{path} is no ledger of a batch", "choose another folder", path=self.path
            )
        about: Mapping[str, str] = dict(self._base.execute("SELECT name, value FROM about"))
        if about.get("format") != FORMAT:
            raise OutputError(
                "{path} is no ledger of a batch", "choose another folder", path=self.path
            )
        if about.get("format_version") != str(VERSION):
            raise OutputError(
                "{path} was made by a newer trackwright; update, or choose another folder",
                path=self.path,
            )


def read_rows(path: Path) -> list[Row]:
    """The recordings of a ledger that another program may be writing; none where none is there.

    Raises OutputError as `Ledger`.
    """
    if check_file(path, is_written=False) is None:
        return []
    with closing(Ledger(path)) as ledger:
        return list(ledger.rows())


def _row(cells: tuple[str, str, str, str, str, str]) -> Row:
    name, path, asked, seen, limits, outcome = cells
    _check_name(name)
    return Row(name, Path(path), asked, seen, limits, Outcome.from_text(outcome))


def _check_name(name: str) -> None:
    """Refuse a name that would lead out of the folder. Raises ValueError."""
    if not is_name(name):
        raise ValueError("no name of a recording")


def _attempt(
    name: str,
    run: str,
    token: str,
    worker: str,
    began: str,
    ended: str,
    result: str,
    tracked: int,
    why: str,
) -> Attempt:
    return Attempt(name, run, token, worker, began, ended, result, tracked == 1, why)


def _text(value: object) -> str:
    """A text as a database holds it: names of files may have bytes that are no letters."""
    return str(value).encode("utf-8", "surrogateescape").decode("utf-8", "replace")


@contextmanager
def _told(path: Path) -> Iterator[None]:
    """Errors of SQLite as a line that says what to do."""
    try:
        yield
    except sqlite3.DatabaseError as error:
        busy = isinstance(error, sqlite3.OperationalError)
        raise OutputError(
            "{path}: {reason}",
            msg("make room, or check the disk")
            if busy
            else msg("move it away and run the batch again: sessions that are whole are kept"),
            path=path,
            reason=str(error),
        ) from error
    except ValueError as error:
        raise OutputError(
            "{path} is damaged ({reason})",
            "move it away and run the batch again: sessions that are whole are kept",
            path=path,
            reason=str(error),
        ) from error


def limits_text(time_s: float | None, stall_s: float | None, memory_bytes: int | None) -> str:
    """Limits as the ledger keeps them."""
    return json.dumps([time_s, stall_s, memory_bytes])
