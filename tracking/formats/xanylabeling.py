"""X-AnyLabeling's JSON: a folder with a file a frame, beside the pictures or in one of its own.

A file holds `imageHeight`, `imageWidth` and `shapes`, each with `label`, `points` in pixels,
`shape_type`, `group_id`, `score`, `difficult`, `description` and `attributes`. LabelMe's files are
of the same kind and are read, too.

- A track is what shares a `group_id`; id 0 becomes the id after the highest. Shapes without one are
  left out, which is told.
- A rectangle's points are its edges (four corners; two opposite ones before version 2.2). Of
  polygons, turned rectangles, quadrilaterals, circles and cuboids the box around them is read.
  Points and lines, such as those of a body that share the group of its box, are left out.
- `difficult` marks what does not count, which is confidence 0 here; else `score` is the confidence.
- `description` is the person's name, a `label` other than person its class, `attributes` are those
  of the track.
- The frame is the place of a file's picture among the pictures of the folder, in natural order, as
  X-AnyLabeling shows them. Without pictures it is the number in the file's name, as X-AnyLabeling
  tells frames when it exports MOT: the digits behind the last underscore.

Written, files are called as X-AnyLabeling calls the frames it takes out of a video
(`frame_00000.json`); a frame without boxes has none. The folder must be new, or empty. Gaps stay
gaps; keyframes and places on the floor are not in the format.

Sources: X-AnyLabeling's label_file.py, shape.py, schema.py (the members of a file), utils/video.py
(names of frames), utils/qt.py (order), label_converter.py (custom_to_mot).
"""

from __future__ import annotations

import json
import math
from array import array
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.atomic_output import replacing_folder
from tracking.errors import FormatError
from tracking.formats.json_numbers import number_of, whole_of
from tracking.formats.json_stream import MOST_BYTES, elements_of
from tracking.formats.label_text import (
    attributes_of,
    kind_of,
    label_as_read,
    label_of,
    left_out,
    line,
)
from tracking.formats.line_survey import MOST_ROWS
from tracking.formats.number_text import short_decimals
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.row_rules import BOX
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import Exported, nobody_boxed
from tracking.formats.xanylabeling_folder import (
    ENDING,
    FrameFile,
    frame_files,
    holds_frames,
    looks_like_frame,
)
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns, TrackLabel
from tracking.translation import msg

_VERSION = "4.0.2"
"""Of X-AnyLabeling, whose layout this is; files without any make it warn."""
_PREFIX, _DIGITS = "frame_", 5
"""As X-AnyLabeling calls the frames of a video, unless it is told otherwise."""
_PICTURE = ".jpg"


