"""CVAT for video, written; see `cvat` for the layout."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from tracking.atomic_output import replacing
from tracking.formats.cvat_interpolation import keyframes_of
from tracking.formats.cvat_track import AUTOMATIC, NAME, OWN_KEYS, TRACK_ID, is_occluded
from tracking.formats.label_text import PERSON, attributes_of, key_beside, kind_of, line
from tracking.formats.row_rules import BOX
from tracking.formats.track_writer import Exported
from tracking.progress import Progress
from tracking.tracks import Columns, Source, TrackLabel

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
        attributes.setdefault(kind_of(label), set()).update(_further(label))
    for kind, names in sorted(attributes.items()):
        own = [TRACK_ID, NAME, *sorted(names)]
        yield (
            f"        <label><name>{escape(kind)}</name><type>rectangle</type>"
            f"<attributes>{''.join(map(_attribute_kind, own))}</attributes></label>\n"
        )


def _attribute_kind(name: str) -> str:
    return (
        f"<attribute><name>{escape(name)}</name><mutable>False</mutable>"
        "<input_type>text</input_type><default_value></default_value><values></values></attribute>"
    )


def _track(track: int, rows: Columns, exported: Exported, frames: int) -> Iterator[str]:
    label = exported.label(track)
    source = _MANUAL if np.any(rows["source"] == Source.PERSON) else AUTOMATIC
    yield f'  <track id="{track}" label={quoteattr(kind_of(label))} source="{source}">\n'
    said = {TRACK_ID: str(track), NAME: line(label.name), **_further(label)}
    yield from _boxes(rows, _attributes(said), frames)
    yield "  </track>\n"


def _further(label: TrackLabel) -> dict[str, str]:
    """What the label says beside name and class."""
    return {key_beside(OWN_KEYS, key): text for key, text in attributes_of(label).items()}


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
