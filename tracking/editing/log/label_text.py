"""The labels of a change as plain values for JSON, and back."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tracking.editing.core.label_state import LabelState
from tracking.tracks import (
    LABEL_CHECKS,
    CountingLine,
    Occluder,
    PartLabel,
    Region,
    ReviewedRange,
    TrackLabel,
    Verdict,
    schema_as_values,
    schema_from_values,
)
from tracking.translation import msg


def labels_as_json(labels: LabelState) -> dict[str, Any]:
    """What stands on this side; kinds of labels of which there are none are left out."""
    parts: dict[str, Any] = {
        "tracks": {
            str(track): {
                "name": label.name,
                "attributes": dict(label.attributes),
                "notes": label.notes,
            }
            for track, label in labels.tracks.items()
        },
        "occluders": [[item.name, item.polygon] for item in labels.occluders],
        "reviewed": [[seen.track, seen.start, seen.end] for seen in labels.reviewed],
        "lines": _lines_as_json(labels, in_picture=False),
        "picture_lines": _lines_as_json(labels, in_picture=True),
        "regions": _regions_as_json(labels, in_picture=False),
        "picture_regions": _regions_as_json(labels, in_picture=True),
        "verdicts": [
            [said.kind, said.tracks, said.frame, said.decision] for said in labels.verdicts
        ],
        "parts": [_part_as_json(label) for label in labels.parts],
    }
    said = {name: part for name, part in parts.items() if part}
    if labels.schema is not None:  # an empty one is one, too
        said["schema"] = schema_as_values(labels.schema)
    return said


def labels_from_json(parts: Mapping[str, Any]) -> LabelState:
    """The labels of one side. Raises what conversions raise, and EditError for what is no label."""
    labels = LabelState(
        tracks={
            int(track): _track_from_json(label) for track, label in parts.get("tracks", {}).items()
        },
        occluders=tuple(
            Occluder(str(name), _corners(polygon)) for name, polygon in parts.get("occluders", ())
        ),
        reviewed=tuple(
            ReviewedRange(int(track), int(start), int(end))
            for track, start, end in parts.get("reviewed", ())
        ),
        lines=tuple(sorted((*_lines(parts, "lines"), *_lines(parts, "picture_lines")))),
        regions=tuple(sorted((*_regions(parts, "regions"), *_regions(parts, "picture_regions")))),
        verdicts=tuple(
            Verdict(str(kind), tuple(int(track) for track in tracks), int(frame), str(decision))
            for kind, tracks, frame, decision in parts.get("verdicts", ())
        ),
        parts=tuple(_part_from_json(values) for values in parts.get("parts", ())),
        schema=schema_from_values(parts["schema"]) if "schema" in parts else None,
    )
    for kind, check in LABEL_CHECKS.items():
        for label in getattr(labels, kind):
            check(label)
    return labels


def _track_from_json(label: Mapping[str, Any]) -> TrackLabel:
    attributes = {str(key): str(value) for key, value in label["attributes"].items()}
    return TrackLabel(str(label["name"]), attributes, str(label["notes"]))


def _lines_as_json(labels: LabelState, *, in_picture: bool) -> list[Any]:
    """Lines on the floor or in the picture; apart, so that older programs take none for another."""
    chosen = (line for line in labels.lines if line.in_picture is in_picture)
    return [[line.name, line.start, line.end] for line in chosen]


def _regions_as_json(labels: LabelState, *, in_picture: bool) -> list[Any]:
    chosen = (region for region in labels.regions if region.in_picture is in_picture)
    return [[region.name, region.polygon] for region in chosen]


def _lines(parts: Mapping[str, Any], key: str) -> Iterator[CountingLine]:
    for name, *ends in parts.get(key, ()):
        start, end = _corners(ends)
        yield CountingLine(str(name), start, end, key.startswith("picture"))


def _regions(parts: Mapping[str, Any], key: str) -> Iterator[Region]:
    for name, polygon in parts.get(key, ()):
        yield Region(str(name), _corners(polygon), key.startswith("picture"))


def _part_as_json(label: PartLabel) -> list[Any]:
    said = [label.frame, label.track, label.part, *label.box, label.on_part, label.source]
    return [*said, label.author, label.reason] if label.author or label.reason else said


def _part_from_json(values: Sequence[Any]) -> PartLabel:
    """Logs of format 1.1 end with the source."""
    frame, track, part, left, top, width, height, on_part, source, *who = values
    author, reason = who or ("", "")
    box = (float(left), float(top), float(width), float(height))
    if not (on_part is None or isinstance(on_part, bool)):
        raise ValueError(msg("on part is {on_part!r}; it is true, false or null", on_part=on_part))
    said = (int(frame), int(track), int(part), box, on_part)
    return PartLabel(*said, str(source), str(author), str(reason))


def _corners(polygon: Sequence[Sequence[Any]]) -> tuple[tuple[float, float], ...]:
    return tuple((float(u), float(v)) for u, v in polygon)
