"""A made-up language: what it does not mark was not translated."""

from __future__ import annotations

import gettext
import re

TRANSLATED = "\u27e6"
"""Begins every text in it."""
_PLACES = re.compile(r"\{\w+[^}]*\}")


class Pseudo(gettext.NullTranslations):
    """Puts every text with words of its own in brackets; commas between names are none."""

    def gettext(self, message: str) -> str:
        has_words = any(map(str.isalpha, _PLACES.sub("", message)))
        return f"{TRANSLATED}{message}\u27e7" if has_words else message

    def ngettext(self, one: str, many: str, n: int) -> str:
        return self.gettext(one if n == 1 else many)
