"""Messages as plain data, for JSON: in files, and between the programs of one session."""

from __future__ import annotations

import contextlib
import json
import math
from collections.abc import Mapping
from string import Formatter
from typing import Any, Final

from tracking.translation import Message

_LONGEST_TEMPLATE: Final = 2000
_LONGEST_SPEC: Final = 4
"""Of a number in a sentence, such as ".1f": a wider one would fill the memory."""
_DEEPEST: Final = 20
_LONGEST_SENTENCE: Final = 100_000
"""A few templates within each other, each of them several times, would fill the memory."""
_NUMBER: Final = "number"
_NOT_FINITE: Final = ("nan", "inf", "-inf")
"""Numbers that JSON does not hold, and places such as {x:.1f} want as numbers."""
_LONGEST_KEPT: Final = 4000
"""Characters of a sentence of a log, and of its values as data: edits tell of less."""


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
        message = Message(str(text), str(many), **known)
    except LookupError as why:
        raise ValueError("a message lacks a value") from why
    if len(message) > _LONGEST_SENTENCE:
        raise ValueError("a message that is longer than any real one")
    return message


def kept_values(message: str) -> str:
    """What a log keeps of a message beside its English sentence, as JSON; "" where that is all."""
    if not isinstance(message, Message) or not message.values:
        return ""
    data = json.dumps(message_data(message), separators=(",", ":"))
    return data if len(data) <= _LONGEST_KEPT else ""


def kept_message(sentence: str, values: str) -> Message:
    """The message of a line of a log: see `kept_values`.

    The sentence alone where an older program kept no more, and where the values are damaged or
    say anything else than the sentence does.
    """
    if 0 < len(values) <= _LONGEST_KEPT:
        with contextlib.suppress(ValueError, RecursionError):
            message = message_from(json.loads(values))
            if message == sentence:
                return message
    return Message(sentence)


def _plain(value: object) -> object:
    if isinstance(value, Message):
        return message_data(value)
    if hasattr(value, "item"):  # a number of NumPy's
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        return {_NUMBER: str(value)}
    return value if isinstance(value, str | int | float) else str(value)


def _value(value: object, depth: int) -> object:
    if isinstance(value, str | int | float):
        return value
    if isinstance(value, Mapping) and value.get(_NUMBER) in _NOT_FINITE:
        return float(value[_NUMBER])
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
