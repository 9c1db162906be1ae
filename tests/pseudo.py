"""A made-up language: what it does not mark was not translated."""

from __future__ import annotations

import gettext
import re

TRANSLATED = "\u27e6"
"""Begins every text in it."""
_PLACES = re.compile(r"\{\w+[^}]*\}")
_PLACES_OR_REST = re.compile(rf"{_PLACES.pattern}|[^{{]+|{{")
_WIDER = ord("\uff21") - ord("A")
"""From a letter to its wide form."""


class Pseudo(gettext.NullTranslations):
    """Puts every text with words of its own in brackets; commas between names are none."""

    def gettext(self, message: str) -> str:
        has_words = any(map(str.isalpha, _PLACES.sub("", message)))
        return f"{TRANSLATED}{message}\u27e7" if has_words else message

    def ngettext(self, one: str, many: str, n: int) -> str:
        return self.gettext(one if n == 1 else many)


class Wide(gettext.NullTranslations):
    """Writes every letter of a text wide: narrow words were missed, or are values that are data."""

    def gettext(self, message: str) -> str:
        return "".join(
            piece if _PLACES.fullmatch(piece) else _widened(piece)
            for piece in _PLACES_OR_REST.findall(message)
        )

    def ngettext(self, one: str, many: str, n: int) -> str:
        return self.gettext(one if n == 1 else many)


class Longer(gettext.NullTranslations):
    """Makes every text half again as long, in words as long as its own."""

    def gettext(self, message: str) -> str:
        words = _PLACES.sub("", message)
        if not any(map(str.isalpha, words)):
            return message
        more = " ".join(re.findall(r"[^\W\d_]+", words))
        return f"{TRANSLATED}{message}{_half(more)}"

    def ngettext(self, one: str, many: str, n: int) -> str:
        return self.gettext(one if n == 1 else many)


def _half(words: str) -> str:
    """As many letters as half of the words have; short ones stand as one word."""
    wanted = max(1, round(len(words) / 2))
    piece = words[:wanted]
    return piece if len(piece) < 8 else f" {piece}"


def _widened(text: str) -> str:
    return "".join(
        chr(ord(sign) + _WIDER) if "!" < sign <= "~" and sign.isalpha() else sign for sign in text
    )
