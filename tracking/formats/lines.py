"""Tables as CSV text, read row by row with the lines they stand on."""

from __future__ import annotations

import csv
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

from tracking.cells import text_of_cell
from tracking.errors import FormatError, explain_unreadable
from tracking.formats.line_survey import LONGEST_LINE, MOST_EMPTY, too_long
from tracking.translation import msg

_MOST_BYTES = 1 << 30
_TOLD = 40
"""Letters of a column's name in a message."""
_SEPARATORS = {";": "semicolons", "\t": "tabs"}
"""Of other kinds of tables, as messages call them."""


def numbered_rows(
    path: Path,
    needed: Collection[str],
    also: Collection[str] = (),
    *,
    most_bytes: int = _MOST_BYTES,
) -> Iterator[tuple[int, Mapping[str, str]]]:
    """The rows of a CSV file with a header, each with its line from 1 on.

    Args:
        needed: columns it must have. also: columns it may have; others are refused.
        most_bytes: a larger file is not read.

    Raises FormatError where the file is missing, too large, no text, a row is longer than
    `LONGEST_LINE` or has too few or too many values, or there is hardly more than empty rows.
    """
    with _explained(path):
        if path.stat().st_size > most_bytes:
            raise FormatError(
                "{path} is larger than {size} MB; split it first", path=path, size=most_bytes >> 20
            )
        with path.open(encoding="utf-8-sig", newline="") as stream:
            lines = _Lines(path, stream)
            rows = csv.reader(iter(lines), strict=True)
            header = [name.strip() for name in next(rows, [])]
            _check_header(path, header, needed, also)
            for row in _filled(path, rows, lines):
                if len(row) != len(header):
                    raise FormatError(
                        "{place}: {count} values where the header names {named}; correct or "
                        "remove the row",
                        place=place_of(path, rows.line_num),
                        count=len(row),
                        named=len(header),
                    )
                yield rows.line_num, dict(zip(header, map(text_of_cell, row), strict=True))


@contextmanager
def _explained(path: Path) -> Iterator[None]:
    """What makes a file no table that can be read, as a FormatError."""
    try:
        with explain_unreadable(path):
            yield
    except UnicodeDecodeError as error:
        raise FormatError("{path} is not text; give a CSV file", path=path) from error
    except csv.Error as error:
        raise FormatError(
            "{path} is not CSV ({error}); write it anew", path=path, error=error
        ) from error


def _filled(path: Path, rows: Iterable[list[str]], lines: _Lines) -> Iterator[list[str]]:
    """The rows that are not empty. Raises FormatError where there are hardly any."""
    filled = empty = 0
    for row in rows:
        lines.held = 0
        if any(value.strip() for value in row):
            filled += 1
            yield row
            continue
        empty += 1
        if empty > max(filled, MOST_EMPTY):
            raise FormatError("{path} is hardly more than empty lines; is it a table?", path=path)


class _Lines:
    """The lines of a text as they are asked for, refused where those of a row are too long.

    Attributes:
        held: characters since the row began; whoever reads rows begins anew at 0.
    """

    def __init__(self, path: Path, stream: TextIO) -> None:
        self._path, self._stream = path, stream
        self.held = 0

    def __iter__(self) -> Iterator[str]:
        number = 0
        while line := self._stream.readline(LONGEST_LINE + 1):
            number, self.held = number + 1, self.held + len(line)
            if self.held > LONGEST_LINE:
                raise too_long(self._path, number)
            yield line


def header_of(path: Path) -> list[str]:
    """The names in the first line of a CSV file; none where it has none that can be read."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as stream:
            return [name.strip() for name in next(csv.reader([stream.readline(LONGEST_LINE)]), [])]
    except (OSError, UnicodeDecodeError, csv.Error):
        return []  # reading the table itself says why


def place_of(path: Path, line: int) -> str:
    """As messages name it."""
    return msg("{path}, line {line}", path=path, line=line)


def _check_header(
    path: Path, header: list[str], needed: Collection[str], also: Collection[str]
) -> None:
    missing = [name for name in needed if name not in header]
    if missing:
        if len(header) == 1 and (other := next((s for s in _SEPARATORS if s in header[0]), "")):
            raise FormatError(
                "{path}, line 1: the columns are separated by {separator}; separate them by commas",
                path=path,
                separator=_SEPARATORS[other],
            )
        raise FormatError(
            "{path}, line 1: there is no column {column!r}; name the columns",
            path=path,
            column=missing[0],
        )
    unknown = [name for name in header if name not in (*needed, *also)]
    if unknown or len(set(header)) < len(header):
        name = unknown[0] if unknown else next(n for n in header if header.count(n) > 1)
        what = msg("is none of ours") if unknown else msg("stands there twice")
        raise FormatError(
            "{path}, line 1: the column {name!r} {what}; remove it",
            path=path,
            name=name[:_TOLD],
            what=what,
        )
