"""One program at a time writes a session: a lock that ends with the program that holds it."""

from __future__ import annotations

import contextlib
import json
import os
import platform
import sys
from pathlib import Path


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

    def __init__(self, path: Path) -> None:
        """The path of the lock file; its folder exists."""
        self._path = path
        self._handle: int | None = None

    def acquire(self) -> bool:
        """Take the lock; False where another program (or this one, once more) holds it.

        Raises OSError where the file cannot be written.
        """
        handle = os.open(self._path, os.O_RDWR | os.O_CREAT, 0o644)
        try:
            taken = _lock(handle)
        except OSError:  # a disk that knows no locks
            os.close(handle)
            raise
        if not taken:
            os.close(handle)
            return False
        if os.fstat(handle).st_nlink == 0:  # its holder just let go and took the name with it
            os.close(handle)
            return self.acquire()
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
            handle = os.open(self._path, os.O_RDWR)
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
            with self._path.open("rb") as file:
                file.seek(1)
                said = json.loads(file.read(4096))
            return f"process {int(said['process'])} on {str(said['computer'])[:80]}"
        except (OSError, ValueError, LookupError, TypeError, OverflowError, RecursionError):
            return "another program"

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
        if own and sys.platform != "win32":  # there, an open file cannot be deleted
            self._path.unlink(missing_ok=True)
        self.let_go()
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
