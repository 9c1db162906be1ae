"""Small damages to files: bytes, lines and numbers of text, contents of HDF5 and SQLite."""

from __future__ import annotations

import contextlib
import random
import re
import sqlite3
from pathlib import Path
from typing import Any

import h5py
import numpy as np

_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_NUMBERS = (
    *b"0 -1 1e999 -1e308 nan inf -inf 2147483648 1e-320 0x10 4294967295 1_0 1,5 -0".split(),
    *(b"\xd9\xa3", b"99999999999999999999", b"1" * 5000, b""),
)
_TEXTS = (
    *b"../../x /dev/zero =HYPERLINK(1) &lol; null true - *x &x !!python/object ]]> ' \" <".split(),
    *b"\x00 \x1b[31m \xff\xfe \xef\xbb\xbf \xf0\x9f\x92\xa9 \xe2\x80\xae".split(b" "),
    *(b"\r", b"\n\n", b"[" * 3000, b"{" * 3000, b"(" * 500, b"a" * 100_000),
)
_INTEGERS = (0, 1, 0x7F, 0x80, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 1 << 40)
_VALUES: tuple[Any, ...] = (0, -1, 1, 2**31, -(2**63), 2**63 - 1, np.nan, np.inf, -np.inf, 1e308)
_CELLS = (None, 0, -1, 2**63 - 1, 1e308, "", "x\x1b[31m", "[" * 5000, b"\xff\x00", 0.5)
_ATTRIBUTES: tuple[Any, ...] = (
    "",
    "x" * 70_000,
    "\x1b[31m\n",
    -1,
    2**62,
    np.nan,
    [1, 2, 3],
    "[" * 5000,
)
_STRINGS = ("", "x" * 70_000, "\x1b[31m\n<b>", "{" * 5000, "[" * 5000)
_TABLES = (5, np.zeros(3), np.zeros((2, 2)), np.arange(9), ["a", "b"], np.zeros(0))


def mutate(path: Path, chance: random.Random) -> None:
    """Damage a file in one of the ways its kind knows."""
    data = path.read_bytes()
    is_text = b"\0" not in data
    if data.startswith(b"\x89HDF") and chance.random() < 0.5:
        with contextlib.suppress(OSError, RuntimeError, TypeError, ValueError, KeyError):
            mutate_hdf5(path, chance)
            return
    if data.startswith(b"SQLite format 3\0") and chance.random() < 0.5:
        with contextlib.suppress(sqlite3.Error, OverflowError):
            mutate_sqlite(path, chance)
            return
    for _ in range(chance.choice((1, 1, 1, 2, 5))):
        of_text = is_text and chance.random() < 0.8
        data = mutated_text(data, chance) if of_text else mutated_bytes(data, chance)
    path.write_bytes(data)


def mutated_bytes(data: bytes, chance: random.Random) -> bytes:
    """The data with some bytes other, more or fewer."""
    if not data:
        return chance.randbytes(8)
    at, end, size = chance.randrange(len(data)), len(data), chance.choice((1, 2, 8, 64, 512))
    piece, width = data[at : at + size], chance.choice((1, 2, 4, 8))
    behind, number = at + len(piece), chance.choice(_INTEGERS) & ((1 << 8 * width) - 1)
    changes = (
        (at, at + 1, bytes([data[at] ^ 1 << chance.randrange(8)])),
        (at, behind, chance.randbytes(len(piece))),
        (at, end, b""),
        (at, behind, b""),
        (at, behind, bytes(len(piece))),
        (at, at, piece),
        (at, at + width, number.to_bytes(width, chance.choice(("little", "big")))),
        (end, end, chance.randbytes(size)),
    )
    start, stop, put = chance.choice(changes)
    return data[:start] + put + data[stop:]


def mutated_text(data: bytes, chance: random.Random) -> bytes:
    """The text with a number, a line or some letters other."""
    what = chance.randrange(6)
    numbers = list(_NUMBER.finditer(data))
    if what < 3 and numbers:
        match = chance.choice(numbers)
        return data[: match.start()] + chance.choice(_NUMBERS) + data[match.end() :]
    at = chance.randrange(len(data) + 1)
    if what == 3:
        return data[:at] + chance.choice(_TEXTS) + data[at:]
    lines = data.split(b"\n")
    one, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    if what == 4:
        lines[one], lines[other] = lines[other], lines[one]
    elif chance.random() < 0.5:
        del lines[one]
    else:
        lines[other:other] = [lines[one]] * chance.choice((1, 3))
    return b"\n".join(lines)


def mutate_hdf5(path: Path, chance: random.Random) -> None:
    """Another value, type, shape or attribute somewhere; or something less."""
    with h5py.File(path, "r+") as file:
        names: list[str] = []
        file.visit(names.append)
        node = file[chance.choice(names)] if names and chance.random() < 0.9 else file
        if chance.random() < 0.35 and len(node.attrs):
            _mutate_attribute(node, chance)
        elif isinstance(node, h5py.Dataset) and chance.random() < 0.7:
            _mutate_values(node, chance)
        elif isinstance(node, h5py.Dataset):
            _replace(file, node.name, chance)
        elif node.name != "/":
            del file[node.name]


def _mutate_attribute(node: Any, chance: random.Random) -> None:
    name = chance.choice(list(node.attrs))
    if chance.random() < 0.3:
        del node.attrs[name]
    else:
        node.attrs[name] = chance.choice(_ATTRIBUTES)


def _mutate_values(node: h5py.Dataset, chance: random.Random) -> None:
    values = node[()]
    if node.dtype.kind in "iuf" and node.size:
        flat = values.reshape(-1)
        for _ in range(chance.choice((1, 1, 5))):
            with np.errstate(all="ignore"):
                value = np.array(chance.choice(_VALUES)).astype(node.dtype)
            flat[chance.randrange(flat.size)] = value
        node[...] = flat.reshape(values.shape)
    elif node.dtype.kind == "O":
        node[chance.randrange(len(node)) if node.ndim else ()] = chance.choice(_STRINGS)


def _replace(file: h5py.File, name: str, chance: random.Random) -> None:
    del file[name]
    file[name] = chance.choice(_TABLES)


def mutate_sqlite(path: Path, chance: random.Random) -> None:
    """Another value in a row, or a row, a column or a table less."""
    with contextlib.closing(sqlite3.connect(path, isolation_level=None)) as base:
        tables = base.execute("SELECT name FROM sqlite_master WHERE type='table'").fetchall()
        table = chance.choice(tables)[0]
        columns = [row[1] for row in base.execute(f'PRAGMA table_info("{table}")')]
        column, what = chance.choice(columns), chance.random()
        if what < 0.75:
            where = f'rowid = (SELECT rowid FROM "{table}" ORDER BY random() LIMIT 1)'
            update = f'UPDATE "{table}" SET "{column}" = ? WHERE {where}'
            base.execute(update, [chance.choice(_CELLS)])
        elif what < 0.85:
            base.execute(f'ALTER TABLE "{table}" RENAME COLUMN "{column}" TO other')
        else:
            base.execute(f'{"DELETE FROM" if what < 0.95 else "DROP TABLE"} "{table}"')
