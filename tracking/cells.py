"""Cells of tables in CSV: words of a person or a file that no spreadsheet takes for a formula."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable
from typing import Protocol

_FORMULA = "[=+\\-@\uff1d\uff0b\uff0d\uff20\t\r\n\v\f\0]"
"""What a cell begins with that spreadsheets reckon with: signs, as wide ones too, and what they
leave out at the beginning."""
_PARTED = ";\t\r\n"
"""What a spreadsheet may part a cell at, quoted or not: where commas stand for the decimal point,
lists and tables are divided by semicolons, and quotes amid such a field count for nothing."""
_AT_RISK = re.compile(f"(?:\\A(?='*{_FORMULA})|(?<=[{_PARTED}])(?=['\"]*{_FORMULA}))")
_GUARDED = re.compile(f"(?:\\A'(?='*{_FORMULA})|(?<=[{_PARTED}])'(?=['\"]*{_FORMULA}))")


def cell_of(value: object) -> object:
    """A value as a cell of CSV: words are never a formula, numbers stay numbers.

    Text that a spreadsheet would reckon with stands behind an apostrophe (as CWE-1236 advises),
    also behind a sign at which some part cells, and so does text that looks as if it did already:
    `text_of_cell` gives every text back.
    """
    return _AT_RISK.sub("'", value) if isinstance(value, str) else value


def text_of_cell(cell: str) -> str:
    """What `cell_of` was given, of a cell as it was read."""
    return _GUARDED.sub("", cell)


class Lines(Protocol):
    """What lines are written to."""

    def write(self, text: str, /) -> object:
        """Write it after what was written before."""


class CsvWriter:
    """Writes rows as CSV whose lines end with a line feed.

    A cell that holds a carriage return alone is quoted, too: some readers end a row there, and
    Python's writer quotes what its own line end is made of only.
    """

    def __init__(self, stream: Lines) -> None:
        self._stream = stream
        self._row = io.StringIO(newline="")
        self._writer = csv.writer(self._row, lineterminator="\r\n")

    def writerow(self, cells: Iterable[object]) -> None:
        """Write one row."""
        self._writer.writerow(cells)
        self._stream.write(self._row.getvalue().removesuffix("\r\n") + "\n")
        self._row.seek(0)
        self._row.truncate()

    def writerows(self, rows: Iterable[Iterable[object]]) -> None:
        """Write one row after the other."""
        for cells in rows:
            self.writerow(cells)
