"""Tables of a TOML that nobody vouches for: each value is what it must be, or refused in a line."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from tracking.errors import FormatError

_LONGEST_NAME = 100


class TomlTable:
    """The table of a TOML, read strictly.

    Args:
        path: of the TOML, for messages. table: what it says. within: the name of the table, with a
            dot behind it; "": the whole file.
    """

    def __init__(self, path: Path, table: Mapping[str, Any], within: str = "") -> None:
        self.path, self.table, self._within = path, table, within

    def wrong(self, key: str, expected: str) -> FormatError:
        """An error that says what a key must be."""
        return FormatError(
            "{path}: {key} must be {expected}",
            path=self.path,
            key=self._within + key,
            expected=expected,
        )

    def refuse_unknown(self, known: frozenset[str]) -> None:
        """Refuse keys that nothing reads: a misspelt one would be ignored."""
        for key in self.table.keys() - known:
            raise FormatError(
                "{path}: {key} is no key of a network; docs/networks.md lists them",
                path=self.path,
                key=self._within + key[:_LONGEST_NAME],
            )

    def value(self, key: str) -> Any:
        """What a key says. Raises FormatError where it is missing."""
        if key not in self.table:
            raise FormatError(
                "{path}: {key} is missing; docs/networks.md says what it is",
                path=self.path,
                key=self._within + key,
            )
        return self.table[key]

    def text(self, key: str, otherwise: str | None = None) -> str:
        """A short text of one line."""
        value = self.value(key) if otherwise is None else self.table.get(key, otherwise)
        if not isinstance(value, str) or len(value) > _LONGEST_NAME or not value.isprintable():
            raise self.wrong(key, f"a text of at most {_LONGEST_NAME} characters")
        if not value.strip() and otherwise is None:
            raise self.wrong(key, "a text")
        return value.strip()

    def word(self, key: str, words: tuple[str, ...]) -> str:
        """One of some words."""
        value = self.value(key)
        if value not in words:
            raise self.wrong(key, " or ".join(words))
        return str(value)

    def yes(self, key: str) -> bool:
        """Whether it is true."""
        value = self.value(key)
        if not isinstance(value, bool):
            raise self.wrong(key, "true or false")
        return value

    def number(self, key: str, low: float, high: float) -> float:
        """A number of a range."""
        return self._number(key, self.value(key), low, high, f"a number from {low:g} to {high:g}")

    def numbers(self, key: str, count: int, low: float, high: float) -> tuple[float, ...]:
        """So many numbers of a range."""
        expected = f"{count} numbers from {low:g} to {high:g}"
        value = self.value(key)
        if not isinstance(value, list) or len(value) != count:
            raise self.wrong(key, expected)
        return tuple(self._number(key, each, low, high, expected) for each in value)

    def _number(self, key: str, value: Any, low: float, high: float, expected: str) -> float:
        known = isinstance(value, int | float) and not isinstance(value, bool)
        if not known or not math.isfinite(value) or not low <= value <= high:
            raise self.wrong(key, expected)
        return float(value)

    def outputs(self, known: Sequence[str]) -> dict[str, str]:
        """The names of outputs, of those that are known, as fields of `NetworkSpec`."""
        table = self.table.get("outputs", {})
        if not isinstance(table, dict) or table.keys() - set(known):
            raise self.wrong("outputs", "a table of {}".format(", ".join(known)))
        names = TomlTable(self.path, table, f"{self._within}outputs.")
        return {f"{key}_output": names.text(key) for key in table}

    def size(self, low: float, high: float) -> tuple[int, int]:
        """Width and height in whole px."""
        width, height = self.numbers("size", 2, low, high)
        if not (width.is_integer() and height.is_integer()):
            raise self.wrong("size", "[width, height] in whole px")
        return int(width), int(height)
