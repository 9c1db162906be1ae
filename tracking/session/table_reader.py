"""Columns read from a session file, their pieces unpacked by several threads at once."""

from __future__ import annotations

import zlib
from collections import deque
from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Self

import h5py
import numpy as np
from numpy.typing import NDArray

_PACKING = (h5py.h5z.FILTER_SHUFFLE, h5py.h5z.FILTER_DEFLATE)
_THREADS = 4
_AHEAD = 4 * _THREADS
"""How many packed pieces wait to be unpacked at most."""
_FEW_ROWS, _FEW_PIECES = 16_384, 3
"""Pieces of so few rows are handed to threads together: alone each is not worth it."""

_Packed = tuple[bytes, NDArray[Any], int]
"""A packed piece, the stretch of a column it belongs into, and the rows of a whole piece."""


class PendingColumns:
    """Columns on their way into memory; `finish` says when they are there.

    What was packed as this program packs is unpacked by threads while further columns are read:
    the HDF5 library uses one core and does one thing at a time. As a context manager it ends with
    its threads gone, whatever happened.
    """

    def __init__(self) -> None:
        """Threads are started when there is work."""
        self._pool: ThreadPoolExecutor | None = None
        self._waiting: deque[Future[None]] = deque()
        self._small: list[_Packed] = []

    def __enter__(self) -> Self:
        """Itself."""
        return self

    def __exit__(self, *_: object) -> None:
        """Give up what was not finished."""
        if self._pool is not None:
            self._pool.shutdown(cancel_futures=True)

    def read(self, dataset: h5py.Dataset, dtype: np.dtype[Any]) -> NDArray[Any]:
        """A column of numbers; its values count after `finish`.

        Raises ValueError where a piece is damaged, and what the library raises.
        """
        values = np.empty(dataset.shape, dtype)
        if not values.size:
            return values
        if _is_packed_as_here(dataset, dtype):
            self._read_pieces(dataset, values)
        else:
            dataset.read_direct(values)
        return values

    def finish(self) -> None:
        """Wait for all columns read so far. Raises ValueError where a piece is damaged."""
        self._unpack_small()
        while self._waiting:
            self._waiting.popleft().result()

    def _read_pieces(self, dataset: h5py.Dataset, values: NDArray[Any]) -> None:
        rows = dataset.chunks[0]
        for start in range(0, len(values), rows):
            skipped, piece = dataset.id.read_direct_chunk((start,))
            if skipped:
                raise ValueError(f"{dataset.name}: a piece is packed otherwise than the others")
            into = values[start : start + rows]
            if rows <= _FEW_ROWS:
                self._small.append((piece, into, rows))
            else:
                self._submit([(piece, into, rows)])

    def _submit(self, packed: Sequence[_Packed]) -> None:
        self._pool = self._pool or ThreadPoolExecutor(_THREADS, "unpack")
        self._waiting.append(self._pool.submit(_unpack_all, packed))
        if len(self._waiting) == _AHEAD:
            self._waiting.popleft().result()

    def _unpack_small(self) -> None:
        """One half of them by a thread, the other half meanwhile here."""
        small, self._small = self._small, []
        half = len(small) // 2
        if half >= _FEW_PIECES:
            self._submit(small[:half])
        else:
            half = 0
        _unpack_all(small[half:])


def _is_packed_as_here(dataset: h5py.Dataset, dtype: np.dtype[Any]) -> bool:
    how, shape = dataset.id.get_create_plist(), dataset.shape
    if len(shape) != 1 or how.get_layout() != h5py.h5d.CHUNKED or dataset.dtype != dtype:
        return False
    filters = tuple(how.get_filter(at)[0] for at in range(how.get_nfilters()))
    pieces: int = dataset.id.get_num_chunks()
    return filters == _PACKING and pieces == -(-shape[0] // how.get_chunk()[0])


def _unpack_all(packed: Sequence[_Packed]) -> None:
    for piece, into, rows in packed:
        _unpack(piece, into, rows)


def _unpack(piece: bytes, into: NDArray[Any], rows: int) -> None:
    """Undo deflate, then shuffle, into a stretch of the column."""
    size, width = rows * into.itemsize, into.itemsize
    inflater = zlib.decompressobj()
    try:
        plain = inflater.decompress(piece, size + 1)
    except zlib.error as why:
        raise ValueError("a piece cannot be unpacked: its bytes are damaged") from why
    if len(plain) != size:
        raise ValueError(f"a piece unpacks to {len(plain)} bytes, not {size}")
    if not inflater.eof or inflater.unused_data:  # its checksum, at the end, was not compared
        raise ValueError("a piece does not end where it should: its bytes are damaged")
    by_byte = np.frombuffer(plain, np.uint8).reshape(width, rows)[:, : len(into)]
    if into.dtype == np.bool_:
        into[:] = by_byte[0] != 0
    else:
        bytes_of = into.view(np.uint8).reshape(len(into), width)
        for at in range(width):
            bytes_of[:, at] = by_byte[at]
