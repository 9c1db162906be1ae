"""What people said of attributes, held against a schema."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from tracking.tracks.attribute_schema import Attribute, Schema, as_stored, why_unfit
from tracking.tracks.labels import Labels, TrackLabel
from tracking.tracks.limits import LONGEST_NAME
from tracking.translation import Message, msg, some_of

_MOST_NAMED = 6


def unfit_values(schema: Schema, labels: Mapping[int, TrackLabel]) -> tuple[Message, ...]:
    """What of labels does not suit a schema, a line for each attribute that has such values.

    Values that nobody gave are not among them, see `missing_values`.
    """
    lines = []
    for attribute in schema:
        found = [
            (track, value, why)
            for track, label in sorted(labels.items())
            if (value := label.attributes.get(attribute.name)) is not None
            and (why := why_unfit(attribute, value)) is not None
        ]
        if found:
            lines.append(_unfit_line(attribute, found))
    return tuple(lines)


def _unfit_line(attribute: Attribute, found: Sequence[tuple[int, str, Message]]) -> Message:
    _, value, why = found[0]
    return msg(
        "attribute {name} of {tracks} does not suit the schema ({value!r}): {why}",
        name=attribute.name,
        tracks=_tracks(track for track, *_ in found),
        value=value[:LONGEST_NAME],
        why=why,
    )


def missing_values(
    schema: Schema, labels: Mapping[int, TrackLabel], tracks: Sequence[int]
) -> tuple[Message, ...]:
    """Which people lack a required attribute, a line for each; a default is no value."""
    lines = []
    for attribute in schema:
        lacking = [
            track
            for track in tracks
            if attribute.required
            and attribute.name not in labels.get(track, TrackLabel()).attributes
        ]
        if lacking:
            line = msg(
                "attribute {name} is required and has no value: {tracks}",
                name=attribute.name,
                tracks=_tracks(lacking),
            )
            lines.append(line)
    return tuple(lines)


def _tracks(tracks: Iterable[int]) -> Message:
    return msg("track {tracks}", tracks=some_of(tuple(map(str, tracks)), _MOST_NAMED))


def labels_as_stored(schema: Schema, labels: Mapping[int, TrackLabel]) -> dict[int, TrackLabel]:
    """The labels with the values of attributes in the schema as they are stored."""
    return {track: label_as_stored(schema, label) for track, label in labels.items()}


def label_as_stored(schema: Schema, label: TrackLabel) -> TrackLabel:
    """The same of one track."""
    known = {one.name: one for one in schema}
    values = {
        key: as_stored(known[key], value) if key in known else value
        for key, value in label.attributes.items()
    }
    return TrackLabel(label.name, values, label.notes)


def used_values(labels: Labels, name: str) -> tuple[str, ...]:
    """The values that people have of an attribute, the most frequent first."""
    counts: dict[str, int] = {}
    for label in labels.tracks.values():
        if value := label.attributes.get(name, ""):
            counts[value] = counts.get(value, 0) + 1
    return tuple(sorted(counts, key=lambda value: (-counts[value], value)))
