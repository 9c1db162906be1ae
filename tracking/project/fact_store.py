"""Facts that were read before, kept in the user's cache by path and stamp."""

from __future__ import annotations

import contextlib
import sqlite3
import threading
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from tracking.errors import UnsafeFileError
from tracking.owned_files import check_file, make_folder
from tracking.project.facts import Facts, RecordingFacts, SessionFacts
from tracking.project.folder_scan import ScannedFile
from tracking.project.readings import ReadFacts
from tracking.stamps import software

_NAME = "project.sqlite"
_LAYOUT = 2
_BUSY_MS = 2000
_MOST_BYTES = 2 << 30
_MOST_ROWS = 100_000
_SCHEMA = """CREATE TABLE IF NOT EXISTS facts (
    path TEXT PRIMARY KEY, made TEXT NOT NULL, stamp TEXT NOT NULL, beside TEXT NOT NULL,
    session INTEGER NOT NULL, facts TEXT NOT NULL, image BLOB NOT NULL
) STRICT"""


@dataclass(frozen=True, slots=True)
class KnownFacts:
    """What is known of a file.

    Attributes:
        stamp: of the file as it was read.
        beside: of a session the recording that was read with it, and its stamp; "": none.
    """

    facts: Facts
    stamp: str
    beside: str = ""


class FactStore:
    """What was read of files, as long as they do not change.

    It only saves time: one that is damaged is made anew, and what cannot be written is kept in
    memory. It may be used from several threads.
    """

    def __init__(self, folder: Path) -> None:
        """The folder is the program's own, such as `platformdirs.user_cache_path(...)`."""
        self._base = _opened(folder)
        self._made = f"{_LAYOUT} {software()}"
        self._lock = threading.Lock()
        self._unkept: dict[Path, tuple[KnownFacts, bytes]] = {}

    def close(self) -> None:
        """Let go of the file."""
        with self._lock:
            self._base.close()

    def find(self, files: Iterable[ScannedFile]) -> dict[Path, KnownFacts]:
        """The facts of files as they were read last; `stamp` says whether they changed since."""
        found: dict[Path, KnownFacts] = {}
        with self._lock:
            for file in files:
                known = self._facts_of(file.path)
                if known is not None:
                    found[file.path] = known
        return found

    def image(self, path: Path) -> bytes:
        """The image of a file as it was read last; b"": there is none."""
        with self._lock:
            if path in self._unkept:
                return self._unkept[path][1]
            asked = "SELECT image FROM facts WHERE path = ?"
            try:
                row = self._base.execute(asked, (_text(path),)).fetchone()
            except sqlite3.Error:
                return b""
        return bytes(row[0]) if row is not None else b""

    def put(self, file: ScannedFile, read: ReadFacts, beside: str = "") -> None:
        """Keep what was read of a file. beside: see `KnownFacts`."""
        of_session = int(isinstance(read.facts, SessionFacts))
        with self._lock:
            self._unkept.pop(file.path, None)
            try:
                self._base.execute(
                    "INSERT OR REPLACE INTO facts VALUES (?, ?, ?, ?, ?, ?, ?)",
                    (
                        *(_text(file.path), self._made, file.stamp, beside),
                        *(of_session, read.facts.as_text(), read.image),
                    ),
                )
            except sqlite3.Error:
                known = KnownFacts(read.facts, file.stamp, beside)
                self._unkept[file.path] = known, read.image

    def trim(self) -> None:
        """Forget the oldest where there are very many."""
        with self._lock, contextlib.suppress(sqlite3.Error):
            self._base.execute(
                "DELETE FROM facts WHERE rowid <= (SELECT max(rowid) FROM facts) - ?", (_MOST_ROWS,)
            )

    def _facts_of(self, path: Path) -> KnownFacts | None:
        if path in self._unkept:
            return self._unkept[path][0]
        asked = "SELECT stamp, beside, session, facts FROM facts WHERE path = ? AND made = ?"
        try:
            row = self._base.execute(asked, (_text(path), self._made)).fetchone()
            if row is None:
                return None
            kind = SessionFacts if row[2] else RecordingFacts
            return KnownFacts(kind.from_text(row[3]), row[0], row[1])
        except (sqlite3.Error, ValueError, RecursionError):
            return None


def _opened(folder: Path) -> sqlite3.Connection:
    """The store in a folder; one in memory where it cannot be used."""
    path = folder / _NAME
    try:
        folder.mkdir(parents=True, exist_ok=True)
        make_folder(folder)
        check_file(path, _MOST_BYTES)
        return _connected(path)
    except sqlite3.DatabaseError:
        with contextlib.suppress(OSError, sqlite3.Error):
            path.unlink(missing_ok=True)
            return _connected(path)
    except (OSError, UnsafeFileError):
        pass
    return _connected(None)


def _connected(path: Path | None) -> sqlite3.Connection:
    base = sqlite3.connect(
        ":memory:" if path is None else path, isolation_level=None, check_same_thread=False
    )
    try:
        for line in (
            f"PRAGMA busy_timeout = {_BUSY_MS}",
            "PRAGMA trusted_schema = OFF",
            "PRAGMA journal_mode = MEMORY",
            "PRAGMA synchronous = OFF",  # what is lost is read again
            _SCHEMA,
        ):
            base.execute(line)
        base.execute("SELECT path, made, stamp, beside, session, facts, image FROM facts LIMIT 1")
    except BaseException:
        base.close()
        raise
    return base


def _text(path: Path) -> str:
    return str(path).encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")
