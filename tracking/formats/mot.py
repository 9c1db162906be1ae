"""MOTChallenge text: a row a person a frame, numbers divided by commas.

Three dialects share their first seven numbers, `frame, id, left, top, width, height, conf`: what
trackers give ends there; the challenge of 2015 adds the place in the world, `x, y, z`; those of
2016 and later add `class, visibility`. The text counts frames and pixels from 1; everything else in
this program counts from 0, so both are shifted here and in `mot_writer`, and nowhere
else. `-1` stands for a number that is not known. `#` and what stands
behind it in a line is a comment.
"""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.delimited_text import (
    NumberRows,
    RowShape,
    on_lines,
    pieces_of,
    tell_not_finite,
)
from tracking.formats.mot_classes import kept_visibility, labels_of_classes
from tracking.formats.mot_writer import export_mot, export_mot_classes
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.row_rules import BOX
from tracking.formats.seqinfo import sequence_of
from tracking.formats.track_format import Content, TrackFormat
from tracking.progress import Progress, no_progress

UNKNOWN = -1.0
FIRST_FRAME = 1
_NO_ID = -1
_SHAPE = RowShape("MOT text", least=6, most=10, comment="#")
_HEAD = ("frame", "track", *BOX, "confidence")
_WORLD = ("x", "y", "z")
_SEEN = ("class", "visibility")


def read_mot(path: Path) -> dict[str, NDArray[Any]]:
    """The rows of a MOT text, by frame; rows of one frame keep their order in the file.

    Six to ten numbers a row are read, of any of the three dialects.

    Returns:
        `frame` and `track` (int32, from 0), `left, top, width, height` (pixels, 0-based),
        `confidence` (the text's `conf`; 0 marks a don't-care in truth), `x, y, z` (metres),
        `visibility` (0 to 1), `class` (see `mot_classes`; 1 is a person). NaN where unknown.

    Raises:
        FormatError: the file is missing, not such a text, or a row is invalid; names the line.
    """
    reading = Reading(path)
    rows = rows_by_frame(reading)
    _check_no_bad(reading)
    return rows


def people_in_mot(path: Path) -> int:
    """How many ids the rows of a MOT text have; of the rows nothing is kept, however many.

    Raises FormatError as `read_mot`, but for an id that stands twice in a frame.
    """
    reading = Reading(path)
    ids: set[int] = set()
    for table, lines, _ in NumberRows(reading, _SHAPE).tables(pieces_of(path)):
        ids.update(_ids_of(reading, table, lines).tolist())
        _check_no_bad(reading)
    _check_no_bad(reading)
    return len(ids)


def _ids_of(
    reading: Reading, table: NDArray[np.float64], lines: NDArray[np.int32]
) -> NDArray[np.int32]:
    """The ids of some rows, after they are checked."""
    good = reading.good  # the check counts those of this table alone
    rows, places = _columns(reading, table, lines)
    checked = reading.checked(rows, on_lines(places), least_track=0)
    reading.good = good
    ids: NDArray[np.int32] = np.unique(checked["track"])
    return ids


def _check_no_bad(reading: Reading) -> None:
    if reading.bad_count:
        first = reading.bad_rows[0]
        where = f"{reading.path}, {first.place}: {first.reason}"
        raise FormatError("{where}; correct or remove the row", where=where)


def rows_by_frame(reading: Reading) -> dict[str, NDArray[Any]]:
    """The rows of a MOT text that are valid, as `read_mot` gives them; the others are told.

    Ids are those of the file, 0 as well: whoever compares tracks needs them as labels only.
    """
    rows, lines = _rows(reading)
    rows = reading.checked(rows, on_lines(lines), least_track=0)
    order = np.argsort(rows["frame"], kind="stable")
    return {name: column[order] for name, column in rows.items()}


