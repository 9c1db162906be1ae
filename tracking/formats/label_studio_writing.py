"""Label Studio's JSON of video, written; see `label_studio` for the layout."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from tracking.atomic_output import replacing
from tracking.errors import FormatError
from tracking.formats.cvat_interpolation import keyframes_of
from tracking.formats.label_studio_region import (
    COLON_WITHIN,
    FIRST_FRAME,
    PERCENT,
    PREDICTION,
    TRACK_PREFIX,
)
from tracking.formats.label_text import attributes_of, escaped, kind_of, line
from tracking.formats.row_rules import BOX
from tracking.formats.track_writer import Exported
from tracking.progress import Progress
from tracking.tracks import Columns, Source

_BOX_TAG, _VIDEO_TAG = "box", "video"
"""The names of the tags in Label Studio's own template of video tracking."""


def export_label_studio(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write one task with an annotation, a region a track, from keyframe to keyframe.

    Raises FormatError where no row has a box, or the size of the picture is not known.
    """
    if exported.size_px is None:
        raise FormatError(
            f"{path}: Label Studio tells boxes in percent, and the picture's size is not known"
        )
    frames = exported.frame_stop
    task = {_VIDEO_TAG: line(exported.name)}
    with replacing(path) as stream:
        stream.write(f'[\n{{"data": {json.dumps(task)}, "annotations": [{{"result": [')
        between = "\n"
        for track, rows in exported.tracks_with_boxes(path, "Label Studio", report):
            stream.write(between)
            stream.writelines(_region(track, rows, exported, frames))
            between = ",\n"
        stream.write("\n]}]}\n]\n")
    return (path,)


def _region(track: int, rows: Columns, exported: Exported, frames: int) -> Iterator[str]:
    label = exported.label(track)
    width, height = exported.size_px or (0, 0)
    said: dict[str, Any] = {
        "id": f"{TRACK_PREFIX}{track}",
        "type": "videorectangle",
        "from_name": _BOX_TAG,
        "to_name": _VIDEO_TAG,
        "origin": "manual" if np.any(rows["source"] == Source.PERSON) else PREDICTION,
        "original_width": width,
        "original_height": height,
    }
    about = [line(label.name)]
    about += [f"{escaped(key, COLON_WITHIN)}: {text}" for key, text in attributes_of(label).items()]
    said |= {"meta": {"text": about}} if any(about) else {}
    value: dict[str, Any] = {"labels": [kind_of(label)], "framesCount": frames}
    value |= {} if exported.fps is None else {"duration": frames / exported.fps}
    yield f'{json.dumps(said)[:-1]}, "value": {json.dumps(value)[:-1]}, "sequence": ['
    yield ",\n".join(_keyframes(rows, exported))
    yield "]}}"


def _keyframes(rows: Columns, exported: Exported) -> Iterator[str]:
    """The keyframes; the last one before a gap, and of all, is not enabled: it ends the view."""
    boxes = np.column_stack([rows[name] for name in BOX]).astype(np.float64)
    frame = rows["frame"].astype(np.int64)
    nobody_hidden = np.zeros(len(frame), bool)
    keys = np.flatnonzero(keyframes_of(frame, boxes, rows["source"], nobody_hidden))
    enabled = np.append(np.diff(frame) == 1, False)[keys]
    percent = boxes[keys] * PERCENT / np.tile(exported.size_px or (1, 1), 2)
    for at, sides, goes_on in zip(
        (frame[keys] + FIRST_FRAME).tolist(), percent.tolist(), enabled.tolist(), strict=True
    ):
        left, top, width, height = sides
        time = "" if exported.fps is None else f'"time": {at / exported.fps!r}, '
        yield (
            f'{{"frame": {at}, {time}"enabled": {json.dumps(goes_on)}, "rotation": 0, '
            f'"x": {left!r}, "y": {top!r}, "width": {width!r}, "height": {height!r}}}'
        )
