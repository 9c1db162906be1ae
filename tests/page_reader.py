"""What people see or hear of a page, and which words of it stay English in another language."""

from __future__ import annotations

import re
from collections.abc import Iterable
from html.parser import HTMLParser

from tests.pseudo import Wide

WORD = re.compile(r"[A-Za-z]{3,}")


class Portuguese(Wide):
    """A language with a name."""

    def info(self) -> dict[str, str]:
        """Its header."""
        return {"language": "pt_BR"}


class Reader(HTMLParser):
    """What people see of a page, or hear."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.said: list[str] = []
        self.language = ""
        self._in_style = False
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._in_style = tag == "style"
        spoken = dict(attrs)
        self.language = spoken.get("lang") or self.language
        self.said += [spoken.get(name) or "" for name in ("alt", "aria-label", "title")]

    def handle_endtag(self, tag: str) -> None:
        self._in_style = self._in_style and tag != "style"

    def handle_data(self, data: str) -> None:
        self.said += [] if self._in_style else [data]


def english(said: Iterable[str], data: set[str]) -> set[str]:
    """Words that are neither translated nor data."""
    return {word for text in said for word in WORD.findall(text)} - data
