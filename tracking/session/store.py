"""What stands beside a session while it is open: its lock and its journal."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

from tracking.atomic_output import check_target
from tracking.editing import Entry
from tracking.errors import OutputError, SessionError
from tracking.file_lock import SessionLock
from tracking.owned_files import make_folder, permissions_of, sync_folder
from tracking.session import journal_files
from tracking.session.journal import Act, Journal, Step
from tracking.session.journal_files import JOURNAL
from tracking.session.session_writer import clear_leftovers, companions, explain_file_errors
from tracking.translation import msg

_TRIES = 20
"""Of taking the lock in a folder that another program takes away at that moment."""


class Store:
    """The right to write one session.

    A journal that lies there is taken over at opening alone, when its edits are made again. Later
    on, one that this program did not write is another program's: it is kept aside, never written
    to, trimmed or taken away.
    """

    def __init__(self, path: Path, lock: SessionLock) -> None:
        """Use `claim`."""
        self._path = path
        self._folder = companions(path)
        self._lock = lock
        self._journal: Journal | None = None
        self._begun: tuple[ThreadPoolExecutor, Future[Journal]] | None = None
        self._doubted = False
        self.others_aside: Path | None = None
        self.kept_aside: Path | None = None
        """What an opening kept aside that ended before it could tell."""

    @classmethod
    def claim(cls, path: Path) -> Store:
        """Take the session's lock.

        Raises SessionError where another program has it, UnsafeFileError where what stands beside
        it is not this user's own, OutputError where the folder cannot be written to or the path is
        no place for a file.
        """
        check_target(path)
        with explain_file_errors(path, msg("its folder cannot be written to")):
            lock = _locked(path)
            try:
                clear_leftovers(path)
            except BaseException:
                with contextlib.suppress(OSError):
                    lock.release()
                raise
        return cls(path, lock)

    def make_sure(self, is_own: Callable[[], bool]) -> bool:
        """See to it that lock and journal are the ones at their paths: quick while they are.

        A folder that was away and is back, as a network disk may be, is taken up again where
        is_own says that the session file in it is the one this program knows.
        False: the journal that came back misses steps; they must be put on disk otherwise. Where
        another program's edits lie there, `others_aside` names the file they were kept aside as.
        Raises OutputError where the folder is away, SessionError where another program has the
        session or has changed it.
        """
        self.others_aside = None
        if self._is_in_place():
            return True
        if not os.path.isfile(self._path):  # noqa: PTH113 - Path.is_file raises if locked
            raise OutputError(
                "{path} is out of reach: its folder has vanished or is locked. Nothing was "
                "changed. Connect its disk again, put the folder back or unlock it, and go on",
                path=self._path,
            )
        if not self._lock.is_in_place:
            self._lock_again(is_own)
        return self._journal_again()

    def keep(self, act: Act, entry: Entry, session: str, save: str) -> None:
        """Put a step into the journal, on disk when this returns; a new one builds on that save.

        Raises OutputError where its disk refuses, SessionError where another program wrote into
        it: it is opened anew before it is written to again.
        """
        try:
            journal = self.journal
            if journal is None:
                journal = self._journal = self._begin(session, save)
            journal.append(act, entry)
        except BaseException:
            self._doubted = True
            raise

    @property
    def steps(self) -> int:
        """How many steps this program knows of in the journal."""
        return 0 if self.journal is None else self.journal.last

    def take_back(self, steps: int) -> None:
        """A step after so many came to nothing: it is taken out before the journal is used."""
        if self._journal is not None and self._journal.take_back(steps):
            self._doubted = True

    def rebase(self, session: str, save: str, included: int) -> None:
        """Let the journal build on the file that was just written, which holds so many steps."""
        journal = self.journal
        if journal is None:
            return
        try:
            journal.start_over(session, save, included)
        except (OutputError, SessionError):  # it stays longer; the file says what it holds
            self._doubted = True
        except BaseException:
            self._doubted = True
            raise

    @property
    def has_its_journal(self) -> bool:
        """Whether the journal that was written to, if any was, still is the one at its path."""
        return self.journal is None or self.journal.is_in_place

    def _is_in_place(self) -> bool:
        journal = self.journal
        known = (
            not journal_files.are_there(self._folder) if journal is None else journal.is_in_place
        )
        return known and not self._doubted and self._lock.is_in_place

    def _lock_again(self, is_own: Callable[[], bool]) -> None:
        with explain_file_errors(self._path, msg("its folder cannot be written to")):
            lock = _locked(self._path)
        if not is_own():
            lock.release()
            raise SessionError(
                "{path} was changed by another program while it was out of reach; save under "
                "another name",
                path=self._path,
            )
        self._lock.let_go()
        self._lock = lock

    def _journal_again(self) -> bool:
        written = self._journal
        self._doubted = True  # until it is open again
        if written is not None:
            written.close()
        if journal_files.are_there(self._folder):
            self._take_up(written)
        else:
            self._journal = None
        self._doubted = False
        return written is None or self._journal is not None

    def _take_up(self, written: Journal | None) -> None:
        """Go on with the journal that lies there where it is the one that was written to."""
        journal = self._reopened()
        if journal is not None and written is not None:
            try:
                if _continues(journal, written):
                    self._journal = journal
                    return
            except SessionError:  # damaged: it is closed, and kept aside below
                journal = None
        has_others = journal is None or journal.has_others(written)
        is_empty = journal is not None and journal.is_empty
        if journal is not None:
            journal.close()
        if is_empty:
            self._journal = None
            journal_files.remove(self._folder)
            return
        try:
            aside = self.set_journal_aside()
        except OutputError:
            self._journal = written  # it is still known what was in it
            raise
        self.others_aside = aside if has_others else None

    def _reopened(self) -> Journal | None:
        """The journal that is there now; None where that is something else."""
        try:
            return self._found()
        except SessionError:
            return None

    def take_over(self) -> Journal:
        """The journal that lies there, whoever wrote it; from now on this program's.

        Raises OutputError where it cannot be opened, SessionError where it is none.
        """
        self._journal = self._found()
        return self._journal

    def _found(self) -> Journal:
        self._sync_folder()
        self.kept_aside = journal_files.finish_replacing(self._folder)
        return Journal(self._folder / JOURNAL, permissions_of(self._path))

    def _sync_folder(self) -> None:
        """What is journalled must not vanish with the folder it lies in, which may be new."""
        with explain_file_errors(self._path, msg("its folder cannot be written to")):
            sync_folder(self._path.parent)

    @property
    def has_files_of_journal(self) -> bool:
        """Whether a journal lies there, whoever wrote it; OutputError where nobody can tell."""
        return self.journal is not None or journal_files.are_there(self._folder)

    def begin_journal(self, session: str, save: str) -> None:
        """Have an empty journal on this save made by another thread, where there is none.

        A new file is on the disk for good after several waits for it: the first edit need not
        stand them. Where it fails nothing is said: that edit tries again, and tells.
        """
        if self.journal is not None or self._doubted:
            return
        maker = ThreadPoolExecutor(1, "journal")
        self._begun = (maker, maker.submit(self._begin, session, save))
        maker.shutdown(wait=False)

    def _begin(self, session: str, save: str) -> Journal:
        """A new journal. Raises SessionError where another program has made one by now."""
        self._sync_folder()
        mode = permissions_of(self._path)
        return Journal.begun(self._folder / JOURNAL, session, save, mode)

    def replace_journal(self, session: str, save: str, steps: Sequence[Step] = ()) -> Path:
        """Have a new journal on this save, with these steps, in the place of the one that is there.

        Gives the name which that is kept aside as. Raises OutputError where that fails.
        """
        with self._closing_journal():
            mode = permissions_of(self._path)
            journal, aside = journal_files.replace(self._folder, session, save, mode, steps)
        self._journal = journal
        return aside

    @property
    def journal(self) -> Journal | None:
        """The journal this program writes to, waited for where it is being made."""
        if self._begun is not None:
            (maker, begun), self._begun = self._begun, None
            with maker, contextlib.suppress(SessionError, OutputError):
                self._journal = begun.result()  # and its thread has ended, not only its work
        return self._journal

    def set_journal_aside(self) -> Path:
        """Keep the journal under another name, so that a new one can begin; gives that name."""
        with self._closing_journal():
            return journal_files.set_aside(self._folder)

    def clear_journal(self) -> None:
        """Keep the journal aside of a session whose file was just replaced by another one.

        Where that fails, the file stands all the same: the first edit sees to it, and tells.
        """
        try:
            if self.has_files_of_journal:
                self.set_journal_aside()
        except OutputError:
            self._doubted = True

    @contextmanager
    def _closing_journal(self) -> Iterator[None]:
        """Close the journal after its files were moved.

        While they are in place, SQLite would take the log away with what it says after damage.
        """
        if sys.platform == "win32":  # open files cannot be moved there
            self._close_journal()
        try:
            yield
        finally:
            self._close_journal()

    def release(self, *, keep_journal: bool) -> None:
        """Give the session back, and take away what is needed no more.

        Where somebody took the lock away, another program may have edited: its journal stays.
        """
        journal = self.journal
        is_own = journal is not None and journal.is_as_written and self._lock.is_in_place
        self._close_journal()
        if is_own and not keep_journal:
            journal_files.remove(self._folder)
        with contextlib.suppress(OSError):
            self._lock.release()
        with contextlib.suppress(OSError):
            self._folder.rmdir()  # only succeeds where nothing is kept

    def _close_journal(self) -> None:
        journal, self._journal = self.journal, None
        if journal is not None:
            journal.close()


def _continues(journal: Journal, written: Journal) -> bool:
    """Whether a journal opened anew goes on where it ended; it is closed where nobody can tell."""
    try:
        return journal.continues(written)
    except BaseException:
        journal.close()
        raise


def is_open(path: Path) -> bool:
    """Whether a program has a session open for writing; raises OSError where nobody can tell."""
    return _lock_of(path).is_held


def lock_holder(path: Path) -> str:
    """Which program has a session open, in words."""
    return _lock_of(path).holder()


def _locked(path: Path) -> SessionLock:
    """The session's lock, taken; the folder it lies in is made where there is none."""
    lock = _lock_of(path)
    for tries_left in reversed(range(_TRIES)):
        make_folder(companions(path))
        try:
            taken = lock.acquire()
            break
        except FileNotFoundError:  # another program let go and took the empty folder away
            if not tries_left:
                raise
    if not taken:
        raise SessionError(
            "{path}: the session is open in {holder}; close it there first",
            path=path,
            holder=lock.holder(),
        )
    return lock


def _lock_of(path: Path) -> SessionLock:
    return SessionLock(companions(path) / "lock", permissions_of(path))
