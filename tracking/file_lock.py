"""One program at a time writes a session: a lock that ends with the program that holds it."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import platform
import sys
from pathlib import Path

from tracking.errors import SessionError
from tracking.owned_files import open_file
from tracking.translation import msg

_MOST_HOLDER_BYTES = 4096
"""Of what the lock says about its holder: a number and a computer's name."""
_LONGEST_COMPUTER = 80
_TRIES = 100
"""Of taking a lock whose holder takes its file away at that moment."""


def identity(file: Path | int) -> tuple[int, int] | None:
    """Which file it is, by its path or handle, whatever it is called; None where there is none."""
    try:
        state = os.fstat(file) if isinstance(file, int) else file.stat()
    except OSError:
        return None
    return state.st_dev, state.st_ino


class SessionLock:
    """A lock file held by the operating system, so that a program that dies leaves none behind.

    The file says who holds it, for the message to whoever comes second.
    """

    def __init__(self, path: Path, mode: int = 0o600) -> None:
        """The path of the lock file; its folder exists. mode: of the file where it is made."""
        self._path = path
        self._mode = mode
        self._handle: int | None = None

    def acquire(self) -> bool:
        """Take the lock; False where another program (or this one, once more) holds it.

        Raises OSError where the file cannot be written, UnsafeFileError where it is a link, a
        pipe, another user's, or not a regular file under one name.
        """
        for _ in range(_TRIES):
            handle = open_file(self._path, os.O_RDWR | os.O_CREAT, self._mode)
            try:
                if not _lock(handle):
                    os.close(handle)
                    return False
            except OSError:  # a disk that knows no locks
                os.close(handle)
                raise
            if identity(self._path) == identity(handle):
                break
            os.close(handle)  # its holder just let go and took the name with it
        else:
            raise OSError(errno.ESTALE, "the lock is never the file that was locked")
        self._handle = handle
        # The first byte is the one that is locked; others must be able to read what follows.
        holder = json.dumps({"process": os.getpid(), "computer": platform.node()})
        with contextlib.suppress(OSError):  # no room to say who: the lock holds all the same
            os.ftruncate(handle, 0)
            os.write(handle, b" " + holder.encode())
        return True

    @property
    def is_held(self) -> bool:
        """Whether a program has the lock right now; nothing is written.

        Raises OSError as `acquire` does.
        """
        try:
            handle = open_file(self._path, os.O_RDWR)
        except FileNotFoundError:
            return False
        try:
            return not _lock(handle)
        finally:
            os.close(handle)  # which gives the lock back

    @property
    def is_in_place(self) -> bool:
        """Whether the file that is locked still is the one at its path."""
        return self._handle is not None and identity(self._path) == identity(self._handle)

    def holder(self) -> str:
        """Who holds the lock, in words."""
        try:
            said = json.loads(self._said())
            computer = "".join(filter(str.isprintable, str(said["computer"])))
            return f"process {int(said['process'])} on {computer[:_LONGEST_COMPUTER]}"
        except (
            *(OSError, SessionError, ValueError, LookupError),
            *(TypeError, OverflowError, RecursionError),
        ):
            return msg("another program")

    def _said(self) -> bytes:
        """What stands after the byte that is locked."""
        with os.fdopen(open_file(self._path), "rb") as file:
            file.seek(1)
            return file.read(_MOST_HOLDER_BYTES)

    def let_go(self) -> None:
        """Give the lock back where its file is another's by now, or out of reach."""
        if self._handle is not None:
            with contextlib.suppress(OSError):
                os.close(self._handle)
            self._handle = None

    def release(self) -> None:
        """Give the lock back and take its file away."""
        if self._handle is None:
            return
        own = self.is_in_place
        try:
            if own and sys.platform != "win32":  # there, an open file cannot be deleted
                self._path.unlink(missing_ok=True)
        finally:
            self.let_go()  # a file that stays is locked by nobody
        if own and sys.platform == "win32":
            self._path.unlink(missing_ok=True)


if sys.platform == "win32":
    import msvcrt

    def _lock(handle: int) -> bool:
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

else:
    import fcntl

    def _lock(handle: int) -> bool:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True
