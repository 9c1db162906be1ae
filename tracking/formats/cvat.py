"""CVAT for video 1.1: XML, a `track` a person, a `box` a frame.

Frames count from 0 as the footage does. `xtl, ytl, xbr, ybr` are the edges of a box in pixels from
the picture's top left corner: a box over the first ten columns has `xtl` 0 and `xbr` 10, as left 0
and width 10 here, so nothing is shifted. A box with `outside` 1 says that the track is out of view
from this frame to its next box: a gap.

Written, every box stands in the file. `keyframe` is 0 where CVAT's own interpolation gives the same
box, which is where this program interpolated, and 1 elsewhere: CVAT drops the others on reading.
Read, keyframes are a person's rows (a tracker's in tracks whose source is `auto`), others are
interpolated. A track that is told by keyframes alone is filled in as CVAT does: straight from one
to the next, and held from the last one to the end of the task where no `outside` ends it.

CVAT numbers tracks anew; so each has an attribute `track_id`, which is taken where a file has it.
The attribute `name` is the person's, others are attributes of the track: one that is called `name`
or `track_id` here is written with a `_` behind. The schema of attributes stands in the meta, see
`cvat_schema`. A `label` other than person is its class.
`occluded` is visibility 0, as is predicted, and below a half. The format has no places on the
floor. Source: CVAT's XML annotation format 1.1 and what CVAT 2 writes.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from tracking.atomic_output import replacing
from tracking.errors import FormatError
from tracking.formats.cvat_interpolation import keyframes_of
from tracking.formats.cvat_meta import Meta
from tracking.formats.cvat_schema import NAME, OWN_KEYS, TRACK_ID, label_in_cvat, value_in_cvat
from tracking.formats.cvat_track import (
    AUTOMATIC,
    BOX_NUMBERS,
    CvatTrack,
    FileTracks,
    is_occluded,
)
from tracking.formats.label_text import (
    PERSON,
    attributes_of,
    key_beside,
    kind_of,
    label_as_read,
    line,
)
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.row_rules import BOX, MAX_FRAME
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import Exported
from tracking.formats.xml_stream import ZIP, parse
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns, Schema, Source, TrackLabel, attribute_named
from tracking.translation import joined, msg

_MANUAL = "manual"


def export_cvat(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks that have boxes, one after the other.

    Raises FormatError where no row has a box.
    """
    frames = exported.frame_stop
    with replacing(path) as stream:
        stream.write(_head(exported, frames))
        for track, rows in exported.tracks_with_boxes(path, "CVAT", report):
            stream.writelines(_track(track, rows, exported, frames))
        stream.write("</annotations>\n")
    return (path,)


def _head(exported: Exported, frames: int) -> str:
    width, height = exported.size_px or (0, 0)
    size = f"<original_size><width>{width}</width><height>{height}</height></original_size>"
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n<annotations>\n'
        "  <version>1.1</version>\n  <meta>\n    <task>\n"
        f"      <id>1</id>\n      <name>{escape(line(exported.name))}</name>\n"
        f"      <size>{frames}</size>\n      <mode>interpolation</mode>\n"
        "      <overlap>0</overlap>\n      <bugtracker></bugtracker>\n"
        f"      <start_frame>0</start_frame>\n      <stop_frame>{frames - 1}</stop_frame>\n"
        "      <frame_filter></frame_filter>\n"
        f"      <labels>\n{''.join(_labels(exported))}      </labels>\n"
        "      <segments><segment><id>1</id><start>0</start>"
        f"<stop>{frames - 1}</stop><url></url></segment></segments>\n"
        f"      {size if exported.size_px else ''}\n    </task>\n  </meta>\n"
    )


def _labels(exported: Exported) -> Iterator[str]:
    """The kinds of things, each with the attributes its tracks have."""
    attributes: dict[str, set[str]] = {PERSON: set()}
    for label in exported.labels.values():
        attributes.setdefault(kind_of(label), set()).update(attributes_of(label))
    for kind, names in sorted(attributes.items()):
        further = sorted(names - {one.name for one in exported.schema})
        own = "".join(map(_attribute_kind, label_in_cvat(exported.schema, further)))
        yield (
            f"        <label><name>{escape(kind)}</name><type>rectangle</type>"
            f"<attributes>{own}</attributes></label>\n"
        )


