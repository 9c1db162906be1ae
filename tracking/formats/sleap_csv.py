"""SLEAP's analysis as CSV, read: a line an instance, with the points of a skeleton's nodes.

`track, frame_idx, instance.score`, then `NODE.x, NODE.y, NODE.score` of each node; what was not
found is empty. Frames count from 0. Tracks are told by name: `track_7` is id 8, as in the HDF5;
where one is called otherwise, ids follow the order in which tracks come. Instances without a track
are left out, which is told; where nobody has one, those at one place of each frame's lines are one
track. Source: sleap-io's io/csv.py, SLEAP's write of analysis CSV.
"""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.delimited_text import TRIED_ROWS
from tracking.formats.label_text import label_of, left_out
from tracking.formats.line_survey import MOST_ROWS
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.row_rules import MAX_FRAME
from tracking.formats.sleap_points import (
    AROUND_POINTS,
    NO_TRACKS,
    UNTRACKED,
    USUAL_NAME,
    ids_of,
    places_in,
)
from tracking.formats.text_fields import fields_of, number_in, numbered_lines, whole_in
from tracking.progress import Progress, no_progress
from tracking.translation import msg

_TRACK, _FRAME, _SCORE = "track", "frame_idx", "instance.score"
_MOST_COLUMNS = 5000
_MOST_TRACKS = 100_000


def is_sleap_csv(head: bytes) -> bool:
    """Whether a file begins with the header of SLEAP's analysis."""
    first = head.removeprefix(b"\xef\xbb\xbf").split(b"\n", 1)[0].decode(errors="replace")
    names = fields_of(first.rstrip("\r"))
    return _FRAME in names and _SCORE in names and any(name.endswith(".x") for name in names)


def import_sleap_csv(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a table. Raises FormatError where it has no such header."""
    lines = numbered_lines(path, report)
    _, header = next(lines, (0, ""))
    table = _Table(Reading(path, report), fields_of(header))
    for number, text in lines:
        if text.strip():
            table.take(number, fields_of(text))
    return table.imported()


class _Table:
    """Takes the lines of a table in."""

    def __init__(self, reading: Reading, names: Sequence[str]) -> None:
        """names: of its columns. Raises FormatError where some are missing."""
        self._reading, self._names = reading, names
        if _FRAME not in names or len(names) > _MOST_COLUMNS or len(set(names)) < len(names):
            raise FormatError(
                "{path}, line 1: it is no header of SLEAP's analysis", path=reading.path
            )
        nodes = [name.removesuffix(".x") for name in names if name.endswith(".x")]
        self._nodes = [
            (names.index(f"{node}.x"), names.index(f"{node}.y"))
            for node in nodes
            if f"{node}.y" in names
        ]
        self._whole, self._numbers = array("q"), array("d")  # line, frame, track; box, confidence
        self._tracks: dict[str, int] = {}

    def take(self, number: int, fields: Sequence[str]) -> None:
        """One line."""
        reason = self._row(number, fields)
        if reason:
            self._reading.bad(msg("line {number}", number=number), reason)
        else:
            self._reading.good += 1
            if self._reading.good == TRIED_ROWS:
                self._try()
        if self._reading.good > MOST_ROWS or len(self._tracks) > _MOST_TRACKS:
            raise FormatError(
                "{path} has more rows or tracks than any; split it", path=self._reading.path
            )

    def _try(self) -> None:
        """Raise FormatError where the first rows are such that the file is refused in the end."""
        line, frame, held = np.array(self._whole, np.int64).reshape(-1, 3).T
        if self._tracks:
            tracked = held >= 0
            line, rows = line[tracked], {"frame": frame[tracked], "track": held[tracked]}
            tried = Reading(self._reading.path)
            tried.checked(rows, lambda row: msg("line {line}", line=line[row]), least_track=0)

    def imported(self) -> Imported:
        """The tracks."""
        line, frame, held = np.asarray(self._whole, np.int64).reshape(-1, 3).T
        numbers = np.asarray(self._numbers).reshape(-1, 5)
        track = self._ids(frame, held)
        kept = track > 0
        self._reading.notes.append(AROUND_POINTS)
        rows: dict[str, NDArray[Any]] = {
            "frame": frame[kept],
            "track": track[kept],
            **dict(
                zip(("left", "top", "width", "height", "confidence"), numbers[kept].T, strict=True)
            ),
        }
        places = line[kept]
        labels = {
            number: label_of(name)
            for name, number in ids_of(list(self._tracks)).items()
            if name != USUAL_NAME.format(number - 1)
        }
        return self._reading.imported(
            rows,
            lambda row: msg("line {places}", places=places[row]),
            labels=labels,
            boxes_reach_feet=False,
        )

    def _ids(self, frame: NDArray[np.int64], held: NDArray[np.int64]) -> NDArray[np.int64]:
        """(n,) ids; 0 of rows that are left out."""
        if len(held) and not self._tracks:
            self._reading.notes.append(NO_TRACKS)
            return places_in(frame) + 1
        if untracked := int(np.count_nonzero(held < 0)):
            self._reading.notes.append(left_out(untracked, *UNTRACKED))
        ids = np.array([*ids_of(list(self._tracks)).values(), 0], np.int64)
        return ids[held]

    def _row(self, number: int, fields: Sequence[str]) -> str:
        """Add a line; says why it is invalid where it is."""
        if len(fields) != len(self._names):
            return msg(
                "{count} values where the header names {count_names}",
                count=len(fields),
                count_names=len(self._names),
            )
        said = dict(zip(self._names, fields, strict=True))
        frame = whole_in(said[_FRAME].strip().removesuffix(".0"))
        if frame is None or frame >= MAX_FRAME:
            return msg(
                "the frame_idx {said!r} is not a whole number from 0 on", said=said[_FRAME][:20]
            )
        score = _number(said.get(_SCORE, ""))
        places = [(_number(fields[x]), _number(fields[y])) for x, y in self._nodes]
        if score is None or any(x is None or y is None for x, y in places):
            return msg("a value is not a number")
        seen = np.array(places, np.float64).reshape(-1, 2)
        seen = seen[np.isfinite(seen).all(axis=1)]
        if not len(seen):
            return ""  # an instance nothing was found of, which SLEAP writes, too
        low, high = seen.min(axis=0), seen.max(axis=0)
        name = said.get(_TRACK, "").strip()
        held = self._tracks.setdefault(name, len(self._tracks)) if name else -1
        self._whole.extend((number, frame, held))
        self._numbers.extend((*low.tolist(), *(high - low).tolist(), score))
        return ""


def _number(text: str) -> float | None:
    """A finite number, NaN where there is none; None where it is something else."""
    text = text.strip()
    return np.nan if not text or text.lower() == "nan" else number_in(text)
