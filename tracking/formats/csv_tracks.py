"""CSV: the corrected table as it is, a header and a row a person a frame.

Frames and pixels count from 0, places are metres, what is unknown is empty. Columns may be divided
by commas, semicolons or tabs; where commas do not divide columns, they may stand for the decimal
point. Only `frame` and `track` are needed, and any others of the table are taken.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.atomic_output import replacing_bytes
from tracking.errors import FormatError
from tracking.formats.delimited_text import NumberRows, Piece, RowShape, pieces_of
from tracking.formats.number_text import Block, lines_of, numbers, short_decimals, whole_numbers
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import Exported
from tracking.progress import Progress, no_progress
from tracking.tracks import CORRECTED_COLUMNS, Columns
from tracking.translation import joined, msg

_SEPARATORS = ",;\t"
_NEEDED = ("frame", "track")
_MOST_COLUMNS = 200
_UNKNOWN = "nan"
_LONGEST_NAMES = 200
"""Letters of the names of columns that are left out, in a note."""
_WORDS = {"true": "1", "false": "0"}


def _short(names: str) -> str:
    return names[:_LONGEST_NAMES]


def _import(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a table. Raises FormatError where there is no such header."""
    reading = Reading(path, report)
    pieces = pieces_of(path, report)
    first = next(pieces)
    separator, names = _header(path, first)
    left_out = [name for name in names if name not in CORRECTED_COLUMNS]
    if left_out:
        reading.notes.append(
            msg(
                "columns that are left out: {left_out}",
                left_out=joined(", ", left_out).cut_by(_short),
            )
        )
    taken = tuple(name for name in names if name in CORRECTED_COLUMNS)
    plain = partial(_plain, separator=separator)
    shape = RowShape(msg("a row of this table"), len(taken), len(taken), separator, plain)
    lines = _rows(first, pieces, separator, names, reading)

    def trial(table: NDArray[np.float64], places: NDArray[np.int32]) -> None:
        rows = dict(zip(taken, table.T, strict=True))
        Reading(path).checked(rows, lambda row: msg("line {places}", places=places[row]))

    table, places = NumberRows(reading, shape, trial).read(lines)
    rows = dict(zip(taken, table.T, strict=True))
    return reading.imported(rows, lambda row: msg("line {places}", places=places[row]))


def _export(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write the table; how sure the tracker was stays as it was."""
    with replacing_bytes(path) as stream:
        stream.write(",".join(CORRECTED_COLUMNS).encode() + b"\n")
        for piece in exported.pieces(report):
            stream.write(lines_of([_block(piece, name) for name in CORRECTED_COLUMNS]))
    return (path,)


def _recognises(_path: Path, head: bytes) -> bool:
    first = head.removeprefix(b"\xef\xbb\xbf").split(b"\n", 1)[0].decode(errors="replace")
    names = _names(first, _separator(first))
    return len(first) < len(head) and all(names.count(needed) == 1 for needed in _NEEDED)


def _header(path: Path, piece: Piece) -> tuple[str, tuple[str, ...]]:
    """What divides columns, and their names."""
    line = piece.lines[0] if piece.lines else ""
    separator = _separator(line)
    names = _names(line, separator)
    missing = [name for name in _NEEDED if name not in names]
    if missing:
        raise FormatError(
            "{path}, line 1: there is no column {column!r}; name the columns",
            path=path,
            column=missing[0],
        )
    twice = [name for name in names if names.count(name) > 1]
    if twice or len(names) > _MOST_COLUMNS:
        what = (
            msg("the column {twice!r} stands there twice", twice=twice[0])
            if twice
            else msg("far too many columns")
        )
        raise FormatError("{path}, line 1: {what}; correct the header", path=path, what=what)
    return separator, names


def _separator(header: str) -> str:
    return max(_SEPARATORS, key=header.count)


def _names(header: str, separator: str) -> tuple[str, ...]:
    return tuple(name.strip().strip('"').strip().lower() for name in header.split(separator))


def _rows(
    first: Piece, others: Iterator[Piece], separator: str, names: Sequence[str], reading: Reading
) -> Iterator[Piece]:
    """The lines below the header, with the columns that are taken."""
    taken = [at for at, name in enumerate(names) if name in CORRECTED_COLUMNS]
    below = replace(first, first=first.first + 1, lines=first.lines[1:])
    for piece in chain((below,), others):
        if len(taken) == len(names):
            yield piece
            continue
        lines = []
        for number, line in enumerate(piece.lines, piece.first):
            fields = line.split(separator)
            whole = len(fields) == len(names)
            if not whole and line.strip():
                reason = msg(
                    "{count} values where the header names {count_names}",
                    count=len(fields),
                    count_names=len(names),
                )
                reading.bad(msg("line {number}", number=number), reason)
            lines.append(separator.join(fields[at] for at in taken) if whole else "")
        yield replace(piece, lines=lines)


def _plain(text: str, separator: str) -> str:
    """Lines with what is missing as nan, and with points. ValueError where one says nan itself."""
    text = _bare(text.replace("\r", "").lower(), separator)
    if _UNKNOWN in text:
        raise ValueError(_UNKNOWN)
    if separator != ",":
        text = text.replace(",", ".")
    for word, number in _WORDS.items():
        if word in text:
            text = re.sub(rf"(?<![^\n{separator}]){word}(?![^\n{separator}])", number, text)
    text = f"\n{text}\n"
    for before in ("\n", separator):
        for after in ("\n", separator):
            missing = before + _UNKNOWN + after
            text = text.replace(before + after, missing).replace(before + after, missing)
    return text[1:-1]


def _bare(text: str, separator: str) -> str:
    """Fields without quotes and blanks round them. ValueError where some stand inside of one."""
    inside = rf"[^ \n{separator}]"
    for sign, within in (('"', f'{inside}"{inside}'), (" ", f"{inside} +{inside}")):
        if sign in text:
            if re.search(within, text):
                raise ValueError(sign)
            text = text.replace(sign, "")
    return text


def _block(rows: Columns, name: str) -> Block:
    """A column as text."""
    column = rows[name]
    if column.dtype.kind != "f":
        return whole_numbers(column.astype(np.int64))
    return numbers(short_decimals(column) if column.dtype == np.float32 else column, b"")


CSV = TrackFormat(
    "csv",
    "CSV, the corrected table",
    (".csv",),
    _recognises,
    _import,
    _export,
    holds=frozenset(Content) - {Content.CLASSES, Content.NAMES, Content.NOTES, Content.SCHEMA},
    about="All columns of the corrected tracks, with all digits; opens in any spreadsheet.",
)
