"""Label Studio's JSON of video: regions of the `VideoRectangle` tag, a region a track.

The file is an array of tasks, each with `annotations` (and `predictions`), whose `result` holds the
regions: `type` "videorectangle" and in `value` the `labels`, `framesCount` and the `sequence` of
keyframes. The smaller JSON_MIN has an array of records instead, a list of regions under the name of
each tag and no ids of regions. Written is the full one, with an annotation.

- A keyframe has `frame` (from 1), `x, y, width, height` in percent of the picture and `rotation` in
  degrees around its top left corner. Boxes lie straight between keyframes. From a keyframe that is
  not `enabled` on the region is out of view, though the keyframe itself is shown; after the last
  one that is enabled, it stays as it is until `framesCount`.
- A box that is turned becomes the upright box around it.
- The picture's size is `original_width` and `original_height` where a file has them; Label Studio
  leaves them out for videos, and then the recording tells it.
- Regions are called by random texts. Those written here are called `track-7`, which keeps the id on
  its way through Label Studio; others get free ids, by their order. The texts of a region's `meta`
  are the person's name, then attributes as `KEY: VALUE` (`%3A` in KEY is a colon before a blank);
  its label is the class. `origin` is "prediction" where a tracker placed a whole track.
  Who is hidden is not in the format.
- Of several annotations of a task the one marked as ground truth is read, else the newest. Rows of
  predictions are a tracker's.

Label Studio counts frames by the `framerate` of its Video tag (24 unless it is set), whatever the
footage has; what a file says of it is compared with the recording. Put the address that Label
Studio finds the video at into `data.video` of a file that is written.

Sources: Label Studio's VideoRegion.js, VideoRectangleRegion.js (lifespans, shapes between
keyframes) and props.ts; label-studio-sdk's extract_key_frames and converter (JSON_MIN), and its
import of PathTrack.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from tracking.atomic_output import replacing
from tracking.errors import FormatError
from tracking.formats.cvat_interpolation import keyframes_of
from tracking.formats.label_studio_reader import import_label_studio, looks_like_label_studio
from tracking.formats.label_studio_region import (
    COLON_WITHIN,
    FIRST_FRAME,
    PERCENT,
    PREDICTION,
    TRACK_PREFIX,
)
from tracking.formats.label_text import attributes_of, escaped, kind_of, label_as_read, line
from tracking.formats.row_rules import BOX
from tracking.formats.track_format import Content, TrackFormat
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
            "{path}: Label Studio tells boxes in percent, and the image's size is not known",
            path=path,
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


LABEL_STUDIO = TrackFormat(
    "label-studio",
    "Label Studio video, JSON",
    (".json",),
    looks_like_label_studio,
    import_label_studio,
    export_label_studio,
    in_percent=True,
    holds=frozenset((Content.BOXES, Content.SOURCES, Content.CLASSES, Content.NAMES)),
    needs=Content.BOXES,
    label_as_read=label_as_read,
    about="Boxes from keyframe to keyframe, and names; opens in Label Studio as a task.",
)
