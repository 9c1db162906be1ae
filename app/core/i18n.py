"""Words shown to people, translatable although presenters know no Qt.

The program installs Qt's translator at start; without one, the English text is shown.
"""

from __future__ import annotations

from collections.abc import Callable

_translate: Callable[[str], str] | None = None


def use_translator(translate: Callable[[str], str] | None) -> None:
    """Let `translate` turn the English text into the user's language; None: English."""
    global _translate
    _translate = translate


def tr(text: str, **values: object) -> str:
    """The text in the user's language, with its {named} places filled."""
    words = _translate(text) if _translate is not None else text
    return words.format(**values) if values else words


def count_text(count: int, one: str, many: str, **values: object) -> str:
    """How many of something in words: `one` or `many` of them, with {n} for the number."""
    return tr(one if count == 1 else many, n=count, **values)


def strip_full_stop(text: str) -> str:
    """The text without a full stop at its end: to stand inside a sentence that has its own."""
    return text.rstrip().rstrip(".")


def time_text(seconds: float) -> str:
    """Minutes, seconds and hundredths, e.g. "00:41.70"; with hours where there are any."""
    hundredths = round(max(0.0, seconds) * 100)
    minutes, rest = divmod(hundredths, 6000)
    hours, minutes = divmod(minutes, 60)
    clock = f"{minutes:02d}:{rest // 100:02d}.{rest % 100:02d}"
    return f"{hours}:{clock}" if hours else clock


def span_text(first_s: float, last_s: float) -> str:
    """From the first to the last frame of a stretch, by their times; one time for a single one."""
    first, last = time_text(first_s), time_text(last_s)
    return first if first == last else tr("{first} to {last}", first=first, last=last)
