"""A project as its list shows it: what is in the folder, what is known, what is to be read."""

from __future__ import annotations

import contextlib
import os
import platform
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tracking.batch.ledger import read_rows
from tracking.batch.signature import file_state
from tracking.errors import SessionError, TrackwrightError
from tracking.file_lock import SessionLock
from tracking.project.fact_store import FactStore, KnownFacts
from tracking.project.facts import SessionFacts
from tracking.project.folder_scan import FolderScan, ScannedFile, scan_folder
from tracking.project.pairing import (
    LedgerEntry,
    ProjectRow,
    SessionRow,
    guess,
    match_sessions,
    pair,
)
from tracking.project.reader_process import ReaderProcess
from tracking.project.readings import Reading
from tracking.session.pending_edits import last_worked_on_s
from tracking.session.session_writer import companions
from tracking.translation import Message, msg


@dataclass(frozen=True, slots=True)
class Wanted:
    """A file that is still to be read, or has changed since.

    Attributes:
        beside: see `KnownFacts`. is_held: a program has the session open, and may go on editing.
    """

    file: ScannedFile
    reading: Reading
    beside: str = ""
    is_held: bool = False


@dataclass(frozen=True, slots=True)
class ProjectList:
    """A project at one moment.

    Attributes:
        folder: of it. rows: by name. wanted: what is still to be read, in order.
        notes: what the user should be told. batches: folders that batches worked in.
    """

    folder: Path
    rows: tuple[ProjectRow, ...] = ()
    wanted: tuple[Wanted, ...] = ()
    notes: tuple[Message, ...] = ()
    batches: tuple[Path, ...] = ()


class Project:
    """A folder of recordings and sessions.

    `look` belongs to one thread at a time, `read` to another one.
    """

    def __init__(self, folder: Path, cache: Path, author: str = "") -> None:
        """Takes a folder.

        Args:
            folder: that is looked through.
            cache: the program's own folder, for what was read.
            author: whose session of several of a recording is shown.
        """
        self.folder = Path(os.path.abspath(folder))  # noqa: PTH100 - links stay
        self.author = author
        self._store = FactStore(cache)
        self._ledgers: dict[Path, tuple[object, Sequence[LedgerEntry], Message]] = {}

    def look(self) -> ProjectList:
        """Look through the folder; only names, times and locks are read.

        Raises RecordingError where the folder cannot be read.
        """
        scan = scan_folder(self.folder)
        entries, notes = self._entries(scan)
        known = self._store.find([*scan.recordings, *scan.sessions])
        sessions = {file.path: _session_row(file, known) for file in scan.sessions}
        rows = pair(scan, known, entries, sessions, self.author)
        held = {path for path, row in sessions.items() if row.holder}
        wanted = tuple(_wanted(scan, known, entries, held))
        batches = tuple(path.parent for path in scan.ledgers)
        return ProjectList(self.folder, tuple(rows), wanted, (*scan.notes, *notes), batches)

    def read(
        self, wanted: Sequence[Wanted], reader: ReaderProcess, tell: Callable[[int, int], None]
    ) -> None:
        """Read files and keep what they tell; what `tell` raises ends it."""
        for number, each in enumerate(wanted):
            tell(number, len(wanted))
            read = reader.read(each.reading)
            if reader.is_closed:
                return
            self._store.put(each.file, read, each.beside)
        self._store.trim()
        tell(len(wanted), len(wanted))

    def image(self, row: ProjectRow) -> bytes:
        """A small JPEG image of a row, with the people of its session; b"": none is known."""
        session = row.session
        image = b"" if session is None else self._store.image(session.path)
        if not image and row.recording is not None:
            image = self._store.image(row.recording.path)
        return image

    def close(self) -> None:
        """Let go of what is kept."""
        self._store.close()

    def _entries(self, scan: FolderScan) -> tuple[list[LedgerEntry], list[Message]]:
        """What ledgers in the folder say; one that cannot be read is told."""
        known = {path: self._entries_of(path) for path in scan.ledgers}
        self._ledgers = known
        entries = [entry for _, found, _ in known.values() for entry in found]
        return entries, [note for _, _, note in known.values() if note]

    def _entries_of(self, ledger: Path) -> tuple[object, Sequence[LedgerEntry], Message]:
        state = file_state(ledger)
        before = self._ledgers.get(ledger)
        if before is not None and before[0] == state:
            return before
        try:
            rows = read_rows(ledger)
        except TrackwrightError as error:
            return state, (), error.message
        out = ledger.parent
        found = [LedgerEntry(out / f"{row.name}.h5", row.path, row.outcome) for row in rows]
        return state, found, Message()


def _wanted(
    scan: FolderScan,
    known: Mapping[Path, KnownFacts],
    entries: Sequence[LedgerEntry],
    held: Collection[Path],
) -> Iterator[Wanted]:
    """What is to be read: recordings first, as they are quick, and sessions by name."""
    for file in scan.recordings:
        if file.path not in known or known[file.path].stamp != file.stamp:
            yield Wanted(file, Reading(file.path, of_session=False))
    stamps = {file.path: file.stamp for file in scan.recordings}
    likely = guess(scan, entries)
    certain = match_sessions(scan, known, entries)
    for file in scan.sessions:
        before = known.get(file.path)
        place = (likely if before is None else certain).get(file.path)
        beside = "" if place is None else f"{place} {stamps[place]}"
        if before is None or (before.stamp, before.beside) != (file.stamp, beside):
            yield Wanted(file, Reading(file.path, True, place), beside, file.path in held)


def _session_row(file: ScannedFile, known: Mapping[Path, KnownFacts]) -> SessionRow:
    facts = known[file.path].facts if file.path in known else None
    return SessionRow(
        file,
        facts if isinstance(facts, SessionFacts) else None,
        last_worked_on_s(file.path),
        holder_of(file.path),
    )


def holder_of(session: Path) -> str:
    """Who has a session open, in words; "": nobody."""
    place = companions(session) / "lock"
    if not os.path.lexists(place):
        return ""
    lock = SessionLock(place)
    with contextlib.suppress(OSError, SessionError):
        if not lock.is_held:
            return ""
    holder = lock.holder()
    own = f"process {os.getpid()} on {platform.node()}"
    return msg("this window") if holder == own else holder
