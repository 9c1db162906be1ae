"""The attributes of an imported file, held against the schema of the session they go into."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from tracking.tracks import (
    Attribute,
    AttributeType,
    Schema,
    TrackLabel,
    labels_as_stored,
    missing_values,
    unfit_values,
)
from tracking.translation import Message, msg, some_of

_MOST_NAMED = 6


def fit_labels(
    labels: Mapping[int, TrackLabel], tracks: Sequence[int], said: Schema, own: Schema
) -> tuple[dict[int, TrackLabel], list[Message]]:
    """Imported labels as the schema stores them, and what the user should know, a line each.

    Args:
        labels: of the file. tracks: all that are imported.
        said: the schema of the file. own: that of the session or project; empty: the file's counts.
    """
    schema = own or said
    kept = labels_as_stored(schema, labels)
    notes = list(_differences(said, own)) if own else list(_proposal(said))
    return kept, [*notes, *unfit_values(schema, kept), *missing_values(schema, kept, tracks)]


def _proposal(said: Schema) -> Iterator[Message]:
    if said:
        names = some_of([one.name for one in said], _MOST_NAMED)
        yield msg(
            "the file says which attributes people have, and the session does now: {names}",
            names=names,
        )


def _differences(said: Schema, own: Schema) -> Iterator[Message]:
    """What the file's schema says otherwise; free text is no schema of an attribute."""
    known = {one.name: one for one in own}
    unknown = [one.name for one in said if one.name not in known and one != Attribute(one.name)]
    if unknown:
        yield msg(
            "the session's attributes have no {names}: imported as attributes of people's own",
            names=some_of(unknown, _MOST_NAMED),
        )
    for one in said:
        if one.name in known and _differs(one, known[one.name]):
            yield msg(
                "attribute {name}: the file says {said}, the session {own}, which stays",
                name=one.name,
                said=attribute_text(one),
                own=attribute_text(known[one.name]),
            )


def _differs(said: Attribute, own: Attribute) -> bool:
    """Whether two say otherwise; only one of them may know what is required."""
    return said != replace(own, required=said.required)


def attribute_text(attribute: Attribute) -> Message:
    """An attribute in words, e.g. "choice of guest, staff"."""
    if attribute.type is AttributeType.CHOICE:
        what = msg("choice of {choices}", choices=some_of(attribute.choices, _MOST_NAMED))
    elif attribute.type is AttributeType.NUMBER:
        what = _number_text(attribute)
    else:
        yes_no = attribute.type is AttributeType.YES_NO
        what = msg("yes or no") if yes_no else msg("text")
    if not attribute.default:
        return what
    return msg("{what}, default {default}", what=what, default=attribute.default[:200])


def _number_text(attribute: Attribute) -> Message:
    least, most, step = attribute.least, attribute.most, attribute.step
    if least is None and most is None and step is None:
        return msg("number")
    return msg(
        "number from {least} to {most} in steps of {step}",
        least="..." if least is None else f"{least:g}",
        most="..." if most is None else f"{most:g}",
        step="..." if step is None else f"{step:g}",
    )
