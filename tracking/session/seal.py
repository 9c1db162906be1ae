"""A seal on sessions this user's own program saved: they need not be looked over again.

What makes an HDF5 file dangerous is its structure: names, types, attributes, text, and where each
packed piece of a column lies. A save ends the file with a seal over all of that, every byte but
the pieces, made with a secret key in the user's own folder. The inspection of a file reads no
more than that either: where the seal holds, it would say what it would have said then. The pieces
are as untrusted as ever, and unpacked with the same care. The HDF5 library overlooks what stands
after the end it knows of.
"""

from __future__ import annotations

import contextlib
import hashlib
import hmac
import io
import os
import secrets
import struct
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import h5py
import numpy as np
from platformdirs import user_data_path

from tracking import untrusted
from tracking.session import inspection, layout

_MARK = b"twseal01"
_DIGEST_BYTES = KEY_BYTES = 32
_END = struct.Struct(f"<{_DIGEST_BYTES}s{_DIGEST_BYTES}sQ{len(_MARK)}s")
"""Of the file: digest of the structure, signature, how many stretches of pieces, mark."""
_MOST_STRETCHES = 1 << 20
_READ_BYTES = 1 << 20

Stretch = tuple[int, int]
"""First byte and the byte after the last."""


def seal(size: int, pieces: Iterable[Stretch], structure: Iterable[bytes]) -> bytes:
    """What to end a file of that size with; b"" where the user's folder takes no key.

    pieces: where packed pieces of columns lie, ascending, apart; structure: all other bytes.
    """
    key = _key(make=True)
    if key is None:
        return b""
    digest = hashlib.sha256()
    for part in structure:
        digest.update(part)
    table = np.array(list(pieces), "<u8").reshape(-1, 2)
    signed = _signature(key, size, table.tobytes(), digest.digest())
    return table.tobytes() + _END.pack(digest.digest(), signed, len(table), _MARK)


def holds(path: Path) -> bool:
    """Whether the file ends with a seal of this user's that holds: safe without inspection.

    False, too, where it was made by the rules of another version, or cannot be read.
    """
    try:
        with path.open("rb", buffering=0) as file:
            return _holds(file)
    except (OSError, ValueError):
        return False


def beside(pieces: Iterable[Stretch], size: int) -> Iterator[Stretch]:
    """The stretches of a file of that size that lie between pieces, none of them empty."""
    at = 0
    for start, stop in pieces:
        if at < start:
            yield at, start
        at = stop
    if at < size:
        yield at, size


def _holds(file: io.FileIO) -> bool:
    whole = file.seek(0, os.SEEK_END)
    if whole < _END.size:
        return False
    file.seek(whole - _END.size)
    digest, signed, count, mark = _END.unpack(file.read(_END.size))
    size = whole - _END.size - 16 * count
    if mark != _MARK or count > _MOST_STRETCHES or size < 0:
        return False
    key = _key(make=False)
    file.seek(size)
    table = file.read(16 * count)
    if key is None or not hmac.compare_digest(signed, _signature(key, size, table, digest)):
        return False
    starts, stops = np.frombuffer(table, "<u8").reshape(-1, 2).T.tolist()
    pieces = zip(starts, stops, strict=True)
    return hmac.compare_digest(digest, _digest_of(file, beside(pieces, size)))


def _digest_of(file: io.FileIO, stretches: Iterable[Stretch]) -> bytes:
    seen = hashlib.sha256()
    for start, stop in stretches:
        file.seek(start)
        while start < stop and (part := file.read(min(stop - start, _READ_BYTES))):
            seen.update(part)
            start += len(part)
    return seen.digest()


def _signature(key: bytes, size: int, table: bytes, digest: bytes) -> bytes:
    said = b"".join([_rules(), size.to_bytes(8, "little"), digest, table])
    return hmac.digest(key, said, "sha256")


@cache
def _rules() -> bytes:
    """What the inspection goes by: a seal says nothing about other rules, or another library."""
    # By kind, then name: the corrected tracks and those of a run are tables of one name.
    kinds = (layout.TABLES, layout.RUN_TABLES, {"samples": layout.SAMPLE_TABLE})
    columns = [
        (kind, table, column, dtype.str)
        for kind, tables in enumerate(kinds)
        for table, types in tables.items()
        for column, dtype in types.items()
    ]
    said = hashlib.sha256(repr((columns, h5py.version.hdf5_version)).encode())
    programs = (inspection.__file__, layout.__file__)
    for file in (*map(Path, programs), *sorted(Path(untrusted.__file__).parent.glob("*.py"))):
        said.update(file.read_bytes())
    return said.digest()


def _key(*, make: bool) -> bytes | None:
    """This user's own secret; None where there is none, or others could know it."""
    file = user_data_path("trackwright", appauthor=False) / "seal.key"
    with contextlib.suppress(OSError):
        if make and not file.exists():
            _make_key(file)
        with file.open("rb") as held:
            mode = os.fstat(held.fileno()).st_mode
            key = held.read(KEY_BYTES + 1)
        private = sys.platform == "win32" or not mode & 0o077
        return key if private and len(key) == KEY_BYTES else None
    return None


def _make_key(file: Path) -> None:
    """Put a new key there, whole or not at all; another program's, made meanwhile, stays."""
    file.parent.mkdir(parents=True, exist_ok=True)
    unfinished = file.with_suffix(f".{secrets.token_hex(8)}.tmp")
    handle = os.open(unfinished, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        os.write(handle, secrets.token_bytes(KEY_BYTES))
    finally:
        os.close(handle)
    try:
        with contextlib.suppress(FileExistsError):
            os.link(unfinished, file)
    finally:
        unfinished.unlink()
