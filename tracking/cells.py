"""Cells of tables in CSV: words of a person or a file that no spreadsheet takes for a formula."""

from __future__ import annotations

import re

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
