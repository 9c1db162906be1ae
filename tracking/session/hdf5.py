"""Reading parts of an HDF5 file that was checked, with one kind of error."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py

from tracking.errors import SessionError
from tracking.session.layout import TEXT, Types
from tracking.session.unpacking import read_numbers, unpackers

_FAILURES = (
    *(OSError, KeyError, ValueError, TypeError),
    *(RuntimeError, AttributeError, OverflowError, MemoryError),
)
"""What the library and conversions raise on a file that is not as it should be."""


@contextmanager
def opened(path: Path) -> Iterator[h5py.File]:
    """The file, open for reading only; whatever fails inside is a SessionError."""
    try:
        with h5py.File(path, "r", locking=False) as file:
            yield file
    except FileNotFoundError as why:
        raise SessionError(
            f"{path} is out of reach: it was moved or its disk has gone; connect it again"
        ) from why
    except _FAILURES as why:
        reason = " ".join(str(why).split())
        raise SessionError(f"{path}: the session file is damaged or cut short ({reason})") from why


def read_columns(group: h5py.Group, types: Types) -> dict[str, Any]:
    """All columns of a table, numbers as arrays, text as lists."""
    with unpackers() as pool:
        return {
            name: read_text(group[name])
            if dtype == TEXT
            else read_numbers(group[name], dtype, pool)
            for name, dtype in types.items()
        }


def read_text(dataset: h5py.Dataset) -> list[str]:
    """A column of text."""
    return [str(text) for text in dataset.asstr(errors="replace")[()]]


def text_attribute(node: h5py.Group, name: str) -> str:
    """An attribute that is text."""
    value = node.attrs[name]
    if not isinstance(value, str):
        raise ValueError(f"attribute {name} of {node.name} is not text")
    return value
