"""Labels as tables of the session file, and back."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

import h5py
import numpy as np

from tracking.session.hdf5 import is_empty, read_columns
from tracking.session.layout import TABLES, Types
from tracking.tracks import (
    PART_SOURCES,
    CountingLine,
    Labels,
    Occluder,
    PartLabel,
    PartLabels,
    Region,
    ReviewedRange,
    TrackLabel,
    Verdict,
    VerdictKey,
    check_line,
    check_occluder,
    check_part_label,
    check_region,
    check_reviewed,
    check_verdict,
)

Rows = Mapping[str, Sequence[Any]]


def tables_of(labels: Labels) -> Iterator[tuple[str, Types, Rows]]:
    """Every table under `/labels` and `/labels` itself: its path, columns and rows."""
    tracks = labels.tracks
    rows: Mapping[str, Rows] = {
        "labels": {
            "track": list(tracks),
            "name": [label.name for label in tracks.values()],
            "attributes": [json.dumps(dict(label.attributes)) for label in tracks.values()],
            "notes": [label.notes for label in tracks.values()],
        },
        "labels/parts": _part_rows(labels.parts),
        "labels/occluders": _polygons(labels.occluders),
        "labels/reviewed": _fields(labels.reviewed, ("track", "start", "end")),
        "labels/lines": {
            "name": [line.name for line in labels.lines],
            **_ends([line.start for line in labels.lines], "x1", "y1"),
            **_ends([line.end for line in labels.lines], "x2", "y2"),
            **_fields(labels.lines, ("in_picture",)),
        },
        "labels/regions": {
            **_polygons(labels.regions),
            **_fields(labels.regions, ("in_picture",)),
        },
        "labels/verdicts": _verdict_rows(sorted(labels.verdicts.values())),
    }
    for path, columns in rows.items():
        yield path, TABLES[path], columns


def read_labels(file: h5py.File) -> Labels:
    """The labels of a file of any minor version.

    Raises EditError for what is no label, and what conversions raise.
    """
    group = file["labels"]
    return Labels(
        tracks=dict(sorted(_tracks(group))),
        occluders=_sorted(_read_polygons(group, "occluders", Occluder), check_occluder),
        reviewed=_sorted((ReviewedRange(*row) for row in _rows(group, "reviewed")), check_reviewed),
        lines=_sorted(_read_lines(group), check_line),
        regions=_sorted(_read_polygons(group, "regions", Region), check_region),
        verdicts=_read_verdicts(group),
        parts=_read_parts(group),
    )


def _fields(items: Iterable[Any], names: Sequence[str]) -> dict[str, list[Any]]:
    held = list(items)
    return {name: [getattr(item, name) for item in held] for name in names}


def _polygons(items: Sequence[Occluder | Region]) -> Rows:
    return {
        "name": [item.name for item in items],
        "polygon": [json.dumps(item.polygon) for item in items],
    }


def _ends(points: Sequence[tuple[float, float]], x: str, y: str) -> dict[str, list[float]]:
    return {x: [point[0] for point in points], y: [point[1] for point in points]}


def _verdict_rows(verdicts: Sequence[Verdict]) -> Rows:
    rows = _fields(verdicts, ("kind", "frame", "decision"))
    return {**rows, "tracks": [json.dumps(verdict.tracks) for verdict in verdicts]}


def _part_rows(parts: PartLabels) -> Rows:
    """By frame, track and part. Where a person was unsure, on_part is False and sure too."""
    labels = [parts[key] for key in parts]
    boxes = np.array([label.box for label in labels], float).reshape(-1, 4)
    return {
        **_fields(labels, ("frame", "track", "part")),
        "on_part": [label.on_part is True for label in labels],
        "sure": [label.on_part is not None for label in labels],
        **dict(zip(("left", "top", "width", "height"), boxes.T, strict=True)),
        "source": [PART_SOURCES.index(label.source) for label in labels],
        **_fields(labels, ("author", "reason")),
    }


def _rows(group: h5py.Group, name: str) -> Iterator[tuple[Any, ...]]:
    """The rows of a table, less columns that older files lack; of a table they lack, none."""
    if name not in group:
        return iter(())
    held = group[name]
    types = {column: dtype for column, dtype in TABLES[f"labels/{name}"].items() if column in held}
    columns = read_columns(held, types)
    values = (columns[column] for column in types)
    return zip(*(v if isinstance(v, list) else v.tolist() for v in values), strict=True)


def _tracks(group: h5py.Group) -> Iterator[tuple[int, TrackLabel]]:
    columns = read_columns(group, TABLES["labels"])
    names = (columns["name"], columns["attributes"], columns["notes"])
    for track, name, fields, notes in zip(columns["track"].tolist(), *names, strict=True):
        attributes = {str(key): str(value) for key, value in json.loads(fields).items()}
        yield track, TrackLabel(name, attributes, notes)


def _sorted(items: Iterable[Any], check: Callable[[Any], None]) -> tuple[Any, ...]:
    held = sorted(set(items))
    for item in held:
        check(item)
    return tuple(held)


def _read_polygons(
    group: h5py.Group, name: str, made: type[Occluder] | type[Region]
) -> Iterator[Occluder | Region]:
    for title, polygon, *where in _rows(group, name):
        yield made(title, tuple((float(u), float(v)) for u, v in json.loads(polygon)), *where)


def _read_lines(group: h5py.Group) -> Iterator[CountingLine]:
    for name, x1, y1, x2, y2, *where in _rows(group, "lines"):
        yield CountingLine(name, (x1, y1), (x2, y2), *where)


def _read_verdicts(group: h5py.Group) -> dict[VerdictKey, Verdict]:
    verdicts = {}
    for kind, tracks, frame, decision in _rows(group, "verdicts"):
        verdict = Verdict(kind, tuple(int(track) for track in json.loads(tracks)), frame, decision)
        check_verdict(verdict)
        verdicts[verdict.key] = verdict
    return verdicts


def _read_parts(group: h5py.Group) -> PartLabels:
    if is_empty(group, "parts/frame"):  # programs of format 1.0 made the table, and never a label
        return PartLabels()
    labels = []
    for frame, track, part, on_part, sure, *rest in _rows(group, "parts"):
        left, top, width, height, source, *who = rest
        if source >= len(PART_SOURCES):
            raise ValueError(f"a part label's source is {source}")
        said = on_part if sure else None
        box = (left, top, width, height)
        label = PartLabel(frame, track, part, box, said, PART_SOURCES[source], *who)
        check_part_label(label)
        labels.append(label)
    parts = PartLabels(labels)
    if len(parts) < len(labels):
        raise ValueError("a body part is labelled twice in one frame")
    return parts
