"""Reading parts of an HDF5 file that was checked, with one kind of error."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tracking.errors import SessionError
from tracking.session.layout import TEXT, table_at
from tracking.session.table_reader import PendingColumns
from tracking.untrusted import FAILURES


@contextmanager
def open_readonly(path: Path) -> Iterator[h5py.File]:
    """The file, open for reading only; whatever fails inside is a SessionError."""
    try:
        with h5py.File(path, "r", locking=False) as file:
            yield file
    except FileNotFoundError as why:
        raise SessionError(
            "{path} is out of reach: it was moved or its disk has gone; put it back", path=path
        ) from why
    except FAILURES as why:
        # What the library says of a file that is cut short tells its users nothing.
        reason = f" ({' '.join(str(why).split())})" if isinstance(why, ValueError) else ""
        raise SessionError(
            "{path}: the session file is damaged or cut short{reason}; restore a backup of it",
            path=path,
            reason=reason,
        ) from why


def read_columns(group: h5py.Group) -> dict[str, Any]:
    """All columns of a table, numbers as arrays, text as lists, less those older files lack."""
    with PendingColumns() as unpacking:
        columns = begin_columns(group, unpacking)
        unpacking.finish()
    return columns


def begin_columns(group: h5py.Group, unpacking: PendingColumns) -> dict[str, Any]:
    """The same; the numbers count when the unpacking is finished.

    The columns of a checked file are equally long: where one is empty, all are.
    """
    table = table_at(group.name)
    types = table.columns_in(group)
    if is_empty(group, next(iter(types))):
        return {n: [] if dtype == TEXT else np.empty(0, dtype) for n, dtype in types.items()}
    columns = {name: _dataset(group, name) for name in types}
    return {
        name: read_text(column) if types[name] == TEXT else unpacking.read(column, types[name])
        for name, column in columns.items()
    }


def read_rows(group: h5py.Group) -> Iterator[dict[str, Any]]:
    """The rows of a table, their values by column."""
    columns = read_columns(group)
    values = (v if isinstance(v, list) else v.tolist() for v in columns.values())
    return (dict(zip(columns, row, strict=True)) for row in zip(*values, strict=True))


def is_empty(group: h5py.Group, column: str) -> bool:
    """Whether a column, and so its table, has no rows. Raises KeyError where it is not there."""
    return not math.prod(h5py.h5d.open(group.id, column.encode()).shape)


def _dataset(group: h5py.Group, name: str) -> h5py.Dataset:
    """The same as `group[name]` at a third of the time, which counts where all else is small."""
    return h5py.Dataset(h5py.h5d.open(group.id, name.encode()))


def read_text(dataset: h5py.Dataset) -> list[str]:
    """A column of text."""
    if not dataset.size:
        return []
    return [str(text) for text in dataset.asstr(errors="replace")[()]]


def text_attribute(node: h5py.Group, name: str) -> str:
    """An attribute that is text."""
    value = node.attrs[name]
    if not isinstance(value, str):
        raise ValueError(f"attribute {name} of {node.name} is not text")
    return value