def _attribute_kind(said: Mapping[str, Any]) -> str:
    values = escape("\n".join(said["values"]))
    return (
        f"<attribute><name>{escape(said['name'])}</name><mutable>False</mutable>"
        f"<input_type>{said['input_type']}</input_type>"
        f"<default_value>{escape(said['default_value'])}</default_value>"
        f"<values>{values}</values></attribute>"
    )


def _track(track: int, rows: Columns, exported: Exported, frames: int) -> Iterator[str]:
    label = exported.label(track)
    source = _MANUAL if np.any(rows["source"] == Source.PERSON) else AUTOMATIC
    yield f'  <track id="{track}" label={quoteattr(kind_of(label))} source="{source}">\n'
    said = {TRACK_ID: str(track), NAME: line(label.name), **_further(label, exported.schema)}
    yield from _boxes(rows, _attributes(said), frames)
    yield "  </track>\n"


def _further(label: TrackLabel, schema: Schema = ()) -> dict[str, str]:
    """What the label says beside name and class, as CVAT has it."""
    return {
        key_beside(OWN_KEYS, key): value_in_cvat(attribute_named(schema, key), text)
        for key, text in attributes_of(label).items()
    }


def _attributes(said: Mapping[str, str]) -> str:
    """The attributes of a track, which CVAT repeats in every box of it."""
    return "".join(
        f"<attribute name={quoteattr(name)}>{escape(text)}</attribute>"
        for name, text in said.items()
        if name and text
    )


def _boxes(rows: Columns, attributes: str, frames: int) -> Iterator[str]:
    """A track's boxes; where it goes out of view before the footage ends, one that says so."""
    frame = rows["frame"]
    boxes = np.column_stack([rows[name] for name in BOX])
    hidden = is_occluded(rows["visibility"], rows["predicted"])
    key = keyframes_of(frame, boxes, rows["source"], hidden)
    boxes[:, 2:] += boxes[:, :2]
    ends = np.append(np.diff(frame) > 1, frame[-1] + 1 < frames)
    for at, sides, is_key, ended, is_hidden in zip(
        frame.tolist(), boxes.tolist(), key.tolist(), ends.tolist(), hidden.tolist(), strict=True
    ):
        left, top, right, bottom = sides
        where = (
            f'occluded="{is_hidden:d}" xtl="{left!r}" ytl="{top!r}" xbr="{right!r}" '
            f'ybr="{bottom!r}" z_order="0">{attributes}</box>\n'
        )
        yield f'    <box frame="{at}" keyframe="{is_key:d}" outside="0" {where}'
        if ended:
            yield f'    <box frame="{at + 1}" keyframe="1" outside="1" {where}'


MEMBER = "annotations.xml"
_START = re.compile(
    rb"(\xef\xbb\xbf)?\s*(<\?xml[^>]*\?>\s*)?(<!--.*?-->\s*)*<annotations[\s>]", re.S
)
_MOST_DIGITS = 18
_MOST_BESIDE = 200_000
"""Elements that are no part of a track, such as labels of a task: many times what any has."""
_OTHER_SHAPES = frozenset(
    {"polygon", "polyline", "points", "cuboid", "ellipse", "mask", "skeleton"}
)
_OF_TRACKS = _OTHER_SHAPES | {"track", "box", "attribute"}


def looks_like_cvat(_path: Path, head: bytes) -> bool:
    """Whether a file begins as CVAT's XML, or is an archive that does with what CVAT exports."""
    return _START.match(head) is not None or (head.startswith(ZIP) and MEMBER.encode() in head)


