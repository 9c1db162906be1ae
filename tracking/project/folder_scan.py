"""What lies in a project's folder: recordings, sessions, ledgers of batches; nothing is read."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from tracking.batch.ledger import NAME as LEDGER
from tracking.batch.recordings import DEEPEST, is_recording
from tracking.errors import RecordingError
from tracking.session.journal_files import JOURNAL, NEXT
from tracking.session.session_writer import companions
from tracking.translation import Message, msg

MOST_RECORDINGS = 5000
MOST_SESSIONS = 20_000
_MOST_FOLDERS = 50_000
_MOST_BESIDE = 4000
"""Entries of a recording's folder that its stamp counts; a folder of images has many more."""
_SESSIONS = (".h5",)


@dataclass(frozen=True, slots=True)
class ScannedFile:
    """A recording or a session that was found.

    Attributes:
        path: of it. stamp: another one means that it has changed.
    """

    path: Path
    stamp: str


@dataclass(slots=True)
class FolderScan:
    """What was found, by path.

    Attributes:
        folder: that was searched. ledgers: of batches.
        notes: what the user should be told: what was left out, and why.
    """

    folder: Path
    recordings: list[ScannedFile] = field(default_factory=list)
    sessions: list[ScannedFile] = field(default_factory=list)
    ledgers: list[Path] = field(default_factory=list)
    notes: list[Message] = field(default_factory=list)


def scan_folder(folder: Path) -> FolderScan:
    """Look through a folder and those below it; links are not followed, hidden ones left out.

    Raises RecordingError where the folder itself cannot be read.
    """
    try:
        with os.scandir(folder):
            pass
    except OSError as error:
        raise RecordingError(
            "cannot read the folder {folder}: {reason}; check the path",
            folder=folder,
            reason=error.strerror,
        ) from error
    scan = FolderScan(Path(os.path.abspath(folder)))  # noqa: PTH100 - links stay
    _Walk(scan).walk()
    return scan


def holds_several(folder: Path) -> bool:
    """Whether a folder is no recording itself, and has more than one recording or session in it.

    Quick: it looks no further than to the second one.
    """
    if folder.is_symlink() or not folder.is_dir() or is_recording(folder):
        return False
    walk = _Walk(FolderScan(folder), enough=2)
    walk.walk()
    return len(walk.scan.recordings) + len(walk.scan.sessions) > 1


class _Walk:
    def __init__(self, scan: FolderScan, enough: int | None = None) -> None:
        self.scan = scan
        self._enough = enough
        self._folders = 0

    def walk(self) -> None:
        folder = self.scan.folder
        if is_recording(folder):
            self._add_recording(folder)
            self._add_sessions(_entries(folder))
        else:
            self._enter(folder, 0)

    @property
    def _is_full(self) -> bool:
        found = len(self.scan.recordings) + len(self.scan.sessions)
        if self._enough is not None and found >= self._enough:
            return True
        return (
            len(self.scan.recordings) >= MOST_RECORDINGS
            or len(self.scan.sessions) >= MOST_SESSIONS
            or self._folders >= _MOST_FOLDERS
        )

    def _enter(self, folder: Path, depth: int) -> None:
        self._folders += 1
        entries = _entries(folder)
        self._add_sessions(entries)
        for entry in entries:
            if self._is_full:
                self._tell_full()
                return
            path = Path(entry.path)
            if entry.is_dir(follow_symlinks=False):
                self._add_folder(path, depth)
            elif entry.is_file(follow_symlinks=False):
                if entry.name == LEDGER:
                    self.scan.ledgers.append(path)
                elif path.suffix.lower() not in _SESSIONS and is_recording(path):
                    self._add_recording(path)

    def _add_folder(self, folder: Path, depth: int) -> None:
        if is_recording(folder):
            self._add_recording(folder)
            self._add_sessions(_entries(folder))
        elif depth < DEEPEST:
            self._enter(folder, depth + 1)
        else:
            self._note(msg("folders more than {n} levels down are not searched", n=DEEPEST))

    def _add_recording(self, path: Path) -> None:
        self.scan.recordings.append(ScannedFile(path, _stamp_of_recording(path)))

    def _add_sessions(self, entries: Iterable[os.DirEntry[str]]) -> None:
        for entry in entries:
            path = Path(entry.path)
            if path.suffix.lower() not in _SESSIONS or not entry.is_file(follow_symlinks=False):
                continue
            if len(self.scan.sessions) >= MOST_SESSIONS:
                return
            self.scan.sessions.append(ScannedFile(path, stamp_of_session(path)))

    def _tell_full(self) -> None:
        if self._enough is None:
            self._note(
                msg(
                    "only the first {recordings} recordings and {sessions} sessions are listed; "
                    "open a folder below this one for the others",
                    recordings=len(self.scan.recordings),
                    sessions=len(self.scan.sessions),
                )
            )

    def _note(self, note: Message) -> None:
        if note not in self.scan.notes:
            self.scan.notes.append(note)


def stamp_of_session(path: Path) -> str:
    """Another one wherever the session was saved or edited."""
    beside = companions(path)
    journals = [beside / f"{name}{ending}" for name in (JOURNAL, NEXT) for ending in ("", "-wal")]
    return _digest(map(_state, (path, *journals)))


def _stamp_of_recording(path: Path) -> str:
    """Of the file, or of the folder and of what stands right in it but sessions."""
    states = [_state(path)]
    if path.is_dir():
        own = [one for one in _entries(path, _MOST_BESIDE) if not one.name.endswith(_SESSIONS)]
        # A folder of its own changes with each session that is saved in it.
        states = [(one.name, *_state(Path(one.path))) for one in own]
    return _digest(states)


def _state(path: Path) -> tuple[object, ...]:
    try:
        state = path.lstat()
    except OSError:
        return ()
    return state.st_size, state.st_mtime_ns, state.st_ctime_ns, state.st_ino


def _digest(states: Iterable[object]) -> str:
    return hashlib.sha256("\n".join(map(str, states)).encode("utf-8", "replace")).hexdigest()


def _entries(folder: Path, most: int | None = None) -> list[os.DirEntry[str]]:
    """What stands in a folder, by name, but hidden files; what cannot be read is empty."""
    try:
        with os.scandir(folder) as held:
            found = [each for each in _first(held, most) if not each.name.startswith(".")]
    except OSError:
        return []
    return sorted(found, key=lambda each: each.name)


def _first(held: Iterator[os.DirEntry[str]], most: int | None) -> Iterator[os.DirEntry[str]]:
    for number, each in enumerate(held):
        if most is not None and number >= most:
            return
        yield each
