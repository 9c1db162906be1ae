"""Reading a journal's steps: a large one comes into memory only where its checksum is right."""

from __future__ import annotations

import contextlib
import sqlite3
from collections.abc import Iterator

from tracking.session.journal_faults import is_damage
from tracking.session.journal_limits import LONGEST_CELL, TimeLimit
from tracking.session.journal_rows import COLUMNS, Pieces, Row, row_checksum, text_bytes
from tracking.session.journal_schema import SELECT

_PIECE_BYTES = 1 << 20


def rows_in_order(
    base: sqlite3.Connection,
    before: str,
    used_bytes: int,
    limit: TimeLimit,
    *,
    damaged: bool = False,
) -> Iterator[Row]:
    """The rows of steps; whoever asks for the next one has found the one before it sound.

    Args:
        base: the journal, with a limit to the values that are read before anything is known.
        before: the checksum that the first step follows on.
        limit: of the time, which is running; it is renewed with each sound row.
        used_bytes: of the file: damaged pages that several rows claim are not read again and again.
        damaged: its pages are, so that a large value may claim far more than there is.

    Raises:
        ValueError: in a few words, where a row cannot be one of a journal.
    """
    left, number = used_bytes, 1
    while True:
        try:
            for row in _small_rows(base, number):
                left = _left(left, text_bytes(row))
                yield row
                limit.renew()
                number, before = number + 1, row[-1]
            return
        except sqlite3.Error as why:
            # Python asks for one row ahead: the one that it did not give may be sound.
            if not is_damage(why):
                raise
            is_large = not damaged and why.sqlite_errorcode == sqlite3.SQLITE_TOOBIG
            asked = (
                _large_row(base, number, before, left, limit) if is_large else _row(base, number)
            )
            if asked is None:
                raise
        left = _left(left, text_bytes(asked))
        yield asked
        limit.renew()
        number, before = number + 1, asked[-1]


def _left(left: int, size_bytes: int) -> int:
    if size_bytes > left:
        raise ValueError("its steps claim more than the file holds")
    return left - size_bytes


def _small_rows(base: sqlite3.Connection, number: int) -> Iterator[Row]:
    with contextlib.closing(base.cursor()) as rows:
        yield from rows.execute(f"{SELECT} WHERE number >= ? ORDER BY number", (number,))


def _row(base: sqlite3.Connection, number: int) -> Row | None:
    row: Row | None = base.execute(f"{SELECT} WHERE number = ?", (number,)).fetchone()
    return row


def _large_row(
    base: sqlite3.Connection, number: int, before: str, left: int, limit: TimeLimit
) -> Row:
    """A row that is not read before it is known to be as it was written."""
    names = ", ".join(name for name in COLUMNS if name not in ("before", "after"))
    small = base.execute(f"SELECT {names} FROM steps WHERE number = ?", (number,)).fetchone()
    if small is None:
        raise ValueError(f"step {number} is damaged")
    *said, undoes, scope, message, wanted = small
    with (
        base.blobopen("steps", "before", number, readonly=True) as one,
        base.blobopen("steps", "after", number, readonly=True) as other,
    ):
        _left(left, len(one) + len(other))
        sides = (Pieces(len(side), _parts(side, limit)) for side in (one, other))
        found = row_checksum(before, (*said, *sides, undoes, scope, message))
    if found != wanted:
        raise ValueError(f"step {number} is damaged: it is not what its checksum says")
    limit.renew()
    longest = base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, LONGEST_CELL)
    try:
        row = _row(base, number)
    finally:
        base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, longest)
    if row is None:
        raise ValueError(f"step {number} is damaged")
    return row


def _parts(value: sqlite3.Blob, limit: TimeLimit) -> Iterator[bytes]:
    while part := value.read(_PIECE_BYTES):
        limit.check()
        yield part
