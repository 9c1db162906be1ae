"""Tables of recording.toml, whose values are asked for by type; which keys they may have."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any

from tracking.errors import RecordingError
from tracking.translation import Message, msg

_LARGEST_WHOLE = 10**15
_KNOWN: Mapping[str, frozenset[str]] = {
    "": frozenset(
        (
            *("format", "name", "fps", "left", "right", "stereo", "depth"),
            *("calibration", "ground", "region"),
        )
    ),
    "left": frozenset(("source", "topic")),
    "right": frozenset(("source", "topic", "lag")),
    "depth": frozenset(("source", "topic", "scale")),
    "stereo": frozenset(("source", "layout", "first", "lag")),
    "calibration": frozenset(("file",)),
    "ground": frozenset(("height", "tilt", "roll", "R", "t")),
    "region": frozenset(("look", "mask")),
}
_KIND_NAMES: Mapping[type, str] = {
    int: msg("a whole number"),
    float: "a number",
    str: "a text",
    dict: "a table",
    list: "a list",
}


def read_toml(text: str, where: str) -> dict[str, Any]:
    """The content of a manifest's text; where: its path, for messages.

    Raises RecordingError where it is no TOML.
    """
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError) as error:
        raise RecordingError(
            "{where}: not readable as TOML ({error}); correct it there", where=where, error=error
        ) from error


class ManifestTable:
    """A TOML table whose values are asked for by type."""

    def __init__(self, values: Mapping[str, Any], where: str, section: str = "") -> None:
        self._values, self._where, self._section = values, where, section

    def __contains__(self, key: str) -> bool:
        return key in self._values

    def section(self, key: str) -> ManifestTable:
        """A table below this one."""
        return ManifestTable(self.get(key, dict, {}), self._where, key)

    def get(self, key: str, kind: type, default: Any) -> Any:
        """A value of the kind; `float` takes whole numbers as well."""
        value = self._values.get(key, default)
        if kind is float and type(value) is int and abs(value) < _LARGEST_WHOLE:
            value = float(value)
        if key in self._values and (type(value) is not kind):
            raise self.error(key, msg("must be {kind}", kind=_KIND_NAMES[kind]))
        return value

    def error(self, key: str, problem: str) -> RecordingError:
        """What is wrong with a key."""
        return RecordingError("{place} {problem}", place=self.place(key), problem=problem)

    def missing(self, key: str, advice: Message) -> RecordingError:
        """A key is not there: what to do, or which key of this table may be meant for it."""
        unknown = [one for one in self._values if one not in _KNOWN.get(self._section, ())]
        near = get_close_matches(key, unknown, 1)
        if near:
            advice = msg("is missing; {near!r} stands there: correct its spelling", near=near[0])
        return self.error(key, advice)

    def place(self, key: str) -> str:
        """Where a key stands, for messages."""
        return f"{self._where}: " + (f"[{self._section}] {key}" if self._section else key)


def unknown_keys(content: Mapping[str, Any]) -> tuple[str, ...]:
    """The keys that no manifest has, those of a table as "table.key"."""
    unknown = [key for key in content if key not in _KNOWN[""]]
    for section, values in content.items():
        if section in _KNOWN and isinstance(values, dict):
            unknown += [f"{section}.{key}" for key in values if key not in _KNOWN[section]]
    return tuple(unknown)
