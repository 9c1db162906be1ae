"""Columns read from a session file, their pieces unpacked by several threads at once."""

from __future__ import annotations

import zlib
from collections import deque
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

_PACKING = (h5py.h5z.FILTER_SHUFFLE, h5py.h5z.FILTER_DEFLATE)
_THREADS = 4
_AHEAD = 4 * _THREADS
"""How many packed pieces wait to be unpacked at most."""


def unpackers() -> ThreadPoolExecutor:
    """Threads that unpack, for all columns of a table; they are started when there is work."""
    return ThreadPoolExecutor(_THREADS, "unpack")


def read_numbers(
    dataset: h5py.Dataset, dtype: np.dtype[Any], pool: ThreadPoolExecutor
) -> NDArray[Any]:
    """A column of numbers.

    One packed as this program packs is unpacked in the pool: the HDF5 library uses one core and
    does one thing at a time.
    Raises ValueError where a piece is damaged, and what the library raises.
    """
    values = np.empty(dataset.shape, dtype)
    if not values.size:
        return values
    if _is_packed_as_here(dataset, dtype):
        _read_pieces(dataset, values, pool)
    else:
        dataset.read_direct(values)
    return values


def _is_packed_as_here(dataset: h5py.Dataset, dtype: np.dtype[Any]) -> bool:
    if dataset.ndim != 1 or dataset.chunks is None or dataset.dtype != dtype:
        return False
    how = dataset.id.get_create_plist()
    filters = tuple(how.get_filter(at)[0] for at in range(how.get_nfilters()))
    pieces: int = dataset.id.get_num_chunks()
    return filters == _PACKING and pieces == -(-len(dataset) // dataset.chunks[0])


def _read_pieces(dataset: h5py.Dataset, values: NDArray[Any], pool: ThreadPoolExecutor) -> None:
    rows, waiting = dataset.chunks[0], deque[Future[None]]()
    try:
        for start in range(0, len(values), rows):
            skipped, piece = dataset.id.read_direct_chunk((start,))
            if skipped:
                raise ValueError(f"{dataset.name}: a piece is packed otherwise than the others")
            into = values[start : start + rows]
            if len(values) <= rows:  # nothing is gained by another thread
                _unpack(piece, into, rows)
                return
            waiting.append(pool.submit(_unpack, piece, into, rows))
            if len(waiting) == _AHEAD:
                waiting.popleft().result()
        for unpacked in waiting:
            unpacked.result()
    finally:
        for unpacked in waiting:
            unpacked.cancel()


def _unpack(piece: bytes, into: NDArray[Any], rows: int) -> None:
    """Undo deflate, then shuffle, into a stretch of the column."""
    size, width = rows * into.itemsize, into.itemsize
    inflater = zlib.decompressobj()
    try:
        plain = inflater.decompress(piece, size + 1)
    except zlib.error as why:
        raise ValueError(f"a piece cannot be unpacked: {why}") from why
    if len(plain) != size:
        raise ValueError(f"a piece unpacks to {len(plain)} bytes, not {size}")
    by_byte = np.frombuffer(plain, np.uint8).reshape(width, rows)[:, : len(into)]
    if into.dtype == np.bool_:
        into[:] = by_byte[0] != 0
    else:
        into.view(np.uint8).reshape(len(into), width)[:] = by_byte.T
