"""COCO for video as TAO has it, written; see `coco` for the layout."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, TextIO

import numpy as np

import tracking
from tracking.atomic_output import replacing
from tracking.formats.label_text import PERSON, kind_of
from tracking.formats.number_text import short_decimals
from tracking.formats.row_rules import BOX
from tracking.formats.track_writer import ROWS_AT_ONCE, Exported, nobody_boxed
from tracking.progress import Progress
from tracking.tracks import Columns

_VIDEO = 1
_FIRST_IMAGE = 1


def export_coco(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks that have boxes, in the order of the frames.

    Raises FormatError where no row has a box.
    """
    kinds = _kinds(exported)
    with replacing(path) as stream:
        stream.write("{\n")
        for name, value in _head(exported, kinds).items():
            stream.write(f'"{name}": {json.dumps(value)},\n')
        _write_images(stream, exported)
        tracks = _write_annotations(stream, exported, kinds, report)
        if not tracks:
            raise nobody_boxed(path, "COCO")
        _write_array(stream, "tracks", _tracks(exported, sorted(tracks), kinds))
        stream.write("\n}\n")
    return (path,)


def _kinds(exported: Exported) -> dict[str, int]:
    """The number of each kind of thing; people are 1."""
    others = {kind_of(label) for label in exported.labels.values()} - {PERSON}
    return {name: number for number, name in enumerate((PERSON, *sorted(others)), start=1)}


def _head(exported: Exported, kinds: dict[str, int]) -> dict[str, Any]:
    width, height = exported.size_px or (0, 0)
    video = {
        "id": _VIDEO,
        "name": exported.name,
        "width": width,
        "height": height,
        "neg_category_ids": [],
        "not_exhaustive_category_ids": [],
        "metadata": {} if exported.fps is None else {"fps": exported.fps},
    }
    return {
        "info": {
            "description": exported.name,
            "contributor": f"trackwright {tracking.__version__}",
        },
        "licenses": [],
        "categories": [
            {"id": number, "name": name, "synset": "unknown"} for name, number in kinds.items()
        ],
        "videos": [video],
    }


def _write_images(stream: TextIO, exported: Exported) -> None:
    """One for every frame, whether somebody is there or not; files count from 1, as in TAO."""
    width, height = exported.size_px or (0, 0)
    prefix = json.dumps(exported.name + "/" if exported.name else "")[1:-1]
    rest = f'"video_id": {_VIDEO}, "width": {width}, "height": {height}, "license": 0'
    lines = (
        f'{{"id": {frame + _FIRST_IMAGE}, "frame_index": {frame}, '
        f'"file_name": "{prefix}frame{frame + 1:06d}.jpg", {rest}}}'
        for frame in range(exported.frame_stop)
    )
    _write_array(stream, "images", lines)
    stream.write(",\n")


def _write_annotations(
    stream: TextIO, exported: Exported, kinds: dict[str, int], report: Progress
) -> set[int]:
    """The rows with a box; gives the tracks there are."""
    tracks: set[int] = set()
    stream.write('"annotations": [')
    count = 0
    for piece in exported.pieces(report, ROWS_AT_ONCE):
        boxed = np.isfinite(piece["left"])
        rows = {name: column[boxed] for name, column in piece.items()}
        there = np.unique(rows["track"]).tolist()
        tracks.update(there)
        kind = {track: kinds[kind_of(exported.label(track))] for track in there}
        lines = ",\n".join(_annotations(rows, exported, kind, count + 1))
        stream.write(f"{',' if count and lines else ''}\n{lines}" if lines else "")
        count += int(np.count_nonzero(boxed))
    stream.write("\n],\n")
    return tracks


def _annotations(
    rows: Columns, exported: Exported, kind: dict[int, int], first: int
) -> Iterator[str]:
    whole = [rows[name].tolist() for name in ("frame", "track")]
    box = [rows[name].tolist() for name in BOX]
    judged = [short_decimals(exported.confidence(rows)).tolist(), exported.counted(rows).tolist()]
    for at, (frame, track, left, top, width, height, confidence, counts) in enumerate(
        zip(*whole, *box, *judged, strict=True), start=first
    ):
        score = "" if math.isnan(confidence) else f', "score": {confidence!r}'
        yield (
            f'{{"id": {at}, "image_id": {frame + _FIRST_IMAGE}, "video_id": {_VIDEO}, '
            f'"track_id": {track}, "category_id": {kind[track]}, '
            f'"bbox": [{left!r}, {top!r}, {width!r}, {height!r}], "area": {width * height!r}, '
            f'"iscrowd": {int(not counts)}{score}, "attributes": {{"track_id": {track}}}}}'
        )


def _tracks(exported: Exported, tracks: list[int], kinds: dict[str, int]) -> Iterator[str]:
    for track in tracks:
        label = exported.label(track)
        said: dict[str, Any] = {
            "id": track,
            "category_id": kinds[kind_of(label)],
            "video_id": _VIDEO,
        }
        said |= {"name": label.name} if label.name else {}
        others = {key: value for key, value in label.attributes.items() if key != "class"}
        said |= {"attributes": others} if others else {}
        yield json.dumps(said)


def _write_array(stream: TextIO, name: str, lines: Iterator[str]) -> None:
    stream.write(f'"{name}": [')
    for at, line in enumerate(lines):
        stream.write(f"{',' if at else ''}\n{line}")
    stream.write("\n]")
