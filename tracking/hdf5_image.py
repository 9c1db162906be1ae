"""A new HDF5 file on its way to the disk, in little memory and out of reach of a full disk."""

from __future__ import annotations

import errno
import hashlib
import io
import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from tracking.owned_files import SAFE_FLAGS
from tracking.translation import msg

if TYPE_CHECKING:
    from h5py import Dataset

_PAGE = 1 << 16
_PIECE = 8 << 20
_READ_BACK = msg("what was written reads back")
_CHECK = msg("check the disk")


class Hdf5Image:
    """What h5py writes a file into: `h5py.File(image, "w")`.

    A disk that fails while the HDF5 library writes or closes leaves the library broken: the
    program crashes then, or later. So nothing the library does here touches the disk, and nothing
    of it can fail: it lays the file out, and what it writes by itself (names, attributes, text,
    where each piece lies: little) is held in memory. The packed pieces of the columns come by
    `put`: the library gives them their places, and then they are written there by plain calls.
    """

    def __init__(self, path: Path) -> None:
        """Make the file. Raises OSError where that fails."""
        self._path = path
        self._handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | SAFE_FLAGS, 0o666)
        self._at = self._size = 0
        self._pages: dict[int, bytearray] = {}
        self._held: list[tuple[int, int]] = []
        self._awaited: bytes | None = None
        self._place: int | None = None
        self._digests: list[tuple[int, int, bytes]] = []

    # what h5py asks of a file; none of it fails

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        """Go to a place."""
        self._at = offset + {os.SEEK_CUR: self._at, os.SEEK_END: self._size}.get(whence, 0)
        return self._at

    def tell(self) -> int:
        """Where it stands."""
        return self._at

    def read(self, size: int = -1) -> bytes:
        """What the library wrote by itself; zeros elsewhere."""
        stop = self._size if size < 0 else min(self._at + size, self._size)
        parts = [bytes(self._page(page)[low:high]) for page, low, high in _in_pages(self._at, stop)]
        self._at = max(stop, self._at)
        return b"".join(parts)

    def readinto(self, buffer: bytearray | memoryview) -> int:
        """The same into a buffer."""
        found = self.read(len(buffer))
        buffer[: len(found)] = found
        return len(found)

    def write(self, data: bytes | memoryview) -> int:
        """Hold what the library writes; of an awaited piece only note its place."""
        start, stop = self._at, self._at + len(data)
        self._at, self._size = stop, max(self._size, stop)
        if self._is_awaited(data):
            self._place, self._awaited = start, None
            return len(data)
        done = 0
        for page, low, high in _in_pages(start, stop):
            self._page(page)[low:high] = data[done : done + high - low]
            done += high - low
        self._held.append((start, stop))
        return len(data)

    def truncate(self, size: int | None = None) -> int:
        """Be as long as that."""
        self._size = self._at if size is None else size
        return self._size

    def flush(self) -> None:
        """Nothing waits."""

    # what the disk is asked for; everything of it may fail

    def put(self, dataset: Dataset, start: int, piece: bytes) -> None:
        """Write the packed piece of a column that begins at row `start`. Raises OSError."""
        place = self._place_of(dataset, start, piece)
        if place is not None:  # else the library kept it, and it is held with the rest
            self._digests.append((place, len(piece), _digest(piece)))
            self._write_at(place, piece)

    def _place_of(self, dataset: Dataset, start: int, piece: bytes) -> int | None:
        self._awaited, self._place = piece, None
        dataset.id.write_direct_chunk((start,), piece)
        self._awaited = None
        return self._place

    def pieces(self) -> list[tuple[int, int]]:
        """Where the packed pieces lie, start and end; those that touch are one."""
        return list(joined([(place, place + size) for place, size, _ in self._digests]))

    def held_between(self, start: int, stop: int) -> bytes:
        """What the library wrote by itself there."""
        return b"".join(self._page(page)[low:high] for page, low, high in _in_pages(start, stop))

    def finish(self) -> None:
        """Write what is held, and see to it that all is on the disk. Raises OSError."""
        for start, stop in joined(self._held):
            self._write_at(start, self.held_between(start, stop))
        os.ftruncate(self._handle, self._size)
        os.fsync(self._handle)

    def verify(self) -> None:
        """Read the file back: what the disk holds must be what was meant. Raises OSError."""
        with self._path.open("rb", buffering=0) as written:
            size = written.seek(0, os.SEEK_END)
            if size != self._size:
                raise OSError(
                    errno.EIO,
                    msg(
                        "{read_back} with {size} bytes; {check}",
                        read_back=_READ_BACK,
                        size=size,
                        check=_CHECK,
                    ),
                )
            for start, length, digest in self._expected():
                written.seek(start)
                if _digest_of(written, length) != digest:
                    raise OSError(
                        errno.EIO,
                        msg("{read_back} otherwise; {check}", read_back=_READ_BACK, check=_CHECK),
                    )

    def close(self) -> None:
        """Let go of the file."""
        os.close(self._handle)

    def _is_awaited(self, data: bytes | memoryview) -> bool:
        awaited = self._awaited
        return awaited is not None and len(data) == len(awaited) and bytes(data) == awaited

    def _expected(self) -> Iterator[tuple[int, int, bytes]]:
        yield from self._digests
        for start, stop in joined(self._held):
            yield start, stop - start, _digest(self.held_between(start, stop))

    def _page(self, number: int) -> bytearray:
        page = self._pages.get(number)
        if page is None:
            page = self._pages[number] = bytearray(_PAGE)
        return page

    def _write_at(self, place: int, data: bytes) -> None:
        os.lseek(self._handle, place, os.SEEK_SET)
        rest = memoryview(data)
        while rest:
            rest = rest[os.write(self._handle, rest[:_PIECE]) :]


def _in_pages(start: int, stop: int) -> Iterator[tuple[int, int, int]]:
    """The pages of a stretch of bytes: number, first and end byte in the page."""
    while start < stop:
        page, low = divmod(start, _PAGE)
        high = min(_PAGE, low + stop - start)
        yield page, low, high
        start += high - low


def joined(stretches: list[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    """Stretches that touch or overlap as one, ascending."""
    whole: tuple[int, int] | None = None
    for start, stop in sorted(stretches):
        if whole is not None and start <= whole[1]:
            whole = whole[0], max(whole[1], stop)
            continue
        if whole is not None:
            yield whole
        whole = start, stop
    if whole is not None:
        yield whole


def _digest(data: bytes) -> bytes:
    return hashlib.blake2b(data, digest_size=16).digest()


def _digest_of(file: io.FileIO, length: int) -> bytes:
    """The digest of the next bytes of a file."""
    seen = hashlib.blake2b(digest_size=16)
    while length and (piece := file.read(min(length, _PIECE))):
        seen.update(piece)
        length -= len(piece)
    return seen.digest()
