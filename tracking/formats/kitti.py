"""KITTI's tracking labels (`label_02/0000.txt`): a row an object a frame, divided by blanks.

`frame id type truncated occluded alpha left top right bottom height width length x y z rotation`,
and in results a score. Frames and pixels count from 0. The place is where the object meets the
floor, in metres along the camera's axes (x right, y down, z forward). KITTI takes it from its left
grey camera, 6 cm beside the left colour camera; here it is the recording's left camera, and what is
written reads back exactly. `DontCare` marks regions of the picture, which belong to nobody.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tracking.atomic_output import replacing_bytes
from tracking.errors import FormatError
from tracking.formats.delimited_text import (
    NumberRows,
    Piece,
    RowShape,
    on_lines,
    pieces_of,
    tell_not_finite,
)
from tracking.formats.mot_classes import CLASS
from tracking.formats.number_text import (
    Block,
    chosen,
    constant,
    lines_of,
    numbers,
    short_decimals,
    whole_numbers,
)
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.row_rules import BOX
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import Exported
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns, TrackLabel
from tracking.translation import msg

if TYPE_CHECKING:
    from tracking.geometry import View

PERSON, DONT_CARE, OTHER = "Pedestrian", "DontCare", "Misc"
TYPES = (PERSON, "Car", "Van", "Truck", "Person", "Person_sitting", "Cyclist", "Tram", OTHER)

UNKNOWN_SIDE, UNKNOWN_ANGLE, UNKNOWN_PLACE = -1, -10, -1000

VISIBILITY = np.array([1.0, 0.5, 0.1, np.nan])
"""How much is seen, by KITTI's occlusion: nothing hidden, a part, most of it, unknown."""
UNKNOWN_OCCLUSION = 3

_IN_LOWER_CASE = {name.lower(): name for name in TYPES}


def occlusion_of(visibility: NDArray[Any]) -> NDArray[np.int64]:
    """(n,) KITTI's number for how much of each is seen, the nearest one.

    Where nobody knows, all is: scorers leave out people of whom it is said to be unknown.
    """
    seen = np.where(np.isnan(visibility), 1.0, visibility)
    off = np.abs(seen[:, None] - VISIBILITY[:UNKNOWN_OCCLUSION])
    return np.asarray(off.argmin(axis=1), np.int64)


def kept_visibility(visibility: NDArray[Any], _predicted: NDArray[Any]) -> NDArray[np.float64]:
    """(n,) what is left of visibilities that were written."""
    return VISIBILITY[occlusion_of(visibility)]


def label_of_type(name: str) -> TrackLabel:
    """What a track's label says of its type; nothing of people."""
    return TrackLabel() if name == PERSON else TrackLabel(attributes={CLASS: name})


def type_of_label(label: TrackLabel) -> str:
    """KITTI's word for a track's class; people where the label says nothing of it."""
    name = label.attributes.get(CLASS, PERSON).strip().lower()
    return PERSON if name == "person" else _IN_LOWER_CASE.get(name, OTHER)


_TYPES = [name.encode() for name in TYPES]


