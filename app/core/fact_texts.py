"""Facts of files and runs as people read them: the same words in commands and in the window."""

from __future__ import annotations

from typing import Any

from tracking.translation import joined, msg


def fact_text(value: Any) -> str:
    """A value in words, to be translated where it is shown."""
    if value is None or value == []:
        return "-"
    if isinstance(value, bool):
        return msg("yes") if value else msg("no")
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, dict):
        pairs = (
            msg("{name} {value}", name=name, value=fact_text(part)) for name, part in value.items()
        )
        return joined(", ", pairs)
    if isinstance(value, list):
        return joined("; ", map(fact_text, value))
    return value if isinstance(value, str) else str(value)


def setting_text(value: Any) -> str:
    """The same of a setting: a switch is on or off, as in the form of settings."""
    if isinstance(value, bool):
        return msg("on") if value else msg("off")
    return fact_text(value)
