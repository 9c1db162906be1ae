"""What stands beside a session while it is open: its lock and its journal."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

from tracking.editing import Entry
from tracking.errors import OutputError, SessionError
from tracking.session.journal import Act, Journal
from tracking.session.lock import SessionLock
from tracking.session.saving import clear_leftovers, companions, sync_folder, telling_where

JOURNAL = "journal.sqlite"


class Store:
    """The right to write one session."""

    def __init__(self, path: Path, lock: SessionLock) -> None:
        """Use `claim`."""
        self._path = path
        self._folder = companions(path)
        self._lock = lock
        self._journal: Journal | None = None
        self._begun: tuple[ThreadPoolExecutor, Future[Journal]] | None = None
        self._doubted = False

    @classmethod
    def claim(cls, path: Path) -> Store:
        """Take the session's lock.

        Raises SessionError where another program has it, OutputError where the folder cannot be
        written to.
        """
        with telling_where(path, "its folder cannot be written to"):
            lock = _locked(path)
            clear_leftovers(path)
        return cls(path, lock)

    def make_sure(self, is_own: Callable[[], bool]) -> bool:
        """See to it that lock and journal are the ones at their paths: quick while they are.

        A folder that was away and is back, as a network disk may be, is taken up again where
        is_own says that the session file in it is the one this program knows.
        False: the journal that came back misses steps; they must be put on disk otherwise.
        Raises OutputError where the folder is away, SessionError where another program has the
        session or has changed it.
        """
        if self._is_in_place():
            return True
        if not self._path.is_file():
            raise OutputError(
                f"{self._path} is out of reach: its folder has vanished; nothing was changed: "
                "connect it again and go on"
            )
        if not self._lock.is_in_place:
            self._lock_again(is_own)
        return self._journal_again()

    def keep(self, act: Act, entry: Entry, session: str, save: str) -> None:
        """Put a step into the journal, on disk when this returns; a new one builds on that save.

        Raises OutputError where its disk refuses: it is opened anew before it is written to again.
        """
        try:
            journal = self.journal()
            if journal.origin is None:
                journal.start_over(session, save)
            journal.append(act, entry)
        except OutputError:
            self._doubted = True
            raise

    def rebase(self, session: str, save: str, included: int) -> None:
        """Let the journal build on the file that was just written, which holds so many steps."""
        if self.has_journal:
            with contextlib.suppress(OutputError):  # it stays longer; the file says what it holds
                self.journal().start_over(session, save, included)

    def _is_in_place(self) -> bool:
        journal = self._opened()
        written = journal is None or (journal.is_in_place and not self._doubted)
        return written and self._lock.is_in_place

    def _lock_again(self, is_own: Callable[[], bool]) -> None:
        with telling_where(self._path, "its folder cannot be written to"):
            lock = _locked(self._path)
        if not is_own():
            lock.release()
            raise SessionError(
                f"{self._path} was changed by another program while it was out of reach; "
                "save under another name"
            )
        self._lock.let_go()
        self._lock = lock

    def _journal_again(self) -> bool:
        written = self._journal
        if written is None:
            return True
        written.close()
        journal = self._made()
        self._doubted = False
        if journal.continues(written):
            self._journal = journal
            return True
        journal.close()
        self.set_journal_aside()
        return False

    @property
    def has_journal(self) -> bool:
        """Whether there is a journal, open or left by a program that died."""
        return self._opened() is not None or (self._folder / JOURNAL).exists()

    def begin_journal(self, session: str, save: str) -> None:
        """Have an empty journal on this save made by another thread, where there is none.

        A new file is on the disk for good after several waits for it: the first edit need not
        stand them. Where it fails nothing is said: that edit tries again, and tells.
        """
        if self.has_journal:
            return
        maker = ThreadPoolExecutor(1, "journal")
        self._begun = (maker, maker.submit(self._begin, session, save))
        maker.shutdown(wait=False)

    def _begin(self, session: str, save: str) -> Journal:
        sync_folder(self._path.parent)  # what is journalled must not vanish with its new folder
        return Journal.begun(self._folder / JOURNAL, session, save)

    def journal(self) -> Journal:
        """The journal, made where there is none."""
        self._journal = self._opened() or self._made()
        return self._journal

    def _made(self) -> Journal:
        sync_folder(self._path.parent)
        return Journal(self._folder / JOURNAL)

    def _opened(self) -> Journal | None:
        """The journal that is open, waited for where it is being made."""
        if self._begun is not None:
            (maker, begun), self._begun = self._begun, None
            with maker, contextlib.suppress(SessionError, OutputError):
                self._journal = begun.result()  # and its thread has ended, not only its work
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
        journal, self._journal = self._opened(), None
        if journal is not None:
            journal.close()


def is_open(path: Path) -> bool:
    """Whether a program has a session open for writing; raises OSError where nobody can tell."""
    return _lock_of(path).is_held


def _locked(path: Path) -> SessionLock:
    """The session's lock, taken; the folder it lies in is made where there is none."""
    folder = companions(path)
    if not folder.exists():
        folder.mkdir(exist_ok=True)
    lock = _lock_of(path)
    if not lock.acquire():
        raise SessionError(f"{path}: the session is open in {lock.holder()}; close it there first")
    return lock


def _lock_of(path: Path) -> SessionLock:
    return SessionLock(companions(path) / "lock")
