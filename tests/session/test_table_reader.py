from __future__ import annotations

import contextlib
import zlib
from pathlib import Path

import h5py
import numpy as np
import pytest

from tracking.errors import SessionError
from tracking.session.hdf5 import open_readonly
from tracking.session.table_reader import PendingColumns

KINDS = [np.bool_, np.uint8, np.int32, np.int64, np.float32, np.float64]


def column(rows: int, kind: type) -> np.ndarray:
    return np.random.default_rng(3104).integers(0, 2, rows).astype(kind) * kind(1)


def read_numbers(dataset: h5py.Dataset) -> np.ndarray:
    with PendingColumns() as unpacking:
        values = unpacking.read(dataset, np.dtype(np.float64))
        unpacking.finish()
    return values


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("rows", [0, 1, 999, 1000, 1001, 40_000])
@pytest.mark.parametrize(
    "packing",
    [
        {"chunks": (1000,), "compression": "gzip", "shuffle": True},
        {"chunks": (1000,), "compression": "gzip"},
        {"chunks": (1000,), "shuffle": True},
        {"chunks": (1000,)},
        {},
    ],
)
def test_a_column_reads_the_same_however_it_is_packed(tmp_path, kind, rows, packing):
    values = column(rows, kind)
    with h5py.File(tmp_path / "s.h5", "w") as file:
        file.create_dataset("x", data=values, maxshape=(None,) if packing else None, **packing)
    with h5py.File(tmp_path / "s.h5") as file, PendingColumns() as unpacking:
        read = unpacking.read(file["x"], np.dtype(kind))
        unpacking.finish()
    assert read.dtype == values.dtype
    assert read.tobytes() == values.tobytes()


def test_pieces_that_were_never_written_read_as_the_library_fills_them(tmp_path):
    packed = {"chunks": (1000,), "compression": "gzip", "shuffle": True}
    with h5py.File(tmp_path / "s.h5", "w") as file:
        file.create_dataset("x", shape=(5000,), dtype=np.float64, fillvalue=7.0, **packed)
        file["x"][:1000] = 1.0
    with h5py.File(tmp_path / "s.h5") as file, PendingColumns() as unpacking:
        read = unpacking.read(file["x"], np.dtype(np.float64))
        unpacking.finish()
    assert read.tolist() == [1.0] * 1000 + [7.0] * 4000


def write_with_piece(path: Path, piece: bytes, skipped: int = 0) -> None:
    with h5py.File(path, "w") as file:
        dataset = file.create_dataset(
            "t/x", shape=(3000,), dtype=np.float64, chunks=(1000,), compression="gzip", shuffle=True
        )
        dataset[:] = 1.0
        dataset.id.write_direct_chunk((1000,), piece, filter_mask=skipped)


@pytest.mark.parametrize(
    ("piece", "skipped", "said"),
    [
        (b"no zlib at all", 0, "cannot be unpacked"),
        (b"x\x9c\x03\x00\x00\x00\x00\x01", 0, "unpacks to 0 bytes"),
        (bytes(8000), 3, "packed otherwise"),
        (zlib.compress(bytes(8000))[:-4], 0, "does not end where it should"),
        (zlib.compress(bytes(8000)) + b"more", 0, "does not end where it should"),
    ],
)
def test_a_damaged_piece_is_told_and_read_as_nothing(tmp_path, piece, skipped, said):
    path = tmp_path / "s.h5"
    write_with_piece(path, piece, skipped)
    with pytest.raises(SessionError, match=said), open_readonly(path) as file:
        read_numbers(file["t/x"])


def test_a_piece_that_unpacks_to_far_too_much_is_not_unpacked_whole(tmp_path):
    path = tmp_path / "s.h5"
    write_with_piece(path, zlib.compress(bytes(50_000_000)))
    with pytest.raises(SessionError, match="unpacks to 8001 bytes"), open_readonly(path) as file:
        read_numbers(file["t/x"])


def test_every_flipped_bit_of_a_piece_is_told_or_changes_nothing(tmp_path):
    path = tmp_path / "s.h5"
    values = np.linspace(5.39, 5.4, 1000)
    values[10:] = values[10]
    shuffled = np.ascontiguousarray(values.view(np.uint8).reshape(1000, 8).T).tobytes()
    packed = zlib.compress(shuffled)
    for bit in range(8 * len(packed)):
        piece = bytearray(packed)
        piece[bit // 8] ^= 1 << bit % 8
        write_with_piece(path, bytes(piece))
        with contextlib.suppress(SessionError), open_readonly(path) as file:
            read = read_numbers(file["t/x"])
            assert read[1000:2000].tolist() == values.tolist(), bit
