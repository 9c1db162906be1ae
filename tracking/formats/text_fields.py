"""Lines of text from elsewhere, their fields, and numbers in them: what is none is None."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator
from pathlib import Path

from tracking.formats.delimited_text import pieces_of
from tracking.progress import Progress
from tracking.tracks import LARGEST_NUMBER

_LONGEST_NUMBER = 64
"""Signs; a longer text is no number that a tool writes."""


def numbered_lines(path: Path, report: Progress) -> Iterator[tuple[int, str]]:
    """The lines of a text file with their numbers from 1. Raises FormatError as `pieces_of`."""
    for piece in pieces_of(path, report):
        yield from enumerate((line.rstrip("\r") for line in piece.lines), piece.first)


def fields_of(text: str) -> list[str]:
    """The values of a line of CSV; none where its quotes do not fit."""
    if '"' not in text:
        return text.split(",")
    try:
        return next(csv.reader([text], strict=True), [])
    except csv.Error:
        return []


def whole_in(text: str) -> int | None:
    """A whole number from 0 on that an id or a frame can be."""
    text = text.strip()
    if not (text.isascii() and text.isdigit() and len(text) <= _LONGEST_NUMBER):
        return None
    return int(text) if int(text) <= LARGEST_NUMBER else None


def number_in(text: str) -> float | None:
    """A finite number."""
    if len(text) > _LONGEST_NUMBER or "_" in text:
        return None
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
