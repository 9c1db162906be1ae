"""Tracks as MOTChallenge text; see `mot` for what it looks like."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.formats.seqinfo import place_for, sequence_text
from tracking.formats.writing import ROWS_AT_ONCE, Exported
from tracking.progress import Progress
from tracking.replacing import replacing
from tracking.tracks import Columns

_UNKNOWN = -1.0
_NAMES = ("frame", "track", "left", "top", "width", "height", "confidence", "x", "y", "z")


def write_mot(path: Path, columns: Columns) -> None:
    """Write tracks as MOT text with ten columns, in the order of the rows.

    Numbers are written with every digit they have, so that scores of the text and of the tracks
    are equal. `path` appears only when all of it is written.

    Args:
        path: where; replaced if it exists.
        columns: `frame, track, left, top, width, height` and, where known, `confidence, x, y, z`;
            without z, positions are on the floor.

    Raises:
        OutputError: the file cannot be written.
    """
    with replacing(path) as stream:
        for start in range(0, len(columns["frame"]), ROWS_AT_ONCE):
            piece = slice(start, start + ROWS_AT_ONCE)
            stream.writelines(_lines({name: column[piece] for name, column in columns.items()}))


def export_mot(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks as MOT text with world columns, and their `seqinfo.ini` where `gt` has one."""
    with replacing(path) as stream:
        for piece in exported.pieces(report):
            stream.writelines(_lines(piece))
    return (path, *_described(path, exported))


def _described(path: Path, exported: Exported) -> tuple[Path, ...]:
    """The description of the sequence, where the text stands in the challenge's own folders."""
    place = place_for(path)
    if place.parent == path.parent:
        return ()
    with replacing(place) as stream:
        stream.write(sequence_text(exported))
    return (place,)


def _lines(columns: Columns) -> Iterator[str]:
    """The rows as text."""
    whole = [(columns["frame"] + 1).tolist(), columns["track"].tolist()]
    rest = [_column(columns, name) for name in _NAMES[2:]]
    for frame, track, *numbers in zip(*whole, *rest, strict=True):
        yield f"{frame},{track},{','.join(map(_written, numbers))}\n"


def _column(block: Columns, name: str) -> list[float]:
    """A column's values as the text has them: from 1, NaN where unknown."""
    if name == "z" and name not in block and "x" in block:
        # Where people stand is on the floor, which is z = 0.
        return [math.nan if math.isnan(x) else 0.0 for x in block["x"].tolist()]
    if name not in block:
        return [math.nan] * len(block["frame"])
    values = block[name]
    if name == "confidence":
        # Stored with 32 bits; the digits beyond are noise of the conversion.
        return [float(f"{value:.6g}") for value in values.tolist()]
    values = values.astype(np.float64)
    values = values + 1.0 if name in ("left", "top") else _known(values)
    return [float(value) for value in values]


def _known(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same numbers, with no -1 that would be read as unknown."""
    return np.where(values == _UNKNOWN, np.nextafter(_UNKNOWN, 0.0), values)


def _written(value: float) -> str:
    if math.isnan(value):
        return "-1"
    digits = repr(value)
    return digits[:-2] if digits.endswith(".0") else digits
