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
import stat
import struct
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import h5py
import numpy as np
from platformdirs import user_data_path

from tracking import untrusted
from tracking.owned_files import SAFE_FLAGS, sync_folder
from tracking.session import inspection, layout

_MARK = b"twseal01"
_DIGEST_BYTES = KEY_BYTES = 32
_END = struct.Struct(f"<{_DIGEST_BYTES}s{_DIGEST_BYTES}sQ{len(_MARK)}s")
"""Of the file: digest of the structure, signature, how many stretches of pieces, mark."""
_NOT_SIGNED = bytes(_DIGEST_BYTES)
_MOST_STRETCHES = 1 << 20
_MOST_STRUCTURE_BYTES = 1 << 28
"""Of a file from elsewhere that are read to tell damage: a second's work; sessions have less."""
_READ_BYTES = 1 << 20

Stretch = tuple[int, int]
"""First byte and the byte after the last."""


def seal(size: int, pieces: Iterable[Stretch], structure: Iterable[bytes]) -> bytes:
    """What to end a file of that size with.

    Where the user's folder takes no key it is not signed: it holds for nobody, and still tells
    damage. pieces: where packed pieces of columns lie, ascending, apart; structure: all other
    bytes.
    """
    key = _key(make=True)
    digest = hashlib.sha256()
    for part in structure:
        digest.update(part)
    table = np.array(list(pieces), "<u8").reshape(-1, 2)
    signed = _NOT_SIGNED
    if key is not None:
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


def is_changed(path: Path) -> bool:
    """Whether a file that ends with anybody's seal is not as it was saved, as the digest tells.

    False where it has no seal, as after another program wrote into it, and where it cannot be told.
    """
    try:
        with path.open("rb", buffering=0) as file:
            end = _end_of(file)
            if end is None or end.structure_bytes > _MOST_STRUCTURE_BYTES:
                return False
            return end.digest != _digest_of(file, beside(end.pieces, end.size))
    except (OSError, ValueError):
        return False


def is_missing(path: Path) -> bool:
    """Whether a file ends without anybody's seal; False where it cannot be told."""
    try:
        with path.open("rb", buffering=0) as file:
            return _end_of(file) is None
    except (OSError, ValueError):
        return False


@dataclass(frozen=True, slots=True)
class _End:
    """What a seal says: of a file of `size` bytes, without it, and `pieces` in it."""

    size: int
    table: bytes
    pieces: list[Stretch]
    digest: bytes
    signed: bytes

    @property
    def structure_bytes(self) -> int:
        return self.size - sum(stop - start for start, stop in self.pieces)


def _end_of(file: io.FileIO) -> _End | None:
    """The seal of a file; None where it has none, or one that can be of no file."""
    whole = file.seek(0, os.SEEK_END)
    if whole < _END.size:
        return None
    file.seek(whole - _END.size)
    digest, signed, count, mark = _END.unpack(file.read(_END.size))
    size = whole - _END.size - 16 * count
    if mark != _MARK or count > _MOST_STRETCHES or size < 0:
        return None
    file.seek(size)
    table = file.read(16 * count)
    edges = np.frombuffer(table, "<u8")
    if np.any(edges[1:] < edges[:-1]) or np.any(edges > size):
        return None
    pieces = [(start, stop) for start, stop in edges.reshape(-1, 2).tolist()]
    return _End(size, table, pieces, digest, signed)


def _holds(file: io.FileIO) -> bool:
    end, key = _end_of(file), _key(make=False)
    if end is None or key is None:
        return False
    if not hmac.compare_digest(end.signed, _signature(key, end.size, end.table, end.digest)):
        return False
    return hmac.compare_digest(end.digest, _digest_of(file, beside(end.pieces, end.size)))


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
    kinds = (layout.TABLES, layout.RUN_TABLES, {"samples": layout.SAMPLES})
    columns = [
        (kind, table, column, dtype.str)
        for kind, tables in enumerate(kinds)
        for table, held in tables.items()
        for column, dtype in held.columns.items()
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
        if make and not _is_key(_read_key(file)):
            _make_key(file)
        key = _read_key(file)
        return key if _is_key(key) and not _others_may_read(file) else None
    return None


def _is_key(key: bytes) -> bool:
    """Whether it is one: a power cut may have left nothing of it, or zeros that anybody knows."""
    return len(key) == KEY_BYTES and any(key)


def _read_key(file: Path) -> bytes:
    """What the file holds, as far as a key may; b"" where there is no file, or something else.

    Links are followed here: the user's own folder is as the user has arranged it.
    """
    try:
        handle = os.open(file, os.O_RDONLY | SAFE_FLAGS & ~getattr(os, "O_NOFOLLOW", 0))
    except FileNotFoundError:
        return b""
    try:
        is_file = stat.S_ISREG(os.fstat(handle).st_mode)
        return os.read(handle, KEY_BYTES + 1) if is_file else b""
    finally:
        os.close(handle)


def _others_may_read(file: Path) -> bool:
    if sys.platform == "win32":
        return False
    state = file.stat()
    return bool(state.st_mode & 0o077) or state.st_uid != os.geteuid()


def _make_key(file: Path) -> None:
    """Put a new key on the disk, whole or not at all, in the place of what is none.

    One that another program puts there in the same moment may go: what bears its seal is only
    looked over once more.
    """
    file.parent.mkdir(parents=True, exist_ok=True)
    unfinished = file.with_suffix(f".{secrets.token_hex(8)}.tmp")
    handle = os.open(unfinished, os.O_WRONLY | os.O_CREAT | os.O_EXCL | SAFE_FLAGS, 0o600)
    try:
        with os.fdopen(handle, "wb") as made:
            made.write(secrets.token_bytes(KEY_BYTES))
            made.flush()
            os.fsync(made.fileno())
        unfinished.replace(file)
    finally:
        unfinished.unlink(missing_ok=True)
    sync_folder(file.parent)
