"""What a file of another tool says, and which of its rows are invalid.

A reader puts what it finds into arrays that count frames, tracks and pixels as this program does,
tells a `Reading` which rows it could not make out, and has it check the rest: `Reading.imported`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.row_rules import broken_rules
from tracking.progress import Progress, no_progress
from tracking.tracks import CORRECTED_COLUMNS, LARGEST_NUMBER, Columns, Schema, TrackLabel, row_keys
from tracking.translation import Message

if TYPE_CHECKING:
    from tracking.geometry import View

MOST_TOLD = 1000
"""So many bad rows are kept with their reasons; further ones are only counted."""

FEW_BAD, MOST_BAD = 10_000, 100_000
"""A file with more bad rows than the second is of another format, or of none; so is one with more
than the first that are more than its good ones so far."""


FASTEST_FPS = 1e5
"""Frames a second; faster cameras film no people."""

SeenAs = Callable[[NDArray[Any], NDArray[Any]], NDArray[Any]]
"""What a format keeps of visibilities, given them and which boxes are predicted."""

PlaceOf = Callable[[int], str]
"""Where in a file a row stands, given its number."""

_ROW = "row of the file"
"""A column that goes with the others while rows are chosen and put in order."""


@dataclass(frozen=True, slots=True)
class BadRow:
    """An invalid row.

    Attributes:
        place: in the file, e.g. "line 12", "annotations[17]", "track 3, frame 40".
        reason: what is wrong with it, e.g. "the box has a negative size".
    """

    place: str
    reason: str


@dataclass(frozen=True, slots=True)
class Stated:
    """What a user says of a text of places that says neither its unit nor its frames a second.

    Attributes:
        unit: of lengths, "m" or "cm"; "": nothing is said. fps: frames a second.
    """

    unit: str = ""
    fps: float | None = None

    def __post_init__(self) -> None:
        if self.unit not in ("", "m", "cm"):
            raise FormatError("unit {unit!r} is unknown; choose m or cm", unit=self.unit)
        if self.fps is not None and not 0 < self.fps < FASTEST_FPS:
            raise FormatError(
                "{fps:g} frames per second are no such number; 25 is usual", fps=self.fps
            )


@dataclass(frozen=True, slots=True)
class Filmed:
    """What is known of the recording a file's tracks are of; everything may be unknown.

    Attributes:
        frames: how many there are. fps: frames a second. size_px: width and height of the pictures.
        view: the left camera over its floor, for formats that tell places as the camera sees them.
        stated: what the user says of a file that does not say it itself.
    """

    frames: int | None = None
    fps: float | None = None
    size_px: tuple[int, int] | None = None
    view: View | None = None
    stated: Stated = field(default_factory=Stated)


@dataclass(frozen=True, slots=True, eq=False)
class Imported:
    """The tracks of a file of another tool.

    Attributes:
        columns: `CORRECTED_COLUMNS`, sorted by frame then track, each id once a frame; NaN where
            the file has none. `source` is 1 (person) in rows the file calls keyframes and 2 in rows
            it says lie between them; 0 where it tells nothing.
        bad_rows: the invalid ones, at most `MOST_TOLD`; they are not in the columns.
        bad_count: how many there are in all.
        labels: what the file says of whole tracks; a class stands as the attribute "class".
        fps, size_px, frames: of the footage, where the file tells.
        notes: what else the user should know of the file, a line each.
        seen_as: what the format keeps of visibilities; None: it keeps them as they are.
        place_of: where in the file a row of the columns stands; None: nobody knows.
        first_frame: the number the file gives the frame that is 0 here.
        track_of_zero: the id here of the file's track 0, which is no id here; 0: it has none.
        boxes_reach_feet: boxes are around whole people, so that their lower edge tells where people
            stand. Else they are points or around parts, as heads.
        schema: which attributes people have, as the file says; empty: it does not.
        head_heights_m: of tracks whose boxes are points of heads: how high above the floor these
            are, in metres; tracks of which the file does not tell it are left out.
    """

    columns: Columns
    bad_rows: tuple[BadRow, ...] = ()
    bad_count: int = 0
    labels: Mapping[int, TrackLabel] = field(default_factory=dict)
    fps: float | None = None
    size_px: tuple[int, int] | None = None
    frames: int | None = None
    notes: tuple[Message, ...] = ()
    seen_as: SeenAs | None = None
    place_of: PlaceOf | None = None
    first_frame: int = 0
    track_of_zero: int = 0
    boxes_reach_feet: bool = True
    head_heights_m: Mapping[int, float] = field(default_factory=dict)
    schema: Schema = ()


class Reading:
    """Collects what a reader meets in one file: bad rows, notes, and in the end its tracks."""

    def __init__(self, path: Path, report: Progress = no_progress) -> None:
        """The file, as messages name it; report is told how far it is read.

        Whoever reads rows adds to `good` as they come.
        """
        self.path, self.report = path, report
        self.notes: list[Message] = []
        self.good = self.bad_count = self._track_of_zero = 0
        self._told: list[BadRow] = []

    @property
    def bad_rows(self) -> tuple[BadRow, ...]:
        """Those met so far, at most `MOST_TOLD`."""
        return tuple(self._told)

    def bad(self, place: str, reason: str) -> None:
        """An invalid row.

        Raises FormatError where there are so many that the file is none of this format.
        """
        self.bad_count += 1
        if len(self._told) < MOST_TOLD:
            self._told.append(BadRow(place, reason))
        most = min(MOST_BAD, max(FEW_BAD, self.good))
        if self.bad_count > most:
            first = self._told[0]
            raise FormatError(
                "{path}: more than {most} invalid rows, the first in {place}: {reason}",
                "is it a file of this format?",
                path=self.path,
                most=most,
                place=first.place,
                reason=first.reason,
            )

    def checked(
        self, rows: Columns, place_of: PlaceOf, least_track: int = 1
    ) -> dict[str, NDArray[Any]]:
        """The valid rows, in the file's order; the others are told.

        Args:
            rows: `frame` (from 0) and `track`, and what is known of `CORRECTED_COLUMNS` and of
                further columns: numbers of any type, NaN where unknown.
            place_of: says where in the file a row stands.
            least_track: see `broken_rules`.

        Returns: the same columns; `frame` and `track` are int32.
        """
        good = np.ones(len(rows["frame"]), bool)
        for wrong, reason in broken_rules(rows, least_track):
            bad = np.flatnonzero(wrong & good)
            good &= ~wrong
            self.good = int(good.sum())
            for row in bad[: MOST_BAD + 1].tolist():
                self.bad(place_of(row), reason)
        every = bool(good.all())  # nothing is copied then: there may be millions
        kept = {name: np.asarray(col) if every else col[good] for name, col in rows.items()}
        return kept | {name: kept[name].astype(np.int32) for name in ("frame", "track")}

    def ids_from_zero(self, track: NDArray[Any]) -> NDArray[Any]:
        """The ids of a format that counts them from 0: all as they are but 0, which is none here.

        It becomes the id after the highest, which `Imported.track_of_zero` tells. Raises
        FormatError where none is left.
        """
        own, self._track_of_zero = positive_ids(track)
        if self._track_of_zero > LARGEST_NUMBER:
            raise FormatError(
                "{path}: no id is left for its track 0; number it anew", path=self.path
            )
        return own

    def imported(self, rows: Columns, place_of: PlaceOf, **known: Any) -> Imported:
        """The tracks of the file: the valid rows, with all columns, in order.

        Args:
            rows, place_of: see `checked`.
            known: `labels, fps, size_px, frames, seen_as, first_frame, boxes_reach_feet,
                head_heights_m, schema` of `Imported`; labels of tracks without a good row go.
        """
        numbers = np.arange(len(rows["frame"]), dtype=np.int32)
        checked = self.checked({**rows, _ROW: numbers}, place_of)
        columns = in_order({**with_all_columns(checked), _ROW: checked[_ROW]})
        origin = columns.pop(_ROW)
        labels: Mapping[int, TrackLabel] = known.pop("labels", {})
        there = set(np.unique(columns["track"]).tolist())
        return Imported(
            columns,
            self.bad_rows,
            self.bad_count,
            {track: labels[track] for track in sorted(there & labels.keys())},
            notes=tuple(self.notes),
            place_of=lambda row: place_of(int(origin[row])),
            track_of_zero=self._track_of_zero,
            **known,
        )


def positive_ids(track: NDArray[Any]) -> tuple[NDArray[Any], int]:
    """Ids from 0 with the one after the highest in place of 0, and that one; 0 where none is 0."""
    zero = track == 0
    if not zero.any():
        return track, 0
    of_zero = int(track[(track >= 0) & (track <= LARGEST_NUMBER)].max()) + 1
    return np.where(zero, np.int64(of_zero), track), of_zero


def with_all_columns(rows: Columns) -> dict[str, NDArray[Any]]:
    """All `CORRECTED_COLUMNS` in their types; NaN, False or 0 where the rows have none."""
    count = len(rows["frame"])
    whole: dict[str, NDArray[Any]] = {}
    for name, dtype in CORRECTED_COLUMNS.items():
        values = np.asarray(rows[name]) if name in rows else np.full(count, np.nan)
        if dtype.kind != "f" and values.dtype.kind == "f":
            values = np.nan_to_num(values)
        whole[name] = np.ascontiguousarray(values, dtype)
    return whole


def in_order(rows: Columns) -> dict[str, NDArray[Any]]:
    """The rows by frame, then track."""
    keys = row_keys(rows["frame"], rows["track"])
    if bool((keys[1:] > keys[:-1]).all()):
        return dict(rows)
    order = np.lexsort((rows["track"], rows["frame"]))
    return {name: column[order] for name, column in rows.items()}
