"""X-AnyLabeling's folders, written; see `xanylabeling` for the layout."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from tracking.atomic_output import replacing_folder
from tracking.errors import FormatError
from tracking.formats.label_text import attributes_of, kind_of, line
from tracking.formats.number_text import short_decimals
from tracking.formats.row_rules import BOX
from tracking.formats.track_writer import Exported, nobody_boxed
from tracking.formats.xanylabeling_folder import ENDING
from tracking.progress import Progress
from tracking.tracks import Columns, TrackLabel

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
        raise FormatError(f"{path}: X-AnyLabeling needs the picture's size, which is not known")
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
