"""Tables written into a session file piece by piece, so that none is in memory twice."""

from __future__ import annotations

import zlib
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.session.image_file import ImageFile
from tracking.session.layout import CHUNK_ROWS, TEXT, Types
from tracking.tracks import ParticleColumn

_COMPRESSION = 1
"""gzip's quickest level: with bytes shuffled, higher ones gain a few percent at twice the time."""
_THREADS = 4
_AHEAD = 2 * _THREADS
"""How many packed pieces wait for the disk at most."""


@dataclass(frozen=True, slots=True)
class Packer:
    """Writes tables into one new file. All of it raises OSError where the disk refuses."""

    image: ImageFile

    def table(
        self, parent: h5py.Group, name: str, types: Types, columns: Mapping[str, Any]
    ) -> h5py.Group:
        """A group with the columns; numbers may be arrays or anything that is read by slices."""
        group = parent.create_group(name)
        for column, dtype in types.items():
            if dtype == TEXT:
                _write_text(group, column, columns[column])
            else:
                self.column(group, column, columns[column], dtype)
        return group

    def column(
        self, group: h5py.Group, name: str, values: ParticleColumn, dtype: np.dtype[Any]
    ) -> h5py.Dataset:
        """A column in pieces of `CHUNK_ROWS`, bytes shuffled, then packed by gzip.

        Packed here, not by the HDF5 library: so it takes all cores, and reading other files does
        not wait, as the library does one thing at a time.
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
        for start, piece in _pieces(values, dtype, rows):
            self.image.put(dataset, start, piece)
        return dataset


def _pieces(values: ParticleColumn, dtype: np.dtype[Any], rows: int) -> Iterator[tuple[int, bytes]]:
    """The packed pieces in order, a few of them made ahead by other threads."""
    if len(values) == rows:
        yield 0, _packed(values[0:rows], dtype, rows)
        return
    waiting: deque[tuple[int, Future[bytes]]] = deque()
    with ThreadPoolExecutor(_THREADS) as pool:
        for start in range(0, len(values), rows):
            piece = values[start : start + rows]
            waiting.append((start, pool.submit(_packed, piece, dtype, rows)))
            if len(waiting) == _AHEAD:
                first, packed = waiting.popleft()
                yield first, packed.result()
        for first, packed in waiting:
            yield first, packed.result()


def _packed(values: NDArray[Any], dtype: np.dtype[Any], rows: int) -> bytes:
    """What the library's shuffle and gzip filters make of a piece; the last one is filled up."""
    padded = np.zeros(rows, dtype)
    padded[: len(values)] = values
    if dtype.itemsize == 1:
        return zlib.compress(padded.tobytes(), _COMPRESSION)
    by_byte = padded.view(np.uint8).reshape(rows, dtype.itemsize)
    return zlib.compress(by_byte.T.tobytes(), _COMPRESSION)


def _write_text(group: h5py.Group, name: str, texts: Sequence[str]) -> None:
    dtype = h5py.string_dtype()
    group.create_dataset(
        name, data=np.array(texts, object) if texts else None, dtype=dtype, shape=(len(texts),)
    )
