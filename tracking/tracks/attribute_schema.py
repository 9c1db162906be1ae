"""Which attributes people have: their names, types, choices and defaults.

A schema belongs to a session. Attributes themselves are text (`TrackLabel.attributes`); the schema
says what text suits. A default is what to assume where nothing is said: it is shown, never stored.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum

from tracking.translation import Message, msg, some_of

MOST_ATTRIBUTES, MOST_CHOICES = 64, 200
"""Of a schema; of one attribute."""
YES, NO = "yes", "no"
"""What is stored of an attribute that holds or not."""
RESERVED = "class"
"""The attribute that says what kind of thing a track is."""
_MOST_NAMED = 6
LARGEST_VALUE = 1e12
_CLOSE = 1e-6
"""Of a step: numbers are typed as decimals, which are no exact multiples."""
_YES, _NO = frozenset({"yes", "true", "1"}), frozenset({"no", "false", "0"})


class AttributeType(StrEnum):
    """What values an attribute has."""

    CHOICE = "choice"
    YES_NO = "yes-no"
    NUMBER = "number"
    TEXT = "text"


@dataclass(frozen=True, slots=True)
class Attribute:
    """One attribute of people.

    Attributes:
        name: a line of text, unique in its schema.
        type: of its values.
        choices: what may be chosen, in the order of the digit keys; of a choice alone.
        default: what to assume where nothing is said; "": nothing.
        required: everybody has to have a value.
        least, most, step: of a number; None: any. Numbers go in steps from `least`, else from 0.
    """

    name: str
    type: AttributeType = AttributeType.TEXT
    choices: tuple[str, ...] = ()
    default: str = ""
    required: bool = False
    least: float | None = None
    most: float | None = None
    step: float | None = None

    @property
    def options(self) -> tuple[str, ...]:
        """The values that can be chosen among; none of numbers and text."""
        return (YES, NO) if self.type is AttributeType.YES_NO else self.choices


Schema = tuple[Attribute, ...]
"""The attributes in the order in which they are shown."""


def attribute_named(schema: Schema, name: str) -> Attribute | None:
    """The attribute of that name."""
    return next((one for one in schema if one.name == name), None)


def as_stored(attribute: Attribute, value: str) -> str:
    """A value as it is stored: `true` and `1` are yes, `2.50` is 2.5; others stay as they are."""
    text = value.strip()
    if attribute.type is AttributeType.YES_NO:
        low = text.lower()
        return YES if low in _YES else NO if low in _NO else value
    if attribute.type is AttributeType.NUMBER:
        number = _number(text)
        return value if number is None else number_text(number)
    return text if attribute.type is AttributeType.CHOICE else value


def why_unfit(attribute: Attribute, value: str) -> Message | None:
    """Why a value does not suit its attribute; None where it does."""
    if attribute.type is AttributeType.NUMBER:
        return _why_no_number(attribute, value)
    if attribute.type is not AttributeType.TEXT and value not in attribute.options:
        return msg("it is one of: {options}", options=some_of(attribute.options, _MOST_NAMED))
    return None


def _why_no_number(attribute: Attribute, value: str) -> Message | None:
    number = _number(value)
    if number is None:
        return msg("it is a number")
    least, most, step = attribute.least, attribute.most, attribute.step
    if least is not None and number < least:
        return msg("it is at least {least}", least=number_text(least))
    if most is not None and number > most:
        return msg("it is at most {most}", most=number_text(most))
    if step is not None:
        steps = (number - (least or 0.0)) / step
        if abs(steps - round(steps)) > _CLOSE * max(1.0, abs(steps)):
            return msg("it goes in steps of {step}", step=number_text(step))
    return None


def number_text(number: float) -> str:
    """A number as it is stored: its shortest decimal, without a dot where it is whole."""
    return str(int(number)) if number == int(number) else repr(number)


def _number(text: str) -> float | None:
    try:
        number = float(text)
    except ValueError:
        return None
    usual = text.isascii() and "_" not in text and math.isfinite(number)
    return number if usual and abs(number) <= LARGEST_VALUE else None