def export_xanylabeling(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write a folder with a file for each frame that somebody has a box in.

    Raises OutputError where something but an empty folder is at the path; FormatError where no row
    has a box, or the size of the picture is not known.
    """
    if exported.size_px is None:
        raise FormatError(
            "{path}: X-AnyLabeling needs the image's size, which is not known", path=path
        )
    labels = {track: _said(label) for track, label in exported.labels.items()}
    anybody = False
    with replacing_folder(path) as folder:
        for frame, rows in exported.frame_by_frame(report):
            shapes = list(_shapes(rows, exported, labels))
            if shapes:
                anybody = True
                name = f"{_PREFIX}{frame:0{_DIGITS}d}"
                text = _frame(name, exported.size_px, shapes)
                (folder / f"{name}{ENDING}").write_text(text, encoding="utf-8")
        if not anybody:
            raise nobody_boxed(path, "X-AnyLabeling")
    return (path,)


def _frame(name: str, size_px: tuple[int, int], shapes: list[str]) -> str:
    width, height = size_px
    text = ",\n".join(shapes)
    return (
        f'{{\n"version": "{_VERSION}",\n"flags": {{}},\n"checked": false,\n'
        f'"shapes": [\n{text}\n],\n"imagePath": "{name}{_PICTURE}",\n"imageData": null,\n'
        f'"imageHeight": {height},\n"imageWidth": {width},\n"description": ""\n}}\n'
    )


def _said(label: TrackLabel) -> dict[str, Any]:
    """What a label gives each of a track's shapes."""
    return {
        "label": kind_of(label),
        "description": line(label.name),
        "attributes": attributes_of(label),
    }


def _shapes(rows: Columns, exported: Exported, labels: dict[int, dict[str, Any]]) -> Iterator[str]:
    numbers = [rows[name].tolist() for name in ("track", *BOX)]
    numbers += [short_decimals(exported.confidence(rows)).tolist(), exported.counted(rows).tolist()]
    for track, left, top, width, height, confidence, counted in zip(*numbers, strict=True):
        if math.isnan(left):
            continue
        right, bottom = left + width, top + height
        score = None if math.isnan(confidence) else confidence
        shape = {
            **(labels.get(track) or _said(TrackLabel())),
            "score": score,
            "points": [[left, top], [right, top], [right, bottom], [left, bottom]],
            "group_id": track,
            "difficult": not counted,
            "shape_type": "rectangle",
            "flags": {},
            "kie_linking": [],
        }
        yield json.dumps(shape, ensure_ascii=False)


_MEMBERS = ("shapes", "imageHeight", "imageWidth")
_AREAS = frozenset({"rectangle", "rotation", "quadrilateral", "polygon", "cuboid"})
_CIRCLE = "circle"
_NO_AREAS = frozenset({"point", "line", "linestrip", "points"})
_LARGEST_FILE = 256 << 20
"""A frame with its picture inside; without it a file has some kilobytes."""
_MOST_SHAPES = 100_000
"""In one frame."""


def import_xanylabeling(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a folder; of a file: of the folder it lies in.

    Raises FormatError where files are too large, no such JSON, or none of their shapes has a group.
    """
    is_folder = path.is_dir()
    reading = Reading(path if is_folder else path.parent, report)
    if not is_folder:
        reading.notes.append(
            msg("{name} is one frame; all files of its folder are read", name=path.name)
        )
    files, frames = frame_files(reading)
    folder = _Folder(reading, files)
    for number, each in enumerate(files):
        report(number, len(files))
        folder.take(number, each)
    report(len(files), len(files))
    return folder.imported(frames)


class _Folder:
    """Takes the files of a folder in, one after the other."""

    def __init__(self, reading: Reading, files: list[FrameFile]) -> None:
        self._reading, self._files = reading, files
        self._whole, self._numbers = array("q"), array("d")  # file, shape, group; box, confidence
        self._labels: dict[int, TrackLabel] = {}
        self._size_px: tuple[int, int] | None = None
        self._bytes = self._ungrouped = self._no_areas = 0

    def take(self, number: int, file: FrameFile) -> None:
        """A file."""
        self._check_size(file.path)
        size: dict[str, int | None] = {}
        for member, at, value in elements_of(file.path, _MEMBERS):
            if member != "shapes":
                size[member] = whole_of(value)
            elif at >= 0:
                self._take_shape(number, at, value)
        width, height = size.get("imageWidth"), size.get("imageHeight")
        if self._size_px is None and width and height and width > 0 and height > 0:
            self._size_px = (width, height)

    def imported(self, frames: int | None) -> Imported:
        """The tracks."""
        path, notes = self._reading.path, self._reading.notes
        if self._ungrouped and not self._whole:
            raise FormatError(
                "{path} holds shapes without group_id, no tracks; group them first", path=path
            )
        if self._ungrouped:
            notes.append(
                left_out(
                    self._ungrouped, msg("shape without group id"), msg("shapes without group id")
                )
            )
        if self._no_areas:
            notes.append(left_out(self._no_areas, msg("point or line"), msg("points and lines")))
        file, shape, group = np.asarray(self._whole, np.int64).reshape(-1, 3).T
        numbers = np.asarray(self._numbers).reshape(-1, len(BOX) + 1)
        frame = np.array([each.frame for each in self._files], np.int64)
        track = self._reading.ids_from_zero(group)
        said, first = np.unique(group, return_index=True)
        ids = dict(zip(said.tolist(), track[first].tolist(), strict=True))
        rows: dict[str, NDArray[Any]] = {
            "frame": frame[file],
            "track": track,
            **dict(zip((*BOX, "confidence"), numbers.T, strict=True)),
        }
        return self._reading.imported(
            rows,
            lambda row: msg(
                "{name}, shapes[{shape}]", name=self._files[file[row]].path.name, shape=shape[row]
            ),
            labels={ids[said]: label for said, label in self._labels.items()},
            size_px=self._size_px,
            frames=frames,
        )

    def _check_size(self, path: Path) -> None:
        try:
            size = path.lstat().st_size
        except OSError as error:
            raise FormatError(
                "cannot read {path}: {reason}", path=path, reason=error.strerror
            ) from error
        self._bytes += size
        if size > _LARGEST_FILE:
            raise FormatError(
                "{path} is larger than {size} MB; remove its image",
                path=path,
                size=_LARGEST_FILE >> 20,
            )
        if self._bytes > MOST_BYTES:
            raise FormatError(
                "the {ending} files of {path} hold more than {size} GB; remove the images from "
                "them",
                ending=ENDING,
                path=self._reading.path,
                size=MOST_BYTES >> 30,
            )

    def _take_shape(self, number: int, at: int, shape: Any) -> None:
        place = msg("{name}, shapes[{at}]", name=self._files[number].path.name, at=at)
        if not isinstance(shape, Mapping):
            self._reading.bad(place, msg("is no object"))
            return
        kind, said = shape.get("shape_type") or "polygon", shape.get("group_id")
        if kind in _NO_AREAS:
            self._no_areas += 1
        elif said is None:
            self._ungrouped += 1
        elif reason := self._take_area(number, at, shape, str(kind)):
            self._reading.bad(place, reason)
        else:
            self._reading.good += 1
        if at >= _MOST_SHAPES or self._reading.good > MOST_ROWS:
            raise FormatError(
                "{path} holds more shapes than any footage; split it", path=self._reading.path
            )

    def _take_area(self, number: int, at: int, shape: Mapping[str, Any], kind: str) -> str:
        """Add a row; says why it is invalid where it is."""
        group = whole_of(shape.get("group_id"))
        if group is None or group < 0:
            return msg("its group_id is not a whole number from 0 on")
        box = _box_of(kind, shape.get("points"))
        if isinstance(box, str):
            return box
        score = shape.get("score")
        confidence = np.nan if score is None else number_of(score)
        if confidence is None:
            return msg("its score is not a number")
        self._whole.extend((number, at, group))
        self._numbers.extend((*box, 0.0 if shape.get("difficult") is True else confidence))
        if group not in self._labels:
            label = _label_of(shape)
            if not label.is_empty:
                self._labels[group] = label
        return ""


def _label_of(shape: Mapping[str, Any]) -> TrackLabel:
    name, kind, said = (shape.get(each) for each in ("description", "label", "attributes"))
    attributes = {
        key: text if isinstance(text, str) else str(text)
        for key, text in (said.items() if isinstance(said, dict) else ())
        if isinstance(text, str | int | float | bool)
    }
    kind = kind if isinstance(kind, str) else ""
    return label_of(name if isinstance(name, str) else "", kind, attributes)


def _box_of(kind: str, points: Any) -> tuple[float, float, float, float] | str:
    """Left, top, width and height of the upright box around a shape; why there is none."""
    if not isinstance(points, list) or len(points) < 2:
        return msg("its points are not two or more")
    flat: list[float] = []
    for point in points:
        if not isinstance(point, list) or len(point) != 2:
            return msg("a point is not two numbers")
        numbers = [number_of(value) for value in point]
        if numbers[0] is None or numbers[1] is None:
            return msg("a point is not two numbers")
        flat.extend(value for value in numbers if value is not None)
    if kind == _CIRCLE:
        radius = float(np.hypot(flat[2] - flat[0], flat[3] - flat[1]))
        return flat[0] - radius, flat[1] - radius, 2 * radius, 2 * radius
    if kind not in _AREAS:
        return msg("a shape_type {kind!r} stands where boxes are read", kind=kind[:40])
    left, top = min(flat[::2]), min(flat[1::2])
    return left, top, max(flat[::2]) - left, max(flat[1::2]) - top


X_ANYLABELING = TrackFormat(
    "x-anylabeling",
    "X-AnyLabeling, a folder of JSON",
    (".json",),
    looks_like_frame,
    import_xanylabeling,
    export_xanylabeling,
    recognises_folder=holds_frames,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.CONFIDENCE, Content.CLASSES, Content.NAMES)),
    needs=Content.BOXES,
    label_as_read=label_as_read,
    about="Boxes with tracks as groups, one file per frame in a folder; for X-AnyLabeling.",
)
