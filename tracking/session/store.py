"""What stands beside a session while it is open: its lock and its journal."""

from __future__ import annotations

import contextlib
from pathlib import Path

from tracking.errors import SessionError
from tracking.session.journal import Journal
from tracking.session.lock import SessionLock
from tracking.session.saving import clear_leftovers, companions, sync_folder, telling_where

JOURNAL = "journal.sqlite"


class Store:
    """The right to write one session."""

    def __init__(self, path: Path, lock: SessionLock) -> None:
        """Use `claim`."""
        self._folder = companions(path)
        self._lock = lock
        self._journal: Journal | None = None

    @classmethod
    def claim(cls, path: Path) -> Store:
        """Take the session's lock.

        Raises SessionError where another program has it, OutputError where the folder cannot be
        written to.
        """
        folder = companions(path)
        with telling_where(path, "its folder cannot be written to"):
            if not folder.exists():
                folder.mkdir(exist_ok=True)
                sync_folder(path.parent)  # what is journalled in it must not vanish with it
            lock = SessionLock(folder / "lock")
            if not lock.acquire():
                raise SessionError(
                    f"{path}: the session is open in {lock.holder()}; close it there first"
                )
            clear_leftovers(path)
        return cls(path, lock)

    @property
    def has_journal(self) -> bool:
        """Whether there is a journal, open or left by a program that died."""
        return self._journal is not None or (self._folder / JOURNAL).exists()

    def journal(self) -> Journal:
        """The journal, made where there is none."""
        if self._journal is None:
            self._journal = Journal(self._folder / JOURNAL)
        return self._journal

    def set_journal_aside(self) -> Path:
        """Keep the journal under another name, so that a new one can begin; gives that name."""
        self._close_journal()
        taken = len(list(self._folder.glob("kept-aside-*.sqlite")))
        aside = self._folder / f"kept-aside-{taken + 1}.sqlite"
        with telling_where(aside, "the journal cannot be kept aside"):
            for ending in ("-wal", "-shm", ""):
                file = self._folder / f"{JOURNAL}{ending}"
                if file.exists():
                    file.replace(self._folder / f"{aside.name}{ending}")
        return aside

    def release(self, *, keep_journal: bool) -> None:
        """Give the session back, and take away what is needed no more."""
        self._close_journal()
        with contextlib.suppress(OSError):
            if not keep_journal:
                for ending in ("-wal", "-shm", ""):
                    (self._folder / f"{JOURNAL}{ending}").unlink(missing_ok=True)
            self._lock.release()
            self._folder.rmdir()  # only succeeds where nothing is kept

    def _close_journal(self) -> None:
        if self._journal is not None:
            self._journal.close()
            self._journal = None


def has_waiting_journal(path: Path) -> bool:
    """Whether edits may wait beside a session that this program may not write."""
    return (companions(path) / JOURNAL).exists()
