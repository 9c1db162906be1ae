"""A schema is checked where it comes in: from a person, a log, a session or another file.

Every check raises EditError in one line that names the attribute.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from tracking.errors import EditError
from tracking.tracks.attribute_schema import (
    LARGEST_VALUE,
    MOST_ATTRIBUTES,
    MOST_CHOICES,
    RESERVED,
    Attribute,
    AttributeType,
    Schema,
    number_text,
    why_unfit,
)
from tracking.tracks.limits import LONGEST_KEY, LONGEST_NAME, LONGEST_VALUE
from tracking.translation import Message, joined, msg, some_of

_MOST_NAMED = 6


def check_schema(schema: Schema) -> None:
    """Refuse a schema that nobody could use. Raises EditError, which names the attribute."""
    if len(schema) > MOST_ATTRIBUTES:
        raise EditError(
            "{count} attributes; at most {most}", count=len(schema), most=MOST_ATTRIBUTES
        )
    names: set[str] = set()
    for attribute in schema:
        check_attribute(attribute)
        if attribute.name in names:
            raise EditError(
                "two attributes are called {name}; rename one of them", name=attribute.name
            )
        names.add(attribute.name)


def check_attribute(attribute: Attribute) -> None:
    """Refuse an attribute without a name, with choices it cannot have, or an empty range."""
    _check_text(attribute.name, LONGEST_KEY, msg("an attribute's name"))
    what = msg("attribute {name}", name=attribute.name)
    if attribute.name == RESERVED:
        raise EditError(
            "{what}: this name says what kind of thing a track is; choose another", what=what
        )
    _check_choices(attribute, what)
    _check_range(attribute, what)
    if attribute.default:
        if len(attribute.default) > LONGEST_VALUE or not _is_writable(attribute.default):
            raise EditError(
                "{what}: its default is no text of at most {most} characters",
                what=what,
                most=LONGEST_VALUE,
            )
        why = why_unfit(attribute, attribute.default)
        if why is not None:
            raise EditError(
                "{what}: its default {default} does not suit it: {why}",
                what=what,
                default=attribute.default[:LONGEST_NAME],
                why=why,
            )


def _check_choices(attribute: Attribute, what: Message) -> None:
    choices = attribute.choices
    if attribute.type is not AttributeType.CHOICE:
        if choices:
            raise EditError("{what}: only a choice has choices; leave them out", what=what)
        return
    if not choices:
        raise EditError("{what}: a choice needs choices; add some", what=what)
    if len(choices) > MOST_CHOICES:
        raise EditError(
            "{what} has {count} choices; at most {most}",
            what=what,
            count=len(choices),
            most=MOST_CHOICES,
        )
    for choice in choices:
        _check_text(choice, LONGEST_NAME, msg("{what}: a choice", what=what))
    twice = [choice for at, choice in enumerate(choices) if choice in choices[:at]]
    if twice:
        raise EditError(
            "{what}: the choice {choice} stands there twice", what=what, choice=twice[0]
        )


def _check_range(attribute: Attribute, what: Message) -> None:
    least, most, step = attribute.least, attribute.most, attribute.step
    given = [number for number in (least, most, step) if number is not None]
    if not given:
        return
    if attribute.type is not AttributeType.NUMBER:
        raise EditError("{what}: only a number has a range or a step; leave it out", what=what)
    if not all(math.isfinite(number) and abs(number) <= LARGEST_VALUE for number in given):
        raise EditError("{what}: its range and step are finite numbers", what=what)
    if least is not None and most is not None and not least < most:
        raise EditError(
            "{what}: the range from {least} to {most} is empty",
            what=what,
            least=number_text(least),
            most=number_text(most),
        )
    if step is not None and not step > 0:
        raise EditError("{what}: a step above 0 is needed", what=what)


def _check_text(text: str, longest: int, what: Message) -> None:
    """A name is one line, without blanks at its ends, that a file can hold."""
    if not text.strip():
        raise EditError("{what} is empty; type one", what=what)
    if len(text) > longest or text != text.strip() or not text.isprintable():
        raise EditError(
            "{what} is no line of text of at most {most} characters: {text!r}",
            what=what,
            most=longest,
            text=text[:longest],
        )


def _is_writable(text: str) -> bool:
    return "\0" not in text and not any("\ud800" <= sign <= "\udfff" for sign in text)


# as plain values, for JSON and TOML

_KEYS = frozenset(
    {"name", "type", "choices", "default", "required", "least", "most", "step"},
)


def attribute_as_values(attribute: Attribute) -> dict[str, Any]:
    """An attribute as plain values, without what is usual; `attribute_from_values` reads them."""
    values: dict[str, Any] = {
        "name": attribute.name,
        "type": attribute.type.value,
        "choices": list(attribute.choices) or None,
        "default": attribute.default or None,
        "required": attribute.required or None,
        "least": attribute.least,
        "most": attribute.most,
        "step": attribute.step,
    }
    return {key: value for key, value in values.items() if value is not None}


def attribute_from_values(values: Any) -> Attribute:
    """The attribute that plain values say. Raises EditError for what is none."""
    if not isinstance(values, Mapping) or not isinstance(values.get("name"), str):
        raise EditError("an attribute is a table with a name")
    what = msg("attribute {name}", name=values["name"][:LONGEST_KEY])
    unknown = sorted(str(key)[:LONGEST_KEY] for key in values.keys() - _KEYS)
    if unknown:
        raise EditError(
            "{what}: {unknown} means nothing here; it has {known}",
            what=what,
            unknown=some_of(unknown, _MOST_NAMED),
            known=joined(", ", sorted(_KEYS)),
        )
    said = str(values.get("type", AttributeType.TEXT))
    if said not in set(AttributeType):
        raise EditError(
            "{what}: type {type!r} is unknown; choose one of: {types}",
            what=what,
            type=said[:LONGEST_KEY],
            types=joined(", ", [each.value for each in AttributeType]),
        )
    attribute = Attribute(
        values["name"],
        AttributeType(said),
        _texts(values.get("choices", ()), what),
        _typed(values.get("default", ""), str, "default", what),
        _typed(values.get("required", False), bool, "required", what),
        *(_optional_number(values.get(key), key, what) for key in ("least", "most", "step")),
    )
    check_attribute(attribute)
    return attribute


def schema_as_values(schema: Schema) -> list[dict[str, Any]]:
    """A schema as plain values, which `schema_from_values` reads."""
    return [attribute_as_values(attribute) for attribute in schema]


def schema_from_values(values: Any) -> Schema:
    """The schema that plain values say. Raises EditError for what is none."""
    if not isinstance(values, list | tuple) or len(values) > MOST_ATTRIBUTES:
        raise EditError("a schema is a list of at most {most} attributes", most=MOST_ATTRIBUTES)
    schema = tuple(attribute_from_values(one) for one in values)
    check_schema(schema)
    return schema


def _texts(values: Any, what: Message) -> tuple[str, ...]:
    if not isinstance(values, list | tuple) or not all(isinstance(one, str) for one in values):
        raise EditError("{what}: choices are a list of texts", what=what)
    return tuple(values)


def _typed(value: Any, kind: type, key: str, what: Message) -> Any:
    if type(value) is not kind:
        raise EditError("{what}: {key} has a wrong type", what=what, key=key)
    return value


def _optional_number(value: Any, key: str, what: Message) -> float | None:
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, int | float) or abs(value) > LARGEST_VALUE:
        raise EditError("{what}: {key} has a wrong type", what=what, key=key)
    return float(value)
