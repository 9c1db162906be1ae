"""How many steps a journal holds, told beside it: so a journal that has lost some is found out.

SQLite drops what stands at the end of a damaged log without a word. This file says after each step
how many there are. It is written without waiting for the disk: after a power cut it may say too
few, which only means that it cannot tell. It says on which save they build, so that one that is
left from before counts for nothing.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import zlib
from pathlib import Path

from tracking.errors import UnsafeFileError
from tracking.owned_files import open_file
from tracking.session.journal_limits import MOST_COUNT_BYTES

_NAME_BYTES = 16


class StepCount:
    """The file with the count. What goes wrong with it is passed over: no edit depends on it."""

    def __init__(self, path: Path, mode: int) -> None:
        """Open or make it. mode: the permissions of a new one."""
        self._handle: int | None = None
        with contextlib.suppress(OSError, UnsafeFileError):
            flags = os.O_RDWR | os.O_CREAT
            self._handle = open_file(path, flags, mode, most_bytes=MOST_COUNT_BYTES)

    def write(self, session: str, save: str, steps: int) -> None:
        """Say how many steps there are on a save."""
        if self._handle is not None:
            with contextlib.suppress(OSError):
                os.lseek(self._handle, 0, os.SEEK_SET)
                line = _line(session, save, steps)
                while line:  # a system may write less than it is given
                    line = line[os.write(self._handle, line) :]

    def read(self, session: str, save: str) -> int:
        """How many steps there were on a save; 0 where it does not say."""
        if self._handle is None:
            return 0
        try:
            os.lseek(self._handle, 0, os.SEEK_SET)
            line = os.read(self._handle, MOST_COUNT_BYTES)
            steps = int(line.split()[1])
        except (OSError, ValueError, IndexError):
            return 0
        return steps if line == _line(session, save, steps) else 0

    def close(self) -> None:
        """Let go of the file."""
        if self._handle is not None:
            with contextlib.suppress(OSError):
                os.close(self._handle)
            self._handle = None


def _line(session: str, save: str, steps: int) -> bytes:
    """Always as long, so that one written over another leaves nothing of it."""
    named = f"{len(session)} {session} {save}".encode("utf-8", "surrogatepass")
    said = f"{hashlib.blake2b(named, digest_size=_NAME_BYTES).hexdigest()} {steps:010d}"
    return f"{said} {zlib.crc32(said.encode()):08x}\n".encode()
