"""Messages as plain data, for JSON: in files, and between the programs of one session."""

from __future__ import annotations

from collections.abc import Mapping
from string import Formatter
from typing import Any, Final

from tracking.translation import Message

_LONGEST_TEMPLATE: Final = 2000
_LONGEST_SPEC: Final = 4
"""Of a number in a sentence, such as ".1f": a wider one would fill the memory."""
_DEEPEST: Final = 20


def message_data(message: str) -> dict[str, Any] | str:
    """A message as what JSON holds; a text that is none as itself."""
    if not isinstance(message, Message):
        return message
    data: dict[str, Any] = {"text": message.template}
    if message.many:
        data["many"] = message.many
    if message.values:
        data["values"] = {name: _plain(value) for name, value in message.values.items()}
    return data


def message_from(data: object, depth: int = 0) -> Message:
    """The message of data that nobody vouches for. Raises ValueError where it holds none."""
    if isinstance(data, str):
        return Message("{text}", text=data)
    if not isinstance(data, Mapping) or depth > _DEEPEST:
        raise ValueError("a message is a text, or a text with values")
    text, many, values = data.get("text"), data.get("many", ""), data.get("values", {})
    if not isinstance(values, Mapping):
        raise ValueError("the values of a message have no names")
    known = {str(name): _value(value, depth) for name, value in values.items()}
    for template in (text, many):
        if known or many:
            _check_template(template, known)
        elif not isinstance(template, str):
            raise ValueError("a message without a text")
    try:
        return Message(str(text), str(many), **known)
    except LookupError as why:
        raise ValueError("a message lacks a value") from why


def _plain(value: object) -> object:
    if isinstance(value, Message):
        return message_data(value)
    if hasattr(value, "item"):  # a number of NumPy's
        value = value.item()
    return value if isinstance(value, str | int | float) else str(value)


def _value(value: object, depth: int) -> object:
    if isinstance(value, str | int | float):
        return value
    return message_from(value, depth + 1)


def _check_template(template: object, values: Mapping[str, object]) -> None:
    """Raise ValueError where more than plain values would be put in, or a place has no value."""
    if not isinstance(template, str) or len(template) > _LONGEST_TEMPLATE:
        raise ValueError("a message without a text")
    for _, name, spec, _ in Formatter().parse(template):
        if name is None:
            continue
        if name not in values or not name.isidentifier():
            raise ValueError("a message with a place that has no value")
        if len(spec or "") > _LONGEST_SPEC or "{" in (spec or ""):
            raise ValueError("a message with a value that is not written plainly")
