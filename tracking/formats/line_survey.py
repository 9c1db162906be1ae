"""One quick look through a text before it is read: what no table of tracks has is refused by it.

Nothing is decoded or kept: it takes a fraction of a second and a few megabytes at any size.
"""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO

import numpy as np

from tracking.errors import FormatError

LONGEST_LINE = 1 << 16
"""Bytes; a longer line holds no row of tracks."""

MOST_ROWS = 20_000_000
"""Twice as many as the longest sessions have."""

MOST_EMPTY = 100_000
"""So many lines may be empty where there are few rows."""

_BLOCK = 1 << 18
"""Bytes; fits the processor's cache with what is worked out of it."""
_NEWLINE, _RETURN, _COMMENT = b"\n\r#"


def lines_in(path: Path, stream: BinaryIO) -> int:
    """How many lines a text has; it is read from where it stands to its end.

    Raises FormatError where a line is longer than `LONGEST_LINE`, or the text has zero bytes, far
    more rows than `MOST_ROWS`, or hardly more than empty lines.
    """
    lines = empty = comments = 0
    rest = b""
    while block := stream.read(_BLOCK):
        if b"\0" in block:
            raise FormatError("{path} is not text; give a text file or a session", path=path)
        block = rest + block
        end = block.rfind(b"\n") + 1
        rest = block[end:]
        held = np.frombuffer(block, np.uint8, end)
        ends = np.flatnonzero(held == _NEWLINE)
        starts = np.concatenate(([0], ends + 1))[: len(ends)]
        lengths, first = ends - starts, held[starts]
        for length, at in (
            (lengths.max(initial=0), lengths.argmax() if end else 0),
            (len(rest), len(ends)),
        ):
            if length > LONGEST_LINE:
                raise too_long(path, lines + int(at) + 1)
        lines += len(ends)
        empty += int(((lengths == 0) | ((lengths == 1) & (first == _RETURN))).sum())
        comments += int((first == _COMMENT).sum())
        _check(path, lines - empty - comments, empty)
    return lines + bool(rest)


def _check(path: Path, rows: int, empty: int) -> None:
    # What is read may tell its limit to the row; here a header or two may stand among the rows.
    if rows > MOST_ROWS + MOST_EMPTY:
        raise too_many(path)
    if empty > max(rows, MOST_EMPTY):
        raise FormatError(
            "{path} is hardly more than empty lines; is it a file with tracks?", path=path
        )


def too_many(path: Path) -> FormatError:
    """The error of a text with more than `MOST_ROWS`."""
    return FormatError(
        "{path} has more than {most} rows; split it first", path=path, most=MOST_ROWS
    )


def too_long(path: Path, line: int) -> FormatError:
    """The error of a line beyond `LONGEST_LINE`."""
    return FormatError(
        "{path}, line {line}: longer than {size} kB; is it a file of this format?",
        path=path,
        line=line,
        size=LONGEST_LINE >> 10,
    )