def import_cvat(path: Path, filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a task; see `cvat` for what becomes of keyframes, ids and attributes.

    Raises FormatError where the file holds pictures instead of a video, several tasks, no such
    XML, or keyframes that stand for more rows than any footage has.
    """
    reading = Reading(path, report)
    file = _File(reading, filmed.frames)
    parse(path, file, MEMBER, report)
    file.check()
    return file.tracks.imported()


class _File:
    """Takes elements as they come; keeps rows alone."""

    def __init__(self, reading: Reading, frames: int | None) -> None:
        self._reading = reading
        self.meta = Meta()
        self.tracks = FileTracks(reading, self.meta, frames)
        self._open: list[str] = []
        self._track: CvatTrack | None = None
        self._attribute = ""
        self._images = self._beside = 0

    def start(self, name: str, attributes: Mapping[str, str], line: int) -> None:
        """See `xml_stream.Elements`."""
        if not self._open and name != "annotations":
            raise FormatError(
                "{path} is XML, but none of CVAT's: export it again", path=self._reading.path
            )
        inside = self._open[-1] if self._open else ""
        self._open.append(name)
        if name not in _OF_TRACKS or (self._track is None and name != "track"):
            self._count_beside()
        if name == "track" and inside == "annotations":
            self._track = CvatTrack(attributes, line)
        elif name == "image":
            self._images += 1
        elif self._track is not None and inside == "track":
            self._shape(name, attributes, line)
        elif name == "attribute":
            self._attribute = attributes.get("name", "")

    def end(self, name: str, text: str) -> None:
        """See `xml_stream.Elements`."""
        self._open.pop()
        if self._track is None:
            self.meta.end(self._open, name, text)
        elif name == "attribute":
            self._track.say(self._attribute, text.strip())
        elif name == "track":
            self.tracks.add(self._track)
            self._track = None

    def check(self) -> None:
        """Raise FormatError where the file is not of one video."""
        path = self._reading.path
        if self.meta.tasks > 1:
            raise FormatError(
                "{path} holds {tasks} tasks; export one of them alone",
                path=path,
                tasks=self.meta.tasks,
            )
        if self._images and not self.tracks:
            raise FormatError(
                "{path} is CVAT for images; export the task as CVAT for video", path=path
            )

    def _count_beside(self) -> None:
        """Raise FormatError where far more is said than in any of CVAT's files of a video."""
        self._beside += 1
        if self._beside > _MOST_BESIDE:
            self.check()
            raise FormatError(
                "{path} holds hardly more than elements without boxes", path=self._reading.path
            )

    def _shape(self, name: str, attributes: Mapping[str, str], line: int) -> None:
        assert self._track is not None
        if name == "box":
            reason = _row(self._track, attributes, line)
        elif name in _OTHER_SHAPES:
            reason = msg("a {name} stands where boxes are read", name=name)
        else:
            return
        if reason:
            self._reading.bad(msg("line {line}", line=line), reason)
        else:
            self._reading.good += 1


def _row(track: CvatTrack, said: Mapping[str, str], line: int) -> str:
    """Add a box to its track; says why it is invalid where it is."""
    frame = said.get("frame", "")
    if not (frame.isascii() and frame.isdigit() and len(frame) < _MOST_DIGITS):
        return msg("the frame {frame!r} is not a whole number from 0 on", frame=frame[:20])
    if int(frame) >= MAX_FRAME:
        return msg("the frame number is not one of {max_frame} frames", max_frame=MAX_FRAME)
    try:
        sides = (
            float(said["xtl"]),
            float(said["ytl"]),
            float(said["xbr"]),
            float(said["ybr"]),
        )
        turned = float(said["rotation"]) % 360 if "rotation" in said else 0.0
    except (KeyError, ValueError):
        return msg("{box_numbers} are not four numbers", box_numbers=joined(", ", BOX_NUMBERS))
    if not math.isfinite(sum(sides)):
        return msg("a value is not a finite number")
    if turned:
        return msg(
            "the box is turned by {turned:g} degrees; boxes stand upright here", turned=turned
        )
    outside, occluded = said.get("outside") == "1", said.get("occluded") == "1"
    track.rows((int(frame), line, outside, occluded, said.get("keyframe", "1") == "1"), sides)
    return ""


CVAT = TrackFormat(
    "cvat",
    "CVAT for video 1.1, XML",
    (".xml", ".zip"),
    looks_like_cvat,
    import_cvat,
    export_cvat,
    holds=frozenset(
        (
            Content.BOXES,
            Content.VISIBILITY,
            Content.SOURCES,
            Content.CLASSES,
            Content.NAMES,
            Content.SCHEMA,
        )
    ),
    needs=Content.BOXES,
    label_as_read=label_as_read,
    about="Boxes with their keyframes, names and attributes; opens in CVAT and similar programs.",
)
