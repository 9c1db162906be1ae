"""Tables of truth beside a rendered recording, as text: read row by row into plain numbers."""

from __future__ import annotations

import csv
from array import array
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.errors import FormatError, explain_unreadable
from tracking.translation import msg

MOST_BYTES = 256 << 20
"""Three hours of twenty people at 20 frames a second are as large; read, it takes twice that."""

Rows = NDArray[np.int64]
Row = tuple[tuple[int, ...], tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class TruthTable:
    """What a table of truth holds.

    Attributes:
        header: its columns. what: a row of it in words.
        once: what no two rows have in common, in words. keys: how many of a row's whole numbers,
            from the first on, say so.
        row: whole and other numbers of a line; raises ValueError, KeyError or OverflowError
            where it is none.
    """

    header: tuple[str, ...]
    what: str
    once: str
    keys: int
    row: Callable[[list[str]], Row]


def read_table(path: Path, table: TruthTable) -> tuple[Rows, Floats]:
    """Whole numbers (n, k) and others (n, m) of a table, sorted by its keys.

    Raises FormatError where the file is missing, far too large or no such table, or has rows with
    the same keys; names the line.
    """
    try:
        with explain_unreadable(path):
            size = path.stat().st_size
            if size > MOST_BYTES:
                raise FormatError(
                    "{path} has {size} MB, tables of truth are read up to {limit}; give a shorter "
                    "recording",
                    path=path,
                    size=size >> 20,
                    limit=MOST_BYTES >> 20,
                )
            with path.open(encoding="utf-8-sig", newline="") as stream:
                whole, others = _numbers(path, stream, table)
    except (UnicodeDecodeError, csv.Error) as error:
        raise FormatError(
            "{path} is no table of truth: it is not text; render the recording again", path=path
        ) from error
    line, keys = whole[:, 0], whole[:, 1 : table.keys + 1]
    order = np.lexsort((line, *keys.T[::-1]))
    _check_once(path, table, line[order], keys[order])
    return whole[order, 1:], others[order]


def _check_once(path: Path, table: TruthTable, line: Rows, keys: Rows) -> None:
    """Refuse sorted rows whose keys (n, k) stand there already."""
    again = np.flatnonzero((np.diff(keys, axis=0) == 0).all(axis=1))
    if len(again):
        first = again[np.argmin(line[again + 1])]
        raise FormatError(
            "{path}, line {line}: line {earlier} gives {once}; remove one of them",
            path=path,
            line=line[first + 1],
            earlier=line[first],
            once=table.once,
        )


def _numbers(path: Path, stream: Iterable[str], table: TruthTable) -> tuple[Rows, Floats]:
    """Line and whole numbers of each row, and its other numbers."""
    lines = csv.reader(stream)
    if tuple(next(lines, ())) != table.header:
        raise FormatError(
            "{path}, line 1: the columns are not {header}", path=path, header=",".join(table.header)
        )
    whole, others, rows = array("q"), array("d"), 0
    for line in lines:
        try:
            if len(line) != len(table.header):
                raise ValueError(
                    msg(
                        "{count} values where the header names {count_header}",
                        count=len(line),
                        count_header=len(table.header),
                    )
                )
            numbers, more = table.row(line)
            whole.extend((lines.line_num, *numbers))
        except (ValueError, KeyError, OverflowError) as error:
            said = ",".join(line)[:60]
            raise FormatError(
                "{path}, line {line}: {said!r} is no {what} ({error})",
                path=path,
                line=lines.line_num,
                said=said,
                what=table.what,
                error=error,
            ) from error
        others.extend(more)
        rows += 1
    shape = (rows, -1) if rows else (0, len(table.header) + 1)
    return np.array(whole, np.int64).reshape(shape), np.array(others, float).reshape(shape)
