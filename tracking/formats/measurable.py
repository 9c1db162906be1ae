"""Tracks of a file as they are measured: truth or result, whatever tool it is of."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tracking.errors import FormatError
from tracking.formats.label_text import is_person
from tracking.formats.mot import rows_by_frame
from tracking.formats.read_result import BadRow, Filmed, Imported, Reading, in_order
from tracking.formats.seqinfo import sequence_of
from tracking.formats.track_format import TrackFormat
from tracking.tracks import Columns
from tracking.translation import Message, count_msg

_MOT = "mot"


@dataclass(frozen=True, slots=True, eq=False)
class Measurable:
    """The rows of a file that are measured.

    Attributes:
        columns: by frame; at least `frame, track`, boxes and places, NaN where unknown. Ids are
            the file's, from 0. Where it is truth, `class` of MOT text says what does not count.
        bad_rows, bad_count, fps, size_px, frames, notes: as in `Imported`.
        dont_cares: in a truth, rows of `confidence` 0 do not count either.
    """

    columns: Columns
    bad_rows: tuple[BadRow, ...] = ()
    bad_count: int = 0
    fps: float | None = None
    size_px: tuple[int, int] | None = None
    frames: int | None = None
    notes: tuple[Message, ...] = ()
    dont_cares: bool = False

    def all_of(self, path: Path) -> Measurable:
        """The same; raises FormatError where even one row of its file is invalid."""
        if self.bad_count:
            first = self.bad_rows[0]
            raise FormatError(
                "{path}, {place}: {reason}; correct or remove the row",
                path=path,
                place=first.place,
                reason=first.reason,
            )
        return self


def measurable(path: Path, kind: TrackFormat, filmed: Filmed) -> Measurable:
    """The tracks of a file of that format, to be measured.

    Rows of MOT text keep their order in a frame, which decides ties, and their classes, which say
    what counts. In other formats tracks that are no people are left out, which is noted.

    Raises FormatError where the file as a whole cannot be read.
    """
    if kind.name.startswith(_MOT):
        return _of_mot(path)
    if kind.read is None:
        raise FormatError(
            "{path} is {title}, which is not read; export it anew", path=path, title=kind.title
        )
    found = _as_numbered(_people_of(kind.read(path, filmed)))
    return Measurable(
        found.columns,
        found.bad_rows,
        found.bad_count,
        found.fps,
        found.size_px,
        found.frames,
        found.notes,
        kind.dont_cares,
    )


def _of_mot(path: Path) -> Measurable:
    reading = Reading(path)
    columns, told = rows_by_frame(reading), sequence_of(path, reading)
    return Measurable(
        columns,
        reading.bad_rows,
        reading.bad_count,
        told.fps,
        told.size_px,
        told.frames,
        tuple(reading.notes),
        dont_cares=True,
    )


def _as_numbered(found: Imported) -> Imported:
    """With the file's own ids: measures need them as labels only, and equals go by them."""
    if not found.track_of_zero:
        return found
    track = found.columns["track"]
    own = np.where(track == found.track_of_zero, 0, track).astype(track.dtype)
    columns = in_order({**found.columns, "track": own})
    return replace(found, columns=columns, place_of=None)


def _people_of(found: Imported) -> Imported:
    """Without tracks of another class."""
    others = [track for track, label in found.labels.items() if not is_person(label)]
    if not others:
        return found
    people = ~np.isin(found.columns["track"], others)
    columns = {name: column[people] for name, column in found.columns.items()}
    note = count_msg(
        len(others),
        "{n} track that is no person is left out",
        "{n} tracks that are no people are left out",
    )
    return replace(found, columns=columns, notes=(*found.notes, note), place_of=None)
