"""Tracks from KITTI's labels; see `kitti` for what they look like."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.delimited_text import NumberRows, Piece, RowShape, pieces_of
from tracking.formats.kitti_values import (
    DONT_CARE,
    UNKNOWN_PLACE,
    UNKNOWN_SIDE,
    VISIBILITY,
    kept_visibility,
    label_of_type,
)
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns

if TYPE_CHECKING:
    from tracking.geometry import View

_SHAPE = RowShape("KITTI's labels", least=17, most=18, separator=" ")
_FRAME, _TRACK, _TYPE, _OCCLUDED, _BOX, _PLACE, _SCORE = 0, 1, 2, 4, slice(6, 10), slice(13, 16), 17
_MOST_TYPES = 100
_LONGEST_TYPE = 40
_FARTHEST_M = 1e6


def import_kitti(path: Path, filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of KITTI's labels; on the floor where the recording's camera is known.

    Types other than people stand in the tracks' attribute "class", by a track's first row. Raises
    FormatError where the file as a whole cannot be read.
    """
    reading = Reading(path, report)
    types: dict[str, int] = {DONT_CARE: 0}

    def trial(table: NDArray[np.float64], lines: NDArray[np.int32]) -> None:
        cared = np.flatnonzero(table[:, _TYPE] != types[DONT_CARE])
        rows = {"frame": table[cared, _FRAME], "track": table[cared, _TRACK]}
        Reading(path).checked(rows, lambda row: f"line {lines[cared[row]]}", least_track=0)

    rows_of = NumberRows(reading, _SHAPE, trial)
    table, lines = rows_of.read(_with_numbered_types(reading, types))
    cared = table[:, _TYPE] != types[DONT_CARE]
    regions = len(table) - int(cared.sum())
    if regions:
        reading.notes.append(f"{regions} regions nobody cares about (DontCare) are left out")
    finite = np.isfinite(table).all(axis=1)
    for row in np.flatnonzero(cared & ~finite).tolist():
        reading.bad(f"line {lines[row]}", "a value is not a finite number")
    table, lines = table[cared & finite], lines[cared & finite]
    table[:, _TRACK] = reading.ids_from_zero(table[:, _TRACK])
    rows = _columns(table, filmed.view)
    if filmed.view is None and bool(_known_places(table).any()):
        reading.notes.append("places are left out: the recording says nothing of camera and floor")
    tracks, first = np.unique(table[:, _TRACK], return_index=True)
    names = list(types)
    kinds = (names[int(kind)] for kind in table[first, _TYPE])
    labels = {int(t): label_of_type(k) for t, k in zip(tracks, kinds, strict=True)}
    said = {track: label for track, label in labels.items() if not label.is_empty}
    return reading.imported(
        rows, lambda row: f"line {lines[row]}", labels=said, seen_as=kept_visibility
    )


def _with_numbered_types(reading: Reading, types: dict[str, int]) -> Iterator[Piece]:
    """The lines with a number for each type, which is added to the types, and single blanks.

    A line whose type is no word is told as invalid and left empty: a number would be taken for one
    of those given here.
    """
    for piece in pieces_of(reading.path, reading.report):
        lines = []
        for number, line in enumerate(piece.lines, piece.first):
            fields = line.split()
            if len(fields) > _TYPE and _is_type(fields[_TYPE]):
                fields[_TYPE] = str(types.setdefault(fields[_TYPE], len(types)))
            elif _SHAPE.least <= len(fields) <= _SHAPE.most:
                reading.bad(f"line {number}", f"the type {fields[_TYPE][:40]!r} is no word")
                fields = []
            lines.append(" ".join(fields))
        if len(types) > _MOST_TYPES:
            raise FormatError(
                f"{reading.path}: more than {_MOST_TYPES} types; is it KITTI's labels?"
            )
        yield replace(piece, lines=lines)


def _is_type(word: str) -> bool:
    return word.isidentifier() and len(word) <= _LONGEST_TYPE


def _columns(table: NDArray[np.float64], view: View | None) -> Columns:
    count = len(table)
    left, top, right, bottom = table[:, _BOX].T
    boxes = np.column_stack([left, top, right - left, bottom - top])
    boxes[(table[:, _BOX] == UNKNOWN_SIDE).all(axis=1)] = np.nan
    codes = table[:, _OCCLUDED]
    coded = np.isin(codes, range(len(VISIBILITY)))
    seen = np.where(coded, VISIBILITY[np.where(coded, codes, 3).astype(np.int64)], np.nan)
    score = table[:, _SCORE].copy() if table.shape[1] > _SCORE else np.full(count, np.nan)
    score[score == UNKNOWN_SIDE] = np.nan
    x, y = _floor_places(table, view).T
    return {
        "frame": table[:, _FRAME],
        "track": table[:, _TRACK],
        **dict(zip(("left", "top", "width", "height"), boxes.T, strict=True)),
        "x": x,
        "y": y,
        "confidence": score,
        "visibility": seen,
    }


def _known_places(table: NDArray[np.float64]) -> NDArray[np.bool_]:
    return np.asarray((table[:, _PLACE] != UNKNOWN_PLACE).any(axis=1))


def _floor_places(table: NDArray[np.float64], view: View | None) -> NDArray[np.float64]:
    """(n, 2) world x, y in metres; NaN where unknown."""
    places = np.full((len(table), 2), np.nan)
    if view is not None:
        known = _known_places(table)
        rotation, centre = view.world_from_camera
        in_camera = np.clip(table[known, _PLACE], -2 * _FARTHEST_M, 2 * _FARTHEST_M)
        places[known] = (in_camera @ rotation.T + centre)[:, :2]
    return places
