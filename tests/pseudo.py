"""A made-up language: what it does not mark was not translated."""

from __future__ import annotations

import gettext

TRANSLATED = "\u27e6"
"""Begins every text in it."""


class Pseudo(gettext.NullTranslations):
    """Puts every text in brackets."""

    def gettext(self, message: str) -> str:
        return f"{TRANSLATED}{message}\u27e7"

    def ngettext(self, one: str, many: str, n: int) -> str:
        return self.gettext(one if n == 1 else many)
