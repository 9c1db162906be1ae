"""Places on the floor as text: what PedPy loads, and what PeTrack exports.

Comments (`# framerate: 25 fps`, and last the columns, `# id frame x/m y/m z/m`), then rows of
numbers divided by spaces. Frames count from 0, ids from 1 in what PeTrack writes; lengths are
metres, or centimetres where the columns say `x/cm`. Older files say neither unit nor frame rate, or
have no comments at all: then the user says them. PeTrack's file has its own comments before the
columns and one person after the other. Further columns (PeTrack's direction of view, marker) are
passed over, as is z: it may be a head's or a person's height; written it is 0, the floor.

PedPy takes the last unit it finds in the comments, in words ("in m") as in columns, and the first
number of any comment with the word framerate: so nothing else written there may look like either.
Sources: PedPy's ped_data_archive_loader; PeTrack's TrackerReal::exportTxt and manual.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.atomic_output import replacing_bytes
from tracking.errors import UnitUnsaidError
from tracking.formats.delimited_text import NumberRows, Piece, RowShape, on_lines, pieces_of
from tracking.formats.floor_rows import Places, fps_of, on_floor, with_place
from tracking.formats.label_text import line
from tracking.formats.number_text import constant, lines_of, numbers, whole_numbers
from tracking.formats.read_result import FASTEST_FPS, Filmed, Imported, Reading, Stated
from tracking.formats.track_format import HEAD_BYTES, Content, TrackFormat
from tracking.formats.track_writer import ROWS_AT_ONCE, Exported
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns
from tracking.translation import Message, msg

_SHAPE = RowShape(msg("text of places on the floor"), 4, 40, " ")
_COLUMNS_LINE = b"# id frame x/m y/m z/m\n"
_SPACES = re.compile(r"[^\S\n]+")
_AT_ENDS = re.compile(r"^ | $", re.MULTILINE)
_FRAMERATE = re.compile(r"framerate\s*[:=]?\s*(\d+(?:\.\d*)?(?:[eE][-+]?\d+)?)", re.IGNORECASE)
_UNIT = re.compile(
    r"\bx ?[/\[(] ?(cm|m)\b|\bin (cm|centimet(?:er|re)s?|m|met(?:er|re)s?)\b", re.IGNORECASE
)
_MEANT = re.compile(r"framerate|\bin c?m|x ?/|#", re.IGNORECASE)
_ROW = re.compile(rb"\s*-?\d+(\.0*)?(\s+[-+]?[\d.]+([eE][-+]?\d+)?){3,39}\s*")
_BARE_ROW = re.compile(rb"\s*\d+\s+\d+(\s+[-+]?[\d.]+([eE][-+]?\d+)?){2,3}\s*")
"""Id, frame, x, y and mostly z: as older exports of PeTrack have them."""
_MOST_COMMENTS = 10_000
_FIRST_LINES = 50
"""So many rows tell a text without comments."""
_PETRACK = b"# PeTrack"
_METRES = {"m": 1.0, "cm": 0.01}


def looks_like_petrack(_path: Path, head: bytes) -> bool:
    """Whether a text begins as PeTrack's exports do."""
    return head.removeprefix(b"\xef\xbb\xbf").startswith(_PETRACK) and _is_floor_text(head)


def looks_like_pedpy(path: Path, head: bytes) -> bool:
    """Whether a text has comments of a frame rate or of a unit, or id, frame and a place a row."""
    return not looks_like_petrack(path, head) and _is_floor_text(head)


def _is_floor_text(head: bytes) -> bool:
    lines = head.removeprefix(b"\xef\xbb\xbf").splitlines()
    comments = 0
    while comments < len(lines) and (lines[comments][:1] == b"#" or not lines[comments].strip()):
        comments += 1
    text = b"\n".join(lines[:comments]).decode("utf-8", "replace")
    if not (_FRAMERATE.search(text) or _UNIT.search(text)):
        whole = lines if len(head) < HEAD_BYTES else lines[:-1]
        rows = [line for line in whole[comments:] if line.strip()][:_FIRST_LINES]
        return bool(rows) and all(map(_BARE_ROW.fullmatch, rows))
    return comments == len(lines) or _ROW.fullmatch(lines[comments]) is not None


