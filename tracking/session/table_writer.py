"""Tables written into a session file piece by piece, so that none is in memory twice."""

from __future__ import annotations

import zlib
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.session.image_file import ImageFile
from tracking.session.layout import CHUNK_ROWS, TEXT, table_at
from tracking.tracks import ParticleColumn

_COMPRESSION = 1
"""gzip's quickest level: with bytes shuffled, higher ones gain a few percent at twice the time."""
_THREADS = 4
_STREAM_HEAD = b"\x78\x01"
"""Of what zlib packs with a window of 32 KiB, quickly."""
_AHEAD = 2 * _THREADS
"""How many packed pieces wait for the disk at most."""


@dataclass(frozen=True, slots=True)
class Packer:
    """Writes tables into one new file. All of it raises OSError where the disk refuses."""

    image: ImageFile

    def table(
        self,
        parent: h5py.Group,
        name: str,
        columns: Mapping[str, Any],
        *,
        noisy: bool = False,
    ) -> h5py.Group:
        """A group with the columns of the layout's table of that path, which gives their types.

        Numbers may be arrays or anything that is read by slices.

        noisy: see `column`.
        """
        group = parent.create_group(name)
        for column, dtype in table_at(group.name).columns.items():
            if dtype == TEXT:
                _write_text(group, column, columns[column])
            else:
                self.column(group, column, columns[column], dtype, noisy=noisy)
        return group

    def column(
        self,
        group: h5py.Group,
        name: str,
        values: ParticleColumn,
        dtype: np.dtype[Any],
        *,
        noisy: bool = False,
    ) -> h5py.Dataset:
        """A column in pieces of `CHUNK_ROWS`, bytes shuffled, then packed by gzip.

        Packed here, not by the HDF5 library: so it takes all cores, and reading other files does
        not wait, as the library does one thing at a time.

        noisy: drawn at random, as particles are, so that nothing in it comes twice; then packing
        looks for no repetitions, which takes a third of the time and a little less room.
        """
        if not len(values):
            return group.create_dataset(name, data=np.zeros(0, dtype))
        rows = min(CHUNK_ROWS, len(values))
        dataset = group.create_dataset(
            name,
            shape=(len(values),),
            dtype=dtype,
            chunks=(rows,),
            compression="gzip",
            compression_opts=_COMPRESSION,
            shuffle=True,
        )
        packed = partial(_packed_noise if noisy else _packed, dtype=dtype, rows=rows)
        for start, piece in _pieces(values, rows, packed):
            self.image.put(dataset, start, piece)
        return dataset


def _pieces(
    values: ParticleColumn, rows: int, packed: Callable[[NDArray[Any]], bytes]
) -> Iterator[tuple[int, bytes]]:
    """The packed pieces in order, a few of them made ahead by other threads."""
    if len(values) == rows:
        yield 0, packed(values[0:rows])
        return
    waiting: deque[tuple[int, Future[bytes]]] = deque()
    with ThreadPoolExecutor(_THREADS) as pool:
        for start in range(0, len(values), rows):
            piece = values[start : start + rows]
            waiting.append((start, pool.submit(packed, piece)))
            if len(waiting) == _AHEAD:
                first, done = waiting.popleft()
                yield first, done.result()
        for first, done in waiting:
            yield first, done.result()


def _packed(values: NDArray[Any], dtype: np.dtype[Any], rows: int) -> bytes:
    """What the library's shuffle and gzip filters make of a piece; the last one is filled up."""
    return zlib.compress(_shuffled(values, dtype, rows), _COMPRESSION)


def _packed_noise(values: NDArray[Any], dtype: np.dtype[Any], rows: int) -> bytes:
    """The same for numbers drawn at random: the bytes of each place are packed as suits them.

    What they give is one stream, as any reader of gzip expects it.
    """
    shuffled = _shuffled(values, dtype, rows)
    parts = [_STREAM_HEAD]
    for stop in range(rows, len(shuffled) + 1, rows):
        end = zlib.Z_FINISH if stop == len(shuffled) else zlib.Z_SYNC_FLUSH
        parts.append(_deflated(shuffled[stop - rows : stop], end))
    return b"".join((*parts, zlib.adler32(shuffled).to_bytes(4, "big")))


def _shuffled(values: NDArray[Any], dtype: np.dtype[Any], rows: int) -> bytes:
    """All first bytes of the numbers, then all second ones and so on."""
    padded = np.zeros(rows, dtype)
    padded[: len(values)] = values
    return padded.view(np.uint8).reshape(rows, dtype.itemsize).T.tobytes()


def _deflated(plane: bytes, end: int) -> bytes:
    """The bytes of one place; `end`: how zlib is to end the part."""
    values = np.frombuffer(plane, np.uint8)
    changes = np.count_nonzero(values[1:] != values[:-1])
    if not changes:
        return _constant(plane[0], len(plane), end)
    return _raw(plane, zlib.Z_RLE if changes < len(plane) // 2 else zlib.Z_HUFFMAN_ONLY, end)


@lru_cache(64)
def _constant(byte: int, count: int, end: int) -> bytes:
    return _raw(bytes([byte]) * count, zlib.Z_RLE, end)


def _raw(data: bytes, strategy: int, end: int) -> bytes:
    """A part of a stream, which begins and ends at a byte."""
    deflate = zlib.compressobj(
        _COMPRESSION, zlib.DEFLATED, -zlib.MAX_WBITS, zlib.DEF_MEM_LEVEL + 1, strategy
    )
    return deflate.compress(data) + deflate.flush(end)


def _write_text(group: h5py.Group, name: str, texts: Sequence[str]) -> None:
    dtype = h5py.string_dtype()
    group.create_dataset(
        name, data=np.array(texts, object) if texts else None, dtype=dtype, shape=(len(texts),)
    )
