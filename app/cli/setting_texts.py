"""Settings as typed: KEY=VALUE."""

from __future__ import annotations

from collections.abc import Sequence

from tracking.errors import SettingsError


def pairs_of(texts: Sequence[str]) -> dict[str, str]:
    """KEY=VALUE texts as a mapping; raises SettingsError."""
    pairs: dict[str, str] = {}
    for text in texts:
        name, sign, value = text.partition("=")
        if not sign or not name.strip():
            raise SettingsError(
                "setting {text!r} is not KEY=VALUE, e.g. --set particles=700", text=text
            )
        if (name := name.strip()) in pairs:
            raise SettingsError(
                "setting {name} is given twice, as {first} and {value}: give it once",
                name=name,
                first=pairs[name],
                value=value,
            )
        pairs[name] = value
    return pairs
