"""Labels as tables of the session file, and back."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import h5py

from tracking.session.hdf5 import is_empty, read_rows
from tracking.session.layout import TABLES
from tracking.tracks import (
    LABEL_CHECKS,
    PART_SOURCES,
    Attribute,
    AttributeType,
    CountingLine,
    Labels,
    Occluder,
    PartLabel,
    PartLabels,
    Region,
    ReviewedRange,
    Schema,
    TrackLabel,
    Verdict,
    VerdictKey,
    check_part_label,
    check_schema,
    check_verdict,
)

Row = dict[str, Any]
_BOX = ("left", "top", "width", "height")
_OF_NUMBERS = ("least", "most", "step")


def tables_of(labels: Labels) -> dict[str, dict[str, list[Any]]]:
    """Every table under `/labels` and itself: its columns by path, in the file's order."""
    rows: Mapping[str, Iterable[Row]] = {
        "labels": (
            {"track": track, **_fields(label), "attributes": json.dumps(dict(label.attributes))}
            for track, label in labels.tracks.items()
        ),
        "labels/occluders": map(_polygon_row, labels.occluders),
        "labels/reviewed": map(_fields, labels.reviewed),
        "labels/lines": (
            _fields(line)
            | dict(zip(("x1", "y1", "x2", "y2"), (*line.start, *line.end), strict=True))
            for line in labels.lines
        ),
        "labels/regions": map(_polygon_row, labels.regions),
        "labels/verdicts": (
            {**_fields(verdict), "tracks": json.dumps(verdict.tracks)}
            for verdict in sorted(labels.verdicts.values())
        ),
        "labels/schema": map(_attribute_row, labels.schema),
    }
    columns = {path: _columns(path, list(given)) for path, given in rows.items()}
    columns["labels/parts"] = _part_columns(labels.parts)
    return {path: columns[path] for path in TABLES if path in columns}


def read_labels(file: h5py.File) -> Labels:
    """The labels of a file of any minor version.

    Raises EditError for what is no label, and what conversions raise.
    """
    group = file["labels"]
    reviewed = (ReviewedRange(**row) for row in _rows(group, "reviewed"))
    return Labels(
        tracks=dict(sorted(_tracks(group))),
        occluders=_sorted("occluders", _read_polygons(group, "occluders", Occluder)),
        reviewed=_sorted("reviewed", reviewed),
        lines=_sorted("lines", _read_lines(group)),
        regions=_sorted("regions", _read_polygons(group, "regions", Region)),
        verdicts=_read_verdicts(group),
        parts=_read_parts(group),
        schema=_read_schema(group),
    )


def _columns(path: str, rows: Sequence[Row]) -> dict[str, list[Any]]:
    return {name: [row[name] for row in rows] for name in TABLES[path].columns}


def _fields(item: Any) -> Row:
    return {field.name: getattr(item, field.name) for field in dataclasses.fields(item)}


def _polygon_row(item: Occluder | Region) -> Row:
    return {**_fields(item), "polygon": json.dumps(item.polygon)}


def _attribute_row(attribute: Attribute) -> Row:
    numbers = {name: getattr(attribute, name) for name in _OF_NUMBERS}
    absent = {name: math.nan for name, number in numbers.items() if number is None}
    choices = json.dumps(attribute.choices)
    return {**_fields(attribute), "type": attribute.type.value, "choices": choices, **absent}


def _part_columns(parts: PartLabels) -> dict[str, list[Any]]:
    """Column by column, as there may be many. Unsure is on_part False, and sure too."""
    labels = list(parts.values())
    sides = zip(*(label.box for label in labels), strict=True) if labels else ([],) * len(_BOX)
    said = ("frame", "track", "part", "author", "reason")
    return {
        **{name: [getattr(label, name) for label in labels] for name in said},
        **{name: list(side) for name, side in zip(_BOX, sides, strict=True)},
        "on_part": [label.on_part is True for label in labels],
        "sure": [label.on_part is not None for label in labels],
        "source": [PART_SOURCES.index(label.source) for label in labels],
    }


def _rows(group: h5py.Group, name: str) -> Iterator[Row]:
    """The rows of a table, less columns that older files lack; of a table they lack, none."""
    return read_rows(group[name]) if name in group else iter(())


def _tracks(group: h5py.Group) -> Iterator[tuple[int, TrackLabel]]:
    for row in read_rows(group):
        attributes = {str(key): str(value) for key, value in json.loads(row["attributes"]).items()}
        yield row["track"], TrackLabel(row["name"], attributes, row["notes"])


def _sorted(kind: str, items: Iterable[Any]) -> tuple[Any, ...]:
    held = sorted(set(items))
    for item in held:
        LABEL_CHECKS[kind](item)
    return tuple(held)


def _read_polygons(
    group: h5py.Group, name: str, made: type[Occluder] | type[Region]
) -> Iterator[Occluder | Region]:
    for row in _rows(group, name):
        polygon = tuple((float(u), float(v)) for u, v in json.loads(row["polygon"]))
        yield made(**{**row, "polygon": polygon})


def _read_lines(group: h5py.Group) -> Iterator[CountingLine]:
    for row in _rows(group, "lines"):
        x1, y1, x2, y2 = (row.pop(name) for name in ("x1", "y1", "x2", "y2"))
        yield CountingLine(start=(x1, y1), end=(x2, y2), **row)


def _read_verdicts(group: h5py.Group) -> dict[VerdictKey, Verdict]:
    verdicts = {}
    for row in _rows(group, "verdicts"):
        tracks = tuple(int(track) for track in json.loads(row["tracks"]))
        verdict = Verdict(**{**row, "tracks": tracks})
        check_verdict(verdict)
        verdicts[verdict.key] = verdict
    return verdicts


def _read_schema(group: h5py.Group) -> Schema:
    schema = tuple(
        Attribute(
            **{
                **row,
                "type": AttributeType(row["type"]),
                "choices": tuple(str(choice) for choice in json.loads(row["choices"])),
                **{name: None for name in _OF_NUMBERS if math.isnan(row[name])},
            }
        )
        for row in _rows(group, "schema")
    )
    check_schema(schema)
    return schema


def _read_parts(group: h5py.Group) -> PartLabels:
    if is_empty(group, "parts/frame"):  # programs of format 1.0 made the table, and never a label
        return PartLabels()
    labels = []
    for row in _rows(group, "parts"):
        source = row["source"]
        if source >= len(PART_SOURCES):
            raise ValueError(f"a part label's source is {source}")
        row["box"] = tuple(row.pop(name) for name in _BOX)
        row["on_part"] = row["on_part"] if row.pop("sure") else None
        label = PartLabel(**{**row, "source": PART_SOURCES[source]})
        check_part_label(label)
        labels.append(label)
    parts = PartLabels(labels)
    if len(parts) < len(labels):
        raise ValueError("a body part is labelled twice in one frame")
    return parts
