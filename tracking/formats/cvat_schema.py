"""The schema of attributes as CVAT has it: in the meta of its XML and in its label constructor.

CVAT's `select` and `radio` are choices here, written as `select`; `checkbox` is yes or no, where
CVAT says `true` and `false`. The values of a `number` are its least, most and step. CVAT knows no
required attributes, and keeps attributes by label, here all tracks have the same. An attribute that
is `mutable` there may change from frame to frame; here it is of the whole track.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from tracking.errors import EditError
from tracking.formats.label_text import key_beside, key_of, line
from tracking.tracks import (
    LONGEST_KEY,
    LONGEST_NAME,
    LONGEST_VALUE,
    MOST_ATTRIBUTES,
    NO,
    YES,
    Attribute,
    AttributeType,
    Schema,
    as_stored,
    check_attribute,
)
from tracking.tracks.attribute_schema import number_text
from tracking.translation import Message, msg, some_of

TRACK_ID = "track_id"
"""The attribute that keeps an id on its way through CVAT, which numbers tracks anew."""
NAME = "name"
OWN_KEYS = frozenset({TRACK_ID, NAME})
"""Of attributes that are written of every track: those of people that are called so get a `_`."""

_TYPES = {
    "select": AttributeType.CHOICE,
    "radio": AttributeType.CHOICE,
    "checkbox": AttributeType.YES_NO,
    "number": AttributeType.NUMBER,
    "text": AttributeType.TEXT,
}
_INPUTS = {
    AttributeType.CHOICE: "select",
    AttributeType.YES_NO: "checkbox",
    AttributeType.NUMBER: "number",
    AttributeType.TEXT: "text",
}
_AS_CVAT = {YES: "true", NO: "false"}
_LEAST, _MOST = "-1000000", "1000000"
"""CVAT wants numbers to have a range."""
_MOST_NOTES, _MOST_NAMED = 20, 6


def value_in_cvat(attribute: Attribute | None, value: str) -> str:
    """A value as CVAT writes it."""
    if attribute is not None and attribute.type is AttributeType.YES_NO:
        return _AS_CVAT.get(value, value)
    return value


def label_in_cvat(schema: Schema, further: Iterable[str] = ()) -> list[dict[str, Any]]:
    """The attributes of a label as the label constructor has them, those of every track first.

    further: names of attributes that are not in the schema.
    """
    own = [{**_in_cvat(Attribute(name)), "name": name} for name in (TRACK_ID, NAME)]
    others = (Attribute(name) for name in further)
    return [*own, *map(_in_cvat, (*schema, *others))]


def _in_cvat(attribute: Attribute) -> dict[str, Any]:
    return {
        "name": key_beside(OWN_KEYS, attribute.name),
        "mutable": False,
        "input_type": _INPUTS[attribute.type],
        "default_value": value_in_cvat(attribute, attribute.default),
        "values": _values_in_cvat(attribute),
    }


def _values_in_cvat(attribute: Attribute) -> list[str]:
    if attribute.type is AttributeType.CHOICE:
        return list(attribute.choices)
    if attribute.type is AttributeType.NUMBER:
        least, most, step = (
            usual if number is None else number_text(number)
            for number, usual in (
                (attribute.least, _LEAST),
                (attribute.most, _MOST),
                (attribute.step, "1"),
            )
        )
        return [least, most, step]
    return ["false"] if attribute.type is AttributeType.YES_NO else [""]


class CvatSchema:
    """Collects the attributes of a file's labels, and what of them cannot be taken.

    Attributes:
        notes: what the user should know, a line each.
    """

    def __init__(self) -> None:
        """Nothing is collected yet."""
        self._found: dict[str, Attribute] = {}
        self._notes: dict[Message, None] = {}
        self._left_out: dict[str, None] = {}

    def add(self, said: Mapping[str, Any]) -> None:
        """Take an attribute of a label, as the label constructor has it; texts may be anything."""
        written = line(_text(said.get("name")))
        if not written or written in OWN_KEYS:
            return
        name = key_of(OWN_KEYS, written)
        attribute = self._attribute(name, said)
        known = self._found.get(name)
        if attribute is None or known == attribute:
            return
        if known is not None:
            self._note(
                msg("labels differ in their attribute {name}: the first is taken", name=name)
            )
        elif len(self._found) == MOST_ATTRIBUTES:
            self._left_out[name] = None
        else:
            self._found[name] = attribute

    @property
    def notes(self) -> tuple[Message, ...]:
        """What cannot be taken as it is."""
        left = list(self._left_out)
        more = msg("too many attributes: {names} are left out", names=some_of(left, _MOST_NAMED))
        return (*self._notes, *((more,) if left else ()))

    @property
    def schema(self) -> Schema:
        """The attributes of all labels; none where each is free text, as attributes are anyway."""
        found = tuple(self._found.values())
        return () if all(one == Attribute(one.name) for one in found) else found

    @property
    def by_name(self) -> Mapping[str, Attribute]:
        """All of them."""
        return self._found

    def _note(self, note: Message) -> None:
        if len(self._notes) < _MOST_NOTES:
            self._notes[note] = None

    def _attribute(self, name: str, said: Mapping[str, Any]) -> Attribute | None:
        """What it is here; None, and a note, where it can be nothing."""
        kind = _TYPES.get(_text(said.get("input_type", "text")).strip().lower())
        values = said.get("values")
        values = [line(_text(one), LONGEST_NAME) for one in _list(values)[: 8 * LONGEST_NAME]]
        try:
            if kind is None:
                raise EditError("its input type is unknown")
            attribute = _made(name, kind, values)
            check_attribute(attribute)
        except EditError as error:
            self._note(
                msg(
                    "attribute {name} is not taken into the schema: {why}",
                    name=name,
                    why=error.message,
                )
            )
            return None
        default = as_stored(attribute, _text(said.get("default_value"))[:LONGEST_VALUE])
        with_default = replace(attribute, default=default)
        try:
            check_attribute(with_default)
        except EditError:
            self._note(
                msg(
                    "the default {default!r} of attribute {name} does not suit it and is left out",
                    default=default[:LONGEST_KEY],
                    name=name,
                )
            )
            return attribute
        return with_default


def _made(name: str, kind: AttributeType, values: Sequence[str]) -> Attribute:
    if kind is AttributeType.CHOICE:
        return Attribute(name, kind, tuple(dict.fromkeys(filter(None, values))))
    if kind is AttributeType.NUMBER:
        least, most, step = (_number(values, at) for at in range(3))
        if (values[:2]) == [_LEAST, _MOST]:
            least = most = None
        if step is not None and step <= 0:
            step = None
        return Attribute(name, kind, least=least, most=most, step=step)
    return Attribute(name, kind)


def _number(values: Sequence[str], at: int) -> float | None:
    try:
        return float(values[at])
    except (IndexError, ValueError):
        return None


def _list(values: Any) -> list[Any]:
    if isinstance(values, str):
        return values.split("\n")
    return list(values) if isinstance(values, list) else []


def _text(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return str(value) if isinstance(value, str | int | float) else ""