def export_kitti(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks as KITTI's labels; results end in their score, ground truth does not.

    `truncated` is always 0: how much of a person lies outside the picture is not known, and scorers
    leave out rows where it is above 0. They leave out rows where `occluded` is 3, too: it is 3 for
    rows that do not count, and 0 where the visibility is not known.

    Places are written where camera and floor are known. How large people are and where they face is
    not. Gives the file made; raises OutputError and what `report` raises.
    """
    kinds = {
        track: TYPES.index(kind)
        for track, label in exported.labels.items()
        if (kind := type_of_label(label)) != PERSON
    }
    with replacing_bytes(path) as stream:
        for piece in exported.pieces(report):
            blocks = _blocks(piece, exported, kinds)
            if not exported.is_ground_truth(path):
                score = short_decimals(exported.confidence(piece))
                blocks.append(numbers(score, b"%d" % UNKNOWN_SIDE))
            stream.write(lines_of(blocks, b" "))
    return (path,)


def _blocks(rows: Columns, exported: Exported, kinds: dict[int, int]) -> list[Block]:
    count = len(rows["frame"])
    kind = np.zeros(count, np.int64)
    for track, number in kinds.items():
        kind[rows["track"] == track] = number
    box = np.column_stack([rows[name] for name in BOX])
    box[:, 2:] += box[:, :2]
    unknown_size = [constant(b"%d" % UNKNOWN_SIDE, count)] * 3
    angle = constant(b"%d" % UNKNOWN_ANGLE, count)
    occluded = np.where(exported.counted(rows), occlusion_of(rows["visibility"]), UNKNOWN_OCCLUSION)
    return [
        whole_numbers(rows["frame"]),
        whole_numbers(rows["track"]),
        chosen(_TYPES, kind),
        constant(b"0", count),
        whole_numbers(occluded),
        angle,
        *(numbers(side, b"%d" % UNKNOWN_SIDE) for side in box.T),
        *unknown_size,
        *(numbers(axis, b"%d" % UNKNOWN_PLACE) for axis in _in_camera(rows, exported.view)),
        angle,
    ]


def _in_camera(rows: Columns, view: View | None) -> NDArray[np.float64]:
    """(3, n) where people stand, along the camera's axes in metres; NaN where unknown."""
    count = len(rows["frame"])
    if view is None:
        return np.full((3, count), np.nan)
    rotation, centre = view.world_from_camera
    world = np.column_stack([rows["x"], rows["y"], np.zeros(count)])
    return np.asarray(((world - centre) @ rotation).T)


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
        Reading(path).checked(rows, on_lines(lines[cared]), least_track=0)

    rows_of = NumberRows(reading, _SHAPE, trial)
    table, lines = rows_of.read(_with_numbered_types(reading, types))
    cared = table[:, _TYPE] != types[DONT_CARE]
    regions = len(table) - int(cared.sum())
    if regions:
        reading.notes.append(
            msg("{regions} regions nobody cares about (DontCare) are left out", regions=regions)
        )
    finite = np.isfinite(table).all(axis=1)
    tell_not_finite(reading, lines[cared & ~finite])
    table, lines = table[cared & finite], lines[cared & finite]
    table[:, _TRACK] = reading.ids_from_zero(table[:, _TRACK])
    rows = _columns(table, filmed.view)
    if filmed.view is None and bool(_known_places(table).any()):
        reading.notes.append(
            msg("places are left out: the recording says nothing of camera and floor")
        )
    labels = _labels_of(table, list(types))
    return reading.imported(rows, on_lines(lines), labels=labels, seen_as=kept_visibility)


def _labels_of(table: NDArray[np.float64], types: Sequence[str]) -> dict[int, TrackLabel]:
    """What the first rows of tracks say of their type, where it says anything."""
    tracks, first = np.unique(table[:, _TRACK], return_index=True)
    kinds = (types[int(kind)] for kind in table[first, _TYPE])
    labels = {int(t): label_of_type(k) for t, k in zip(tracks, kinds, strict=True)}
    return {track: label for track, label in labels.items() if not label.is_empty}


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
                reading.bad(
                    msg("line {number}", number=number),
                    msg("the type {fields!r} is no word", fields=fields[_TYPE][:40]),
                )
                fields = []
            lines.append(" ".join(fields))
        if len(types) > _MOST_TYPES:
            raise FormatError(
                "{path}: more than {most} types; is it KITTI's labels?",
                path=reading.path,
                most=_MOST_TYPES,
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


_NUMBER = rb"[-+]?(?:nan|inf|[\d.]+(?:e[-+]?\d+)?)"
_FIRST_LINE = re.compile(
    rb"%b[ \t]+%b[ \t]+[a-z_]{1,40}(?:[ \t]+%b){14,15}[ \t\r]*" % (_NUMBER, _NUMBER, _NUMBER),
    re.IGNORECASE,
)


def _recognises(_path: Path, head: bytes) -> bool:
    first = head.removeprefix(b"\xef\xbb\xbf").lstrip().split(b"\n", 1)[0]
    return _FIRST_LINE.fullmatch(first) is not None


KITTI = TrackFormat(
    "kitti",
    "KITTI tracking labels",
    (".txt",),
    _recognises,
    import_kitti,
    export_kitti,
    in_camera=True,
    holds=frozenset(
        (
            Content.BOXES,
            Content.PLACES,
            Content.CONFIDENCE,
            Content.VISIBILITY,
            Content.CLASSES,
        )
    ),
    confidence_in_results=True,
    about="Boxes, and positions in the camera's coordinates where the floor is known.",
)
