"""Words shown to people, in their language."""

from __future__ import annotations

import re
from collections.abc import Mapping
from datetime import datetime

from tracking.translation import (
    N_,
    Message,
    count_text,
    joined,
    joined_text,
    language_in_use,
    some_of,
    tr,
    use_language,
)

__all__ = [
    "N_",
    "count_text",
    "date_text",
    "joined",
    "joined_text",
    "language_in_use",
    "sentence",
    "some_of",
    "span_text",
    "strip_full_stop",
    "time_text",
    "tr",
    "use_language",
]


_FIRST_VALUE = re.compile(r"\{(\w+)\}")
_FULL_STOPS = ".\N{IDEOGRAPHIC FULL STOP}"
_ENDS = (*_FULL_STOPS, "!", "?", ":", *"\N{FULLWIDTH EXCLAMATION MARK}\N{FULLWIDTH QUESTION MARK}")


def sentence(text: str) -> str:
    """A text or a message as a sentence of its own, in the user's language.

    It begins with a capital, unless a name of a file or of a person begins it, and has a full
    stop. What is a message is to come as one: in a plain text names cannot be told from words.
    """
    shown = _begun(text)
    return shown if not shown or shown.endswith(_ENDS) else tr("{text}.", text=shown)


def _begun(text: str) -> str:
    if not isinstance(text, Message):
        return _capital(tr(text))
    first = _FIRST_VALUE.match(text.template)
    inner = text.values.get(first[1]) if first is not None else None
    if first is not None and isinstance(inner, Message):
        values = {**text.values, first[1]: _begun(inner)}
        text = Message(text.template, text.many, **values)
    return text.translated(_filled_with_capital)


def _filled_with_capital(template: str, values: Mapping[str, object]) -> str:
    begun = _capital(template)
    return begun.format(**values) if values else begun


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def strip_full_stop(text: str) -> str:
    """The text without a full stop at its end: to stand inside a sentence that has its own."""
    return text.rstrip().rstrip(_FULL_STOPS)


def time_text(seconds: float) -> str:
    """Minutes, seconds and hundredths, e.g. "00:41.70"; with hours where there are any."""
    hundredths = round(max(0.0, seconds) * 100)
    minutes, rest = divmod(hundredths, 6000)
    hours, minutes = divmod(minutes, 60)
    clock = f"{minutes:02d}:{rest // 100:02d}.{rest % 100:02d}"
    return f"{hours}:{clock}" if hours else clock


def date_text(moment: datetime) -> str:
    """The day as it is written in the user's language, year first, e.g. "2026-05-31"."""
    return tr("{year}-{month}-{day}", year=moment.year, month=f"{moment:%m}", day=f"{moment:%d}")


def span_text(first_s: float, last_s: float) -> str:
    """From the first to the last frame of a stretch, by their times; one time for a single one."""
    first, last = time_text(first_s), time_text(last_s)
    return first if first == last else tr("{first} to {last}", first=first, last=last)
