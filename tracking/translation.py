"""Texts in the user's language: one mechanism for the window, the command line and the library.

English stands in the code and is what a catalogue is looked up by. Catalogues are gettext's, made
from the texts that `make messages` extracts.
"""

from __future__ import annotations

import gettext
from pathlib import Path
from typing import Final

import resources

CATALOGUES: Final = Path(resources.__file__).parent / "translations"
"""LANGUAGE/LC_MESSAGES/trackwright.mo, and the texts to translate, trackwright.pot."""
_DOMAIN = "trackwright"
_catalogue: gettext.NullTranslations = gettext.NullTranslations()


def use_language(language: str | None = None) -> None:
    """Show texts in a language, e.g. "ja".

    None: in the first one of LANGUAGE, LC_ALL, LC_MESSAGES and LANG that the environment names.
    Where there is no catalogue, texts stay English.
    """
    languages = None if language is None else [language]
    use_catalogue(gettext.translation(_DOMAIN, CATALOGUES, languages, fallback=True))


def use_catalogue(catalogue: gettext.NullTranslations | None) -> None:
    """Look texts up in a catalogue; None: show them in English."""
    global _catalogue
    _catalogue = catalogue or gettext.NullTranslations()


def tr(text: str, **values: object) -> str:
    """The text in the user's language, with its {named} places filled."""
    words = _catalogue.gettext(text) if text else text
    return words.format(**values) if values else words


def count_text(count: int, one: str, many: str, **values: object) -> str:
    """How many of something in words: `one` or `many` of them, with {n} for the number."""
    return _catalogue.ngettext(one, many, count).format(n=count, **values)


def N_(text: str) -> str:  # noqa: N802 - gettext's name
    """Marks a text that is translated later, where it is shown."""
    return text
