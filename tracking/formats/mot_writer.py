"""Tracks as MOTChallenge text; see `mot` for what it looks like."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.atomic_output import replacing, replacing_bytes
from tracking.formats.label_text import is_person
from tracking.formats.mot_classes import PERSON, class_of_label, kept_visibility
from tracking.formats.number_text import (
    Block,
    lines_of,
    numbers,
    short_decimals,
    whole_numbers,
)
from tracking.formats.row_rules import BOX
from tracking.formats.seqinfo import place_for, sequence_text
from tracking.formats.track_writer import ROWS_AT_ONCE, Exported
from tracking.progress import Progress
from tracking.tracks import Columns

_UNKNOWN = b"-1"
_WORLD = ("x", "y", "z")


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
    with replacing_bytes(path) as stream:
        for start in range(0, len(columns["frame"]), ROWS_AT_ONCE):
            piece = slice(start, start + ROWS_AT_ONCE)
            stream.write(_with_world({name: column[piece] for name, column in columns.items()}))


def export_mot(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks as MOT text of 2015: ten columns, with the place in the world.

    In ground truth `conf` is 1, or 0 where a row does not count; in results it is the confidence.
    Where the text stands in the challenge's own folders (`NAME/gt/gt.txt`), `NAME/seqinfo.ini` is
    written, too, unless there is one. Gives the files made; raises OutputError and what `report`
    raises.
    """
    with replacing_bytes(path) as stream:
        for piece in exported.pieces(report):
            stream.write(_with_world({**piece, "confidence": _conf(piece, path, exported)}))
    return (path, *_described(path, exported))


def export_mot_classes(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks as MOT text of 2016 and later: nine columns, with class and visibility.

    In ground truth what is no person does not count, as in the challenge's own. Where nobody knows
    how much of a person is seen, all is. As `export_mot` else.
    """
    kinds = {
        track: kind
        for track, label in exported.labels.items()
        if (kind := class_of_label(label)) != PERSON
    }
    others = [track for track, label in exported.labels.items() if not is_person(label)]
    with replacing_bytes(path) as stream:
        for piece in exported.pieces(report):
            classes = np.full(len(piece["frame"]), PERSON)
            for track, number in kinds.items():
                classes[piece["track"] == track] = number
            conf = _conf(piece, path, exported)
            if exported.is_ground_truth(path):
                conf[np.isin(piece["track"], others)] = 0
            stream.write(_with_classes({**piece, "confidence": conf}, classes))
    return (path, *_described(path, exported))


def _described(path: Path, exported: Exported) -> tuple[Path, ...]:
    """The description of the sequence, where the text stands in the challenge's own folders."""
    place = place_for(path)
    if place.parent == path.parent or place.exists():
        return ()  # a sequence that has a description keeps it: it says more than is known here
    with replacing(place) as stream:
        stream.write(sequence_text(exported))
    return (place,)


def _with_world(columns: Columns) -> bytes:
    known = partial(numbers, unknown=_UNKNOWN)
    places = [known(_known(_column(columns, name))) for name in _WORLD]
    return lines_of([*_head(columns), known(_known(_confidence(columns))), *places])


def _conf(rows: Columns, path: Path, exported: Exported) -> NDArray[np.float32]:
    """(n,) the seventh column of a text there.

    TrackEval cuts that of ground truth to a whole number and drops the rows where it is 0;
    py-motmetrics drops those where it is less than 1.
    """
    if exported.is_ground_truth(path):
        return exported.counted(rows).astype(np.float32)
    return exported.confidence(rows)


def _with_classes(columns: Columns, classes: NDArray[np.int64]) -> bytes:
    seen = short_decimals(columns["visibility"])
    return lines_of(
        [
            *_head(columns),
            numbers(_known(_confidence(columns)), _UNKNOWN),
            whole_numbers(classes),
            numbers(kept_visibility(seen, columns["predicted"]), _UNKNOWN),
        ]
    )


def _head(columns: Columns) -> Iterator[Block]:
    """Frame, id and box, which count from 1."""
    yield whole_numbers(columns["frame"].astype(np.int64) + 1)
    yield whole_numbers(columns["track"])
    for name in BOX:
        values = _column(columns, name)
        shifted = values + 1.0 if name in ("left", "top") else _known(values)
        yield numbers(shifted, _UNKNOWN)


def _confidence(columns: Columns) -> NDArray[np.float64]:
    if "confidence" not in columns:
        return np.full(len(columns["frame"]), np.nan)
    return short_decimals(np.asarray(columns["confidence"], np.float32))


def _column(columns: Columns, name: str) -> NDArray[Any]:
    """A column's values, NaN where unknown; who stands somewhere stands on the floor, z = 0."""
    if name in columns:
        return np.asarray(columns[name], np.float64)
    if name == "z" and "x" in columns:
        return np.where(np.isnan(columns["x"]), np.nan, 0.0)
    return np.full(len(columns["frame"]), np.nan)


def _known(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same numbers, with no -1 that would be read as unknown."""
    return np.where(values == -1.0, np.nextafter(-1.0, 0.0), values)
