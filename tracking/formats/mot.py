"""MOTChallenge text: a row a person a frame, ten numbers divided by commas.

The text counts frames and pixels from 1; everything else in this program counts from 0, so both
are shifted here and nowhere else. `-1` stands for a number that is not known.
"""

from __future__ import annotations

import io
import math
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.replacing import replacing
from tracking.tracks.columns import Columns

MAX_BYTES = 1 << 30
"""A text larger than this is no annotation of one recording."""

MAX_FRAME = 10_000_000
"""More than four days at 25 frames a second; beyond it a number is a mistake, not a frame."""

MAX_PIXELS = 1e7
_UNKNOWN = -1.0
_LEAST, _MOST = 6, 10
_ROWS_AT_ONCE = 65536
_NAMES = ("frame", "track", "left", "top", "width", "height", "confidence", "x", "y", "z")
_WHOLE = ("frame", "track")


def read_mot(path: Path) -> dict[str, NDArray[Any]]:
    """The rows of a MOT text, by frame; rows of one frame keep their order in the file.

    Six to ten numbers a row are read: `frame, id, left, top, width, height`, then `conf` and, in a
    row of ten, `x, y, z`. Columns 8 and 9 of shorter rows (class and visibility in some of the
    challenge's files) are not used.

    Returns:
        `frame` and `track` (int32, frames from 0), `left, top, width, height` (pixels, 0-based),
        `confidence` (the text's `conf`; 0 marks a don't-care in truth), `x, y, z` (metres).
        NaN where unknown.

    Raises:
        FormatError: the file is missing, not such a text, or a row cannot be meant; names the line.
    """
    text = _text_of(path)
    table = _numbers(path, text)
    _check(path, text, table)
    table = table[np.argsort(table[:, 0], kind="stable")]
    columns: dict[str, NDArray[Any]] = dict(zip(_NAMES, table.T.copy(), strict=True))
    for name in _WHOLE:
        columns[name] = columns[name].astype(np.int32)
    columns["frame"] -= 1
    _shift_to_zero(columns)
    return columns


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
        rows = _lines(columns)
        while block := list(islice(rows, _ROWS_AT_ONCE)):
            stream.writelines(block)


def as_truth(columns: Columns) -> Columns:
    """The same tracks, each row counting in full however sure a tracker was: `conf` is 1.

    Corrected tracks are written so: programs that take a MOT text as truth cut `conf` to a whole
    number and drop the rows where that is 0.
    """
    return {**columns, "confidence": np.ones(len(columns["frame"]), np.float32)}


def _text_of(path: Path) -> str:
    try:
        if path.stat().st_size > MAX_BYTES:
            raise FormatError(f"{path} is larger than {MAX_BYTES >> 20} MB; split it first")
        return path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise FormatError(f"cannot read {path}: {error.strerror}; check the path") from error
    except UnicodeDecodeError as error:
        raise FormatError(f"{path} is not text; give a MOT text file or a session") from error


def _numbers(path: Path, text: str) -> NDArray[np.float64]:
    """(n, 10) the numbers as they stand in the text; missing columns are -1."""
    if not text.strip():
        return np.zeros((0, _MOST))
    try:
        table = np.loadtxt(io.StringIO(text), delimiter=",", comments=None, ndmin=2)
    except ValueError as error:
        raise _first_unreadable(path, text) from error
    if not _LEAST <= table.shape[1] <= _MOST:
        raise _first_unreadable(path, text)
    whole = np.full((len(table), _MOST), _UNKNOWN)
    kept = table.shape[1] if table.shape[1] == _MOST else min(table.shape[1], 7)
    whole[:, :kept] = table[:, :kept]
    return whole


def _first_unreadable(path: Path, text: str) -> FormatError:
    """Says which line is not what a MOT text has there."""
    expected = 0
    for number, line in _filled_lines(text):
        fields = line.split(",")
        expected = expected or len(fields)
        if not _LEAST <= len(fields) <= _MOST:
            reason = f"{len(fields)} values; a MOT row has {_LEAST} to {_MOST}, divided by commas"
        elif len(fields) != expected:
            reason = f"{len(fields)} values where the rows before have {expected}"
        elif bad := next((field for field in fields if not _is_number(field)), None):
            reason = f"{bad.strip()[:40]!r} is not a number"
        else:
            continue
        return FormatError(f"{path}, line {number}: {reason}; is it MOT text?")
    return FormatError(f"{path} is not MOT text: its numbers cannot be read")


def _is_number(field: str) -> bool:
    try:
        float(field)
    except ValueError:
        return False
    return bool(field.strip())


def _filled_lines(text: str) -> Iterator[tuple[int, str]]:
    """Lines that hold something, with their number from 1."""
    return ((n, line) for n, line in enumerate(text.splitlines(), start=1) if line.strip())


def _check(path: Path, text: str, table: NDArray[np.float64]) -> None:
    """Refuse the first row that cannot be meant."""
    for wrong, reason in _rules(table):
        if wrong.any():
            number = next(islice(_filled_lines(text), int(np.argmax(wrong)), None))[0]
            raise FormatError(f"{path}, line {number}: {reason}; correct or remove the row")


def _rules(table: NDArray[np.float64]) -> Iterator[tuple[NDArray[np.bool_], str]]:
    """Marks of the rows that break a rule, and the rule; each may rely on those before it."""
    yield np.any(~np.isfinite(table), axis=1), "a value is not a finite number"
    frame, track, box = table[:, 0], table[:, 1], table[:, 2:6]
    yield (frame < 1) | (frame > MAX_FRAME), f"the frame number is not in 1 to {MAX_FRAME}"
    yield (track < 1) | (track >= 2**31), "the id is not a positive number (raw detections?)"
    yield (frame % 1 != 0) | (track % 1 != 0), "frame and id must be whole numbers"
    yield np.any(np.abs(box) > MAX_PIXELS, axis=1), "the box lies outside any image"
    boxless = np.all(box == _UNKNOWN, axis=1)
    yield np.any(box[:, 2:] < 0, axis=1) & ~boxless, "the box has a negative size"
    yield _repeated(frame, track), "its id stands twice in this frame"


def _repeated(frame: NDArray[np.float64], track: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Rows whose frame and id stood together in an earlier row."""
    order = np.lexsort((track, frame))
    same = (np.diff(frame[order]) == 0) & (np.diff(track[order]) == 0)
    repeated = np.zeros(len(frame), bool)
    repeated[order[1:]] = same
    return repeated


def _shift_to_zero(columns: dict[str, NDArray[Any]]) -> None:
    """Pixels from 0, and NaN where the text says -1.

    A single -1 may be a place: only a box or a floor position that is -1 throughout is unknown.
    """
    box = ("left", "top", "width", "height")
    for group in (box, ("x", "y"), ("z",), ("confidence",)):
        unknown = np.logical_and.reduce([columns[name] == _UNKNOWN for name in group])
        for name in group:
            columns[name][unknown] = np.nan
    columns["left"] -= 1.0
    columns["top"] -= 1.0


def _lines(columns: Columns) -> Iterator[str]:
    """The rows as text."""
    count = len(columns["frame"])
    for start in range(0, count, _ROWS_AT_ONCE):
        block = {name: column[start : start + _ROWS_AT_ONCE] for name, column in columns.items()}
        whole = [(block["frame"] + 1).tolist(), block["track"].tolist()]
        rest = [_column(block, name) for name in _NAMES[2:]]
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