def import_floor_text(path: Path, filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a text.

    What it says itself counts, whatever the user says; that is noted. Raises UnitUnsaidError where
    nobody says its unit, FormatError where it is no such text.
    """
    reading = Reading(path, report)
    comments = _Comments()

    def trial(table: NDArray[np.float64], lines: NDArray[np.int32]) -> None:
        rows = {"frame": table[:, 1], "track": table[:, 0]}  # of lengths the unit is not known yet
        Reading(path).checked(rows, on_lines(lines), least_track=0)

    rows_of = NumberRows(reading, _SHAPE, trial)
    table, lines = rows_of.read(comments.passed_over(pieces_of(path, report)))
    unit = comments.unit_of(path, filmed.stated.unit)
    fps = filmed.stated.fps if comments.fps is None else comments.fps
    reading.notes += _passed_over(comments, filmed.stated, unit, fps)
    rows: dict[str, NDArray[Any]] = {
        "frame": table[:, 1],
        "track": reading.ids_from_zero(table[:, 0]),
        "x": table[:, 2] * _METRES[unit],
        "y": table[:, 3] * _METRES[unit],
    }
    return reading.imported(with_place(rows), on_lines(lines), fps=fps)


class _Comments:
    """What the comments say that stand before the first row."""

    def __init__(self) -> None:
        self.fps: float | None = None
        self.wrong_fps = ""
        self._unit = ""
        self._first_row_seen = False
        self._count = 0

    def passed_over(self, pieces: Iterator[Piece]) -> Iterator[Piece]:
        """The lines with comments taken out and one space between numbers."""
        for piece in pieces:
            rows = [self._row(line) for line in piece.lines]
            text = _AT_ENDS.sub("", _SPACES.sub(" ", "\n".join(rows)))
            yield replace(piece, lines=text.split("\n") if rows else [])

    def unit_of(self, path: Path, stated: str) -> str:
        """Of lengths, as the text or else the user says: "m" or "cm"."""
        said = "cm" if self._unit.startswith("c") else "m" if self._unit else ""
        if not said and not stated:
            raise UnitUnsaidError(
                "{path} does not say its unit",
                "say it with --unit m or --unit cm, or put '# id frame x/m y/m z/m' before its "
                "rows, x/cm y/cm where they are centimetres",
                path=path,
            )
        return said or stated

    def _row(self, line: str) -> str:
        if not line.startswith("#"):
            self._first_row_seen = self._first_row_seen or not line.isspace()
            return line
        if not self._first_row_seen and self._count < _MOST_COMMENTS:
            self._take(line)
        return ""

    def _take(self, line: str) -> None:
        self._count += 1
        if self.fps is None and (found := _FRAMERATE.search(line)):
            fps = float(found[1])
            self.fps = fps if 0 < fps < FASTEST_FPS else None
            self.wrong_fps = found[1] if self.fps is None else ""
        for found in _UNIT.finditer(line):
            self._unit = (found[1] or found[2]).lower()


def _passed_over(
    comments: _Comments, stated: Stated, unit: str, fps: float | None
) -> Iterator[Message]:
    """What of the comments and of what the user says does not count; unit and fps: what does."""
    if comments.wrong_fps:
        wrong = msg(
            "the file says {wrong_fps} frames per second", wrong_fps=comments.wrong_fps[:20]
        )
        yield msg("{wrong}, which is invalid and passed over", wrong=wrong)
    if stated.unit not in ("", unit):
        yield msg(
            "the file says {unit} itself; {stated_unit} is passed over",
            unit=unit,
            stated_unit=stated.unit,
        )
    if stated.fps not in (None, fps):
        own = msg("the file says {fps:g} frames per second itself", fps=fps)
        yield msg("{own}; {fps:g} is passed over", own=own, fps=stated.fps)


def export_pedpy(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write what PedPy loads, by frame. Raises FormatError without places or frames per second."""
    fps = fps_of(path, exported)
    Places(path, exported)
    name = line(exported.name)
    with replacing_bytes(path) as stream:
        stream.write(f"# framerate: {fps!r} fps\n".encode())
        if name and not _MEANT.search(name):
            stream.write(f"# recording: {name}\n".encode())
        stream.write(_COLUMNS_LINE)
        for piece in exported.pieces(report):
            stream.write(_lines(piece))
    return (path,)


def export_petrack(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write what PeTrack exports, one person after the other. Raises FormatError as the other."""
    fps = fps_of(path, exported)
    Places(path, exported)
    name = line(exported.name)
    project = "" if _MEANT.search(name) else name
    with replacing_bytes(path) as stream:
        stream.write(f"# PeTrack project: {project}\n# raw trajectory file: \n".encode())
        stream.write(f"# framerate: {fps!r} fps\n".encode())
        stream.write(b"# z: can be 3d position or height of person (alternating or not)\n")
        stream.write(_COLUMNS_LINE)
        for rows in _some_at_once(exported, report):
            stream.write(_lines(rows))
    return (path,)


def _some_at_once(exported: Exported, report: Progress) -> Iterator[Columns]:
    """The rows by track, of many short tracks together."""
    waiting: list[Columns] = []
    for _, rows in exported.track_by_track(report):
        waiting.append({name: rows[name] for name in ("track", "frame", "x", "y")})
        if sum(len(part["frame"]) for part in waiting) >= ROWS_AT_ONCE:
            yield _joined(waiting)
            waiting = []
    if waiting:
        yield _joined(waiting)


def _joined(parts: list[Columns]) -> Columns:
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _lines(piece: Columns) -> bytes:
    rows = on_floor({name: piece[name] for name in ("track", "frame", "x", "y")})
    if not len(rows["frame"]):
        return b""
    blocks = [whole_numbers(rows["track"]), whole_numbers(rows["frame"])]
    blocks += [numbers(rows[name], b"nan") for name in ("x", "y")]
    return lines_of([*blocks, constant(b"0", len(rows["frame"]))], b" ")


PEDPY_TEXT = TrackFormat(
    "pedpy-txt",
    "PedPy text",
    (".txt",),
    looks_like_pedpy,
    import_floor_text,
    export_pedpy,
    holds=frozenset((Content.PLACES,)),
    needs=Content.PLACES,
    unit_unsaid=True,
    about="Positions on the floor in metres, for analysis of how people walk; no boxes.",
)
PETRACK = TrackFormat(
    "petrack",
    "PeTrack text",
    (".txt",),
    looks_like_petrack,
    import_floor_text,
    export_petrack,
    holds=frozenset((Content.PLACES,)),
    needs=Content.PLACES,
    unit_unsaid=True,
    about="Positions on the floor in metres, for analysis of how people walk; no boxes.",
)