def import_mot(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a MOT text, with what a `seqinfo.ini` beside it says of the footage.

    Tracks of another class than people bear it as their attribute "class"; rows the challenge does
    not count (`conf` 0) keep a confidence of 0. Raises FormatError as `read_mot`, but for bad rows.
    """
    reading = Reading(path, report)
    rows, lines = _rows(reading)
    _refuse_detections(path, rows["track"])
    rows["track"] = reading.ids_from_zero(rows["track"])
    sequence = sequence_of(path, reading)
    return reading.imported(
        rows,
        on_lines(lines),
        labels=labels_of_classes(rows["track"], rows["class"]),
        fps=sequence.fps,
        size_px=sequence.size_px,
        frames=sequence.frames,
        seen_as=kept_visibility,
        first_frame=FIRST_FRAME,
    )


def _refuse_detections(path: Path, track: NDArray[Any]) -> None:
    """Raise FormatError where all ids are -1: detectors write so, and nobody is told apart."""
    if len(track) and (track == _NO_ID).all():
        raise FormatError(
            "{path}: all ids are -1, so these are detections of a detector, not tracks",
            "name the file where a tracker is chosen, under Detections (trackwright track "
            "--detections); in the recording's folder as det.txt it gives the suggested boxes, too",
            path=path,
        )


def _rows(reading: Reading) -> tuple[dict[str, NDArray[Any]], NDArray[np.int32]]:
    """The columns as `read_mot` gives them, unchecked, and the lines they stand on."""

    def trial(table: NDArray[np.float64], lines: NDArray[np.int32]) -> None:
        tried = Reading(reading.path)
        rows, places = _columns(tried, table.copy(), lines)
        tried.checked(rows, on_lines(places), least_track=0)

    read = NumberRows(reading, _SHAPE, trial).read(pieces_of(reading.path, reading.report))
    return _columns(reading, *read)


def _columns(
    reading: Reading, table: NDArray[np.float64], lines: NDArray[np.int32]
) -> tuple[dict[str, NDArray[Any]], NDArray[np.int32]]:
    """Those of a table as it stands in the text, which they take the place of in memory."""
    finite = _finite(table)
    if not finite.all():
        tell_not_finite(reading, lines[~finite])
        table, lines = table[finite], lines[finite]
    held = _names(table.shape[1])
    columns: dict[str, NDArray[Any]] = dict(zip(held, table.T, strict=False))
    for name in (*_HEAD, *_WORLD, *_SEEN):
        if name not in columns:
            columns[name] = np.full(len(table), UNKNOWN)
    columns["frame"] -= FIRST_FRAME
    _shift_to_zero(columns)
    return columns, lines


def _finite(table: NDArray[np.float64]) -> NDArray[np.bool_]:
    """(n,) the rows of finite numbers; looked at by columns, which stand together in memory."""
    finite = np.ones(len(table), bool)
    for column in table.T:
        finite &= np.isfinite(column)
    return finite


def _names(width: int) -> tuple[str, ...]:
    """What the columns of rows of so many numbers are."""
    return _HEAD + (_WORLD if width == _SHAPE.most else _SEEN)


def _shift_to_zero(columns: dict[str, NDArray[Any]]) -> None:
    """Pixels from 0, and NaN where the text says -1.

    A single -1 may be a place: only a box or a floor position that is -1 throughout is unknown.
    """
    for group in (BOX, ("x", "y"), ("z",), ("confidence",), ("visibility",), ("class",)):
        unknown = np.logical_and.reduce([columns[name] == UNKNOWN for name in group])
        for name in group:
            columns[name][unknown] = np.nan
    columns["left"] -= 1.0
    columns["top"] -= 1.0


_NUMBER = rb"[ \t]*[-+]?(?:nan|inf|[\d.]+(?:e[-+]?\d+)?)[ \t]*"
"""Also what no row can hold: a reader tells the line and why, nobody else does."""
_ONE = re.compile(_NUMBER, re.IGNORECASE)
_DIVIDERS = re.compile(rb"(?<=\S)(?:[ \t]*;[ \t]*|[ \t]+)(?=\S)")
_LEAST, _MOST = 6, 10
_WITH_CLASSES = (8, 9)
_LINES = 50
"""So many lines say what a text is, where its first one is bad."""


def _numbers_in_a_row(head: bytes) -> int:
    """How many numbers a row holds; 0 where the text is no MOT text.

    Rows may be bad, the first one too: most lines must look like rows. A first line without any
    number is the header of another table.
    """
    text = head.removeprefix(b"\xef\xbb\xbf").lstrip()
    rows = (line.partition(b"#")[0] for line in text.split(b"\n"))
    lines = [row for row in rows if row.strip()][:_LINES]
    if not lines or not any(map(_ONE.fullmatch, _fields(lines[0]))):
        return 0
    lengths = [len(_fields(line)) for line in lines if _is_like_a_row(line)]
    return Counter(lengths).most_common(1)[0][0] if len(lengths) * 2 > len(lines) else 0


def is_mot(head: bytes) -> bool:
    """Whether a text is MOT text of any dialect, by its first bytes."""
    return _numbers_in_a_row(head) > 0


def lacks_commas(head: bytes) -> bool:
    """Whether a text would be MOT text with commas in place of its spaces or semicolons."""
    return b"," not in head and _numbers_in_a_row(_DIVIDERS.sub(b",", head)) > 0


def _fields(line: bytes) -> list[bytes]:
    return line.rstrip(b"\r").split(b",", _MOST)


def _is_like_a_row(line: bytes) -> bool:
    """Whether it has as many values as a row, and all but one of them are numbers."""
    fields = _fields(line)
    numbers = sum(_ONE.fullmatch(field) is not None for field in fields)
    return _LEAST <= len(fields) <= _MOST and numbers >= len(fields) - 1


def _with_world(_path: Path, head: bytes) -> bool:
    count = _numbers_in_a_row(head)
    return count > 0 and count not in _WITH_CLASSES


def _with_classes(_path: Path, head: bytes) -> bool:
    return _numbers_in_a_row(head) in _WITH_CLASSES


MOT = TrackFormat(
    "mot",
    "MOTChallenge text, world columns",
    (".txt",),
    _with_world,
    import_mot,
    export_mot,
    by_numbers=True,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.PLACES, Content.CONFIDENCE)),
    confidence_in_results=True,
    about="Boxes of the left image, positions on the floor where known; for scorers.",
)
MOT16 = TrackFormat(
    "mot16",
    "MOTChallenge text from 2016 on, class and visibility",
    (".txt",),
    _with_classes,
    import_mot,
    export_mot_classes,
    by_numbers=True,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.CONFIDENCE, Content.VISIBILITY, Content.CLASSES)),
    confidence_in_results=True,
    about="Boxes with class and visibility, with seqinfo.ini; for scorers.",
)
