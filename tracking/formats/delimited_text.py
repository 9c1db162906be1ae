"""Text files that hold one row of numbers a line, read a piece at a time."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.line_survey import (
    LONGEST_LINE,
    MOST_EMPTY,
    MOST_ROWS,
    lines_in,
    too_long,
    too_many,
)
from tracking.formats.read_result import FEW_BAD, PlaceOf, Reading
from tracking.progress import Progress, no_progress
from tracking.translation import Message, count_msg, msg

MAX_BYTES = 1 << 30
"""A text larger than this is no annotation of one recording."""

_DIVIDERS = re.compile(r"\s*;\s*|\s+")
"""What other tables have in place of commas."""
_PIECE_BYTES = 1 << 20
_FEW = 32
"""So many lines are looked at one by one where one of them cannot be read."""


@dataclass(frozen=True, slots=True)
class Piece:
    """Some whole lines of a file.

    Attributes:
        first: the number of the first line, from 1.
        lines: as they stand there, blank ones included.
        of: how many lines the whole file has.
    """

    first: int
    lines: list[str]
    of: int


def pieces_of(
    path: Path, report: Progress = no_progress, held: bytes | None = None
) -> Iterator[Piece]:
    """The lines of a text file, some at a time; report is called with bytes.

    What the file holds may be given, where it has been read.

    Raises FormatError where the file is missing, too large or no text, and as `lines_in`.
    """
    first, rest = 1, b""
    try:
        if held is None and not path.is_file() and path.exists():
            raise FormatError("{path} is no file that can be read twice; save it first", path=path)
        size = path.stat().st_size if held is None else len(held)
        if size > MAX_BYTES:
            raise FormatError(
                "{path} is larger than {size} MB; split it first", path=path, size=MAX_BYTES >> 20
            )
        with path.open("rb") if held is None else io.BytesIO(held) as stream:
            count = lines_in(path, stream)
            stream.seek(0)
            while block := stream.read(_PIECE_BYTES):
                block = rest + block
                end = block.rfind(b"\n") + 1
                rest = block[end:]
                if len(rest) > LONGEST_LINE:  # somebody writes to it meanwhile
                    raise too_long(path, first + block.count(b"\n"))
                if lines := _lines(first, block[:end]):
                    yield Piece(first, lines, count)
                first += len(lines)
                report(min(stream.tell(), size), size)
        yield Piece(first, _lines(first, rest), count)
    except OSError as error:
        raise FormatError(
            "cannot read {path}: {reason}; check the path", path=path, reason=error.strerror
        ) from error
    except UnicodeDecodeError as error:
        raise FormatError("{path} is not text; give a text file or a session", path=path) from error


def _lines(first: int, block: bytes) -> list[str]:
    lines = block.decode("utf-8-sig" if first == 1 else "utf-8").split("\n")
    if not lines[-1]:
        del lines[-1]
    return lines


Trial = Callable[[NDArray[np.float64], NDArray[np.int32]], object]
"""Looks over the first rows of a table and the lines they stand on."""

TRIED_ROWS = 2 * FEW_BAD
"""Enough for a file to be refused for its bad rows by them alone."""


def on_lines(lines: NDArray[np.int32]) -> PlaceOf:
    """Where rows stand, as messages name it, by their lines (n,)."""
    return lambda row: msg("line {lines}", lines=lines[row])


def tell_not_finite(reading: Reading, lines: NDArray[np.int32]) -> None:
    """Tell rows as bad, by their lines, because one of their values is not finite."""
    for line in lines.tolist():
        reading.bad(msg("line {lines}", lines=line), msg("a value is not a finite number"))


def unchanged(text: str) -> str:
    """For text that holds plain numbers already."""
    return text


@dataclass(frozen=True, slots=True)
class RowShape:
    """What rows of numbers look like in a format.

    Attributes:
        what: the format, as messages name it.
        least, most: how many numbers a row has; the first row says how many in this file.
        separator: one character.
        plain: makes lines what `float` reads between separators, the same number of lines. Raises
            ValueError where they hold something that is no number, though `float` takes it.
        comment: it and what stands behind it in a line is no part of a row; "": there are none.
    """

    what: str
    least: int
    most: int
    separator: str = ","
    plain: Callable[[str], str] = unchanged
    comment: str = ""

    def row_in(self, line: str) -> str:
        """What a line holds of a row: all but its comment; "" where that is nothing."""
        if self.comment and self.comment in line:
            line = line.partition(self.comment)[0]
        return "" if line.isspace() else line


class _Held:
    """Rows that are kept, by columns."""

    def __init__(self) -> None:
        self.count = 0
        self._table, self._lines = np.zeros((0, 0)), np.zeros(0, np.int32)

    def add(self, table: NDArray[np.float64], lines: NDArray[np.int32], most: int) -> None:
        """Add rows and their lines; most: how many there can be in all.

        The room for all is asked for at once: memory that nothing was written to yet is none.
        """
        stop = self.count + len(table)
        if stop > len(self._lines):  # the first rows; or somebody writes to the file meanwhile
            room = max(most, stop)
            wider, longer = np.empty((table.shape[1], room)), np.empty(room, np.int32)
            if self.count:
                wider[:, : self.count], longer[: self.count] = self._table, self._lines
            self._table, self._lines = wider, longer
        self._table[:, self.count : stop] = table.T
        self._lines[self.count : stop] = lines
        self.count = stop

    def rows(self) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """All so far: (n, k) and (n,)."""
        return self._table[:, : self.count].T, self._lines[: self.count]


class NumberRows:
    """Reads rows of numbers, all of one length; others are told as bad."""

    def __init__(self, reading: Reading, shape: RowShape, trial: Trial | None = None) -> None:
        """Rows of that shape.

        trial: given the first `TRIED_ROWS` rows and their lines, raises where they are such that
            the file is refused in the end: nobody waits for the rest then.
        """
        self._reading, self._shape, self._trial = reading, shape, trial
        self._width = 0 if shape.least < shape.most else shape.most

    def read(self, pieces: Iterable[Piece]) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """(n, k) the numbers as they stand there, and (n,) the lines they stand on.

        The columns of the table stand together in memory: it takes 8 bytes a number and 4 a row.

        Raises FormatError as `tables`.
        """
        held = _Held()
        for table, lines, of in self.tables(pieces):
            held.add(table, lines, of)
            if self._trial is not None and held.count >= TRIED_ROWS:
                self._trial(*held.rows())
                self._trial = None
        if not held.count:
            return np.zeros((0, self._width or self._shape.least)), np.zeros(0, np.int32)
        return held.rows()

    def tables(
        self, pieces: Iterable[Piece]
    ) -> Iterator[tuple[NDArray[np.float64], NDArray[np.int32], int]]:
        """The same as tables of some rows each, which are not kept, with `Piece.of`.

        Raises FormatError as `pieces_of`, and where no line at all can be read but some are there.
        """
        rows = empty = 0
        for piece in pieces:
            held = list(map(self._shape.row_in, piece.lines))
            filled = [at for at, row in enumerate(held) if row]
            lines = [held[at] for at in filled]
            numbers = np.array(filled, np.int32) + np.int32(piece.first)
            for table, first, stop in self._read(lines, numbers, 0, len(lines)):
                yield table, numbers[first:stop], piece.of
            rows, empty = rows + len(lines), empty + len(piece.lines) - len(lines)
            self._check_size(rows, empty)
        if not self._reading.good:
            self._refuse_nothing()

    def _check_size(self, rows: int, empty: int) -> None:
        path = self._reading.path
        if rows > MOST_ROWS:
            raise too_many(path)
        if empty > max(rows, MOST_EMPTY):
            raise FormatError(
                "{path} is hardly more than empty lines; is it {what}?",
                path=path,
                what=self._shape.what,
            )

    def _read(
        self, lines: list[str], numbers: NDArray[np.int32], first: int, stop: int
    ) -> Iterator[tuple[NDArray[np.float64], int, int]]:
        """Tables of stretches of lines; a stretch that cannot be read is halved and tried again."""
        if first == stop:
            return
        table = self._table_of(lines[first:stop])
        if table is not None:
            self._reading.good += len(table)
            yield table, first, stop
        elif stop - first <= _FEW:
            for at in range(first, stop):
                row = self._row(lines[at], int(numbers[at]))
                if row is not None:
                    self._reading.good += 1
                    yield row, at, at + 1
        else:
            middle = (first + stop) // 2
            yield from self._read(lines, numbers, first, middle)
            yield from self._read(lines, numbers, middle, stop)

    def _table_of(self, lines: list[str]) -> NDArray[np.float64] | None:
        """The numbers of lines; None where some of them cannot be read."""
        if not self._width:
            return None  # the first line that can be read alone says how long rows are
        separator = self._shape.separator
        try:
            text = io.StringIO(self._shape.plain("\n".join(lines)))
            table = np.loadtxt(text, delimiter=separator, comments=None, ndmin=2)
        except ValueError:
            return None
        return table if table.shape == (len(lines), self._width) else None

    def _row(self, line: str, number: int) -> NDArray[np.float64] | None:
        """(1, k) the numbers of one line; None where it is told to be bad."""
        least, most = self._shape.least, self._shape.most
        count = line.count(self._shape.separator) + 1
        if not least <= count <= most:
            span = (
                msg("{least}", least=least)
                if least == most
                else msg("{least} to {most}", least=least, most=most)
            )
            reason = msg(
                "{values}; {what} has {span} in a row",
                values=_values(count),
                what=self._shape.what,
                span=span,
            )
            if self._shape.separator == "," and least <= len(_DIVIDERS.split(line.strip())) <= most:
                reason = msg("no commas between values; {what} wants them", what=self._shape.what)
        elif self._width and count != self._width:
            reason = msg(
                "{values} where the rows before have {width}",
                values=_values(count),
                width=self._width,
            )
        elif reason := self._not_numbers(line):
            pass
        else:
            self._width = count
            plain = self._shape.plain(line).split(self._shape.separator)
            return np.array([[float(field) for field in plain]])
        self._reading.bad(msg("line {number}", number=number), reason)
        return None

    def _not_numbers(self, line: str) -> Message:
        """Why the values of a line are no numbers; "" where they are."""
        for field in line.split(self._shape.separator):
            try:
                plain = self._shape.plain(field)
            except ValueError:
                plain = ""
            if not _is_number(plain):
                return msg("{field!r} is not a number", field=field.strip()[:40])
        return Message()

    def _refuse_nothing(self) -> None:
        if self._reading.bad_count:
            first = self._reading.bad_rows[0]
            raise FormatError(
                "{path}, {place}: {reason}; is it {what}?",
                path=self._reading.path,
                place=first.place,
                reason=first.reason,
                what=self._shape.what,
            )


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return "_" not in field


def _values(count: int) -> Message:
    return count_msg(count, "{n} value", "{n} values")
