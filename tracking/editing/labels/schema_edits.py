"""Planner of the edit that changes which attributes people have."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace

from tracking.editing.core.change import Change, LabelState, State
from tracking.errors import EditError
from tracking.tracks import (
    Labels,
    Schema,
    TrackLabel,
    TrackTable,
    check_schema,
    label_as_stored,
)
from tracking.translation import Message, msg, some_of

_MOST_NAMED = 6


@dataclass(frozen=True, slots=True)
class SchemaChange:
    """What becomes of values that people have already.

    Attributes:
        schema: from now on.
        renamed: new names by the old ones; the values go along.
        choices: by the new name of an attribute, new texts of choices by the old ones.
        dropped: attributes whose values are deleted. Values of others that the schema does not
            have any more stay, as attributes of people's own.
    """

    schema: Schema
    renamed: Mapping[str, str] = field(default_factory=dict)
    choices: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    dropped: Collection[str] = ()


def plan_schema(table: TrackTable, labels: Labels, wanted: SchemaChange) -> Change:
    """Change which attributes people have, and their values with them: one edit.

    Values that the new schema writes otherwise are brought into its form, e.g. "true" to "yes".
    Values that do not suit it stay as they are; `unfit_values` tells them.

    Raises EditError for a schema that is none, where nothing would change, and where somebody has
    an attribute of a new name already.
    """
    check_schema(wanted.schema)
    old: dict[int, TrackLabel] = {}
    new: dict[int, TrackLabel] = {}
    for track, label in labels.tracks.items():
        changed = label_as_stored(wanted.schema, _changed(track, label, wanted))
        if changed != label:
            old[track], new[track] = label, changed
    if wanted.schema == labels.schema and not new:
        raise EditError("nothing to change: the attributes are these already")
    frame = min((table.frame_range(track)[0] for track in new if track in table), default=0)
    before = State(labels=LabelState(old, schema=labels.schema))
    after = State(labels=LabelState(new, schema=wanted.schema))
    return Change("schema", _text(wanted.schema), frame, before, after)


def _changed(track: int, label: TrackLabel, wanted: SchemaChange) -> TrackLabel:
    values: dict[str, str] = {}
    for key, value in label.attributes.items():
        if key in wanted.dropped:
            continue
        name = wanted.renamed.get(key, key)
        if name in values:
            raise EditError(
                "track {track} has an attribute {name} already; choose another name",
                track=track,
                name=name,
            )
        values[name] = wanted.choices.get(name, {}).get(value, value)
    return replace(label, attributes=dict(sorted(values.items())))


def _text(schema: Schema) -> Message:
    if not schema:
        return msg("Remove the schema of attributes")
    names = some_of([one.name for one in schema], _MOST_NAMED)
    return msg("Set the attributes of people: {names}", names=names)
