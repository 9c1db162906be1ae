"""Words shown to people, in their language."""

from __future__ import annotations

from tracking.translation import (
    N_,
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
    "joined",
    "joined_text",
    "language_in_use",
    "some_of",
    "span_text",
    "strip_full_stop",
    "time_text",
    "tr",
    "use_language",
]


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
