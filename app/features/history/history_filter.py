"""Narrowing the history down: by who, by what kind of edit, by words and track ids."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from app.core.scenes import HistoryItem


@dataclass(frozen=True, slots=True)
class HistoryFilter:
    """Which edits are listed; by default all.

    Attributes:
        text: words that all stand in the edit's line, its author, kind or time; a number among
            them is a whole number there, such as a track's id.
        author, kind: exactly these; "" for any.
    """

    text: str = ""
    author: str = ""
    kind: str = ""

    @property
    def is_open(self) -> bool:
        """Whether nothing is left out."""
        return not (self.text.strip() or self.author or self.kind)

    def of(self, items: Sequence[HistoryItem]) -> tuple[HistoryItem, ...]:
        """The edits that are listed, in their order."""
        if self.is_open:
            return tuple(items)
        words = [_pattern(word) for word in self.text.split()]
        return tuple(
            item
            for item in items
            if (not self.author or item.author == self.author)
            and (not self.kind or item.kind == self.kind)
            and all(word.search(_line(item)) for word in words)
        )


def _pattern(word: str) -> re.Pattern[str]:
    plain = re.escape(word)
    return re.compile(rf"(?<!\d){plain}(?!\d)" if word.isdigit() else plain, re.IGNORECASE)


def _line(item: HistoryItem) -> str:
    return f"{item.text} {item.author} {item.kind} {item.when}"
