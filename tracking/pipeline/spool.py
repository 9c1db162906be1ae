"""Bytes put aside while a tracker works: in memory, then in a file without a name."""

from __future__ import annotations

import errno
import mmap
import os
import shutil
import tempfile
import weakref
from pathlib import Path
from threading import Lock

from platformdirs import user_cache_path

from tracking.errors import OutputError
from tracking.translation import msg

IN_MEMORY_BYTES = 32 << 20
"""So much is held without any file: most recordings are short."""
LEAST_FREE_BYTES = 256 << 20
"""What is left of the disk, which others write to as well."""


class Spool:
    """Bytes that are appended and read again.

    The file has no name: the system takes it away when the last who uses it is gone, also where
    the program is killed. `append` belongs to one thread; `read` may be called from any. Both
    raise OutputError where the disk refuses.
    """

    def __init__(self, folder: Path | None = None, in_memory: int = IN_MEMORY_BYTES) -> None:
        """Nothing is written yet.

        Args:
            folder: where the file may lie; None takes the user's folder for what can be made again.
            in_memory: bytes from which on there is a file.
        """
        self._folder, self._in_memory = folder, in_memory
        self._held = bytearray()
        self._handle: int | None = None
        self._size = 0
        self._lock = Lock()

    @property
    def is_on_disk(self) -> bool:
        """Whether there is a file."""
        return self._handle is not None

    @property
    def size(self) -> int:
        """How many bytes were appended."""
        return self._size

    def append(self, data: bytes, *, to_map: bool = False) -> int:
        """Add bytes; gives where they begin. to_map: there they can be mapped."""
        if to_map:
            self.append(bytes(-self._size % mmap.ALLOCATIONGRANULARITY))
        place = self._size
        with self._lock:
            if self._handle is None and place + len(data) > self._in_memory:
                self._begin_file()
            if self._handle is None:
                self._held += data
            else:
                self._write(self._handle, place, data)
            self._size += len(data)
        return place

    def read(self, place: int, size: int) -> bytes:
        """So many bytes from a place on."""
        with self._lock:
            if self._handle is None:
                return bytes(self._held[place : place + size])
            return _read(self._handle, place, size)

    def mapped(self, place: int, size: int) -> bytes | mmap.mmap:
        """The same of bytes that were appended to be mapped, which then take no memory."""
        with self._lock:
            if self._handle is None:
                return bytes(self._held[place : place + size])
            try:
                return mmap.mmap(self._handle, size, access=mmap.ACCESS_READ, offset=place)
            except OSError as why:
                raise _unreadable(why) from why

    def _begin_file(self) -> None:
        """Put what is held into a file."""
        folder = self._folder = self._folder or _usual_folder()
        try:
            # POSIX takes its name away at once, Windows when its last handle is closed.
            with tempfile.TemporaryFile(dir=folder) as file:
                handle = os.dup(file.fileno())
        except OSError as why:
            raise _refused(folder, why) from why
        weakref.finalize(self, os.close, handle)
        self._write(handle, 0, bytes(self._held))
        self._handle, self._held = handle, bytearray()

    def _write(self, handle: int, place: int, data: bytes) -> None:
        folder = self._folder or _usual_folder()
        try:
            if shutil.disk_usage(folder).free < LEAST_FREE_BYTES + len(data):
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            os.lseek(handle, place, os.SEEK_SET)
            rest = memoryview(data)
            while rest:
                rest = rest[os.write(handle, rest) :]
        except OSError as why:
            raise _refused(folder, why) from why


def _read(handle: int, place: int, size: int) -> bytes:
    parts = []
    try:
        os.lseek(handle, place, os.SEEK_SET)
        while size:
            part = os.read(handle, size)
            if not part:
                raise OSError(errno.EIO, os.strerror(errno.EIO))
            parts.append(part)
            size -= len(part)
    except OSError as why:
        raise _unreadable(why) from why
    return b"".join(parts)


def _usual_folder() -> Path:
    """The user's folder for what can be made again, which lies on a disk; else the temporary one.

    The temporary folder comes second, as on many systems it lies in memory.
    """
    folder = user_cache_path("trackwright", appauthor=False)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        return Path(tempfile.gettempdir())
    return folder if os.access(folder, os.W_OK) else Path(tempfile.gettempdir())


def _unreadable(why: OSError) -> OutputError:
    return OutputError(
        "the particles put aside cannot be read: {reason}",
        "check the disk and track again",
        reason=why.strerror,
    )


def _refused(folder: Path, why: OSError) -> OutputError:
    full = why.errno in (errno.ENOSPC, errno.EDQUOT)
    reason = msg("too little space is left") if full else why.strerror or str(why)
    return OutputError(
        "{folder}: particles cannot be put aside while tracking: {reason}",
        "make room there, or track a shorter range",
        folder=folder,
        reason=reason,
    )
